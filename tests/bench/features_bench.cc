// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <opencv2/core/utility.hpp>
#include <string>
#include <vector>

#include "core/features/descriptor.h"
#include "core/features/front_end.h"
#include "core/files/images/image_file.h"
#include "tests/core/features/scene.h"

namespace cvo {
namespace {

struct StereoImages {
  cv::Mat left;
  cv::Mat right;
};

// A synthetic image pair with a disparity of 20 px everywhere and camera-like noise.
const StereoImages& SyntheticPair() {
  static const StereoImages images = [] {
    const cv::Mat scene = test::DrawScene(1242, 375, 1);
    return StereoImages{test::Render(scene, 0, 2.0, 1),
                        test::Render(scene, 20 * test::kSubpixelSteps, 2.0, 2)};
  }();
  return images;
}

void ExtractPair(benchmark::State& state, const StereoImages& images) {
  std::size_t corners = 0;
  for (auto _ : state) corners = ExtractOrb(images.left, OrbOptions{}).keypoints.size();
  state.counters["corners"] = static_cast<double>(corners);
}

void MatchPair(benchmark::State& state, const StereoImages& images) {
  const OrbOptions orb;
  const StereoMatchOptions stereo;
  OrbOptions right_orb = orb;
  right_orb.features = static_cast<int>(orb.features * stereo.right_features);
  const OrbImage left = ExtractOrb(images.left, orb);
  const OrbImage right = ExtractOrb(images.right, right_orb);
  const StereoCamera camera = test::CameraFor(images.left);
  std::size_t features = 0;
  for (auto _ : state) features = MatchStereo(left, right, camera, orb, stereo).size();
  state.counters["features"] = static_cast<double>(features);
}

void FrontEndPair(benchmark::State& state, const StereoImages& images) {
  TaskPool pool(static_cast<int>(state.range(0)));
  const StereoCamera camera = test::CameraFor(images.left);
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        ExtractStereoFeatures(images.left, images.right, camera, {}, {}, pool));
  }
}

void RunHamming(benchmark::State& state, int (*distance)(const Descriptor&, const Descriptor&)) {
  Rng rng(1, "descriptors");
  std::vector<Descriptor> descriptors(1024);
  for (Descriptor& descriptor : descriptors) {
    for (std::uint64_t& word : descriptor) word = rng.NextU64();
  }
  for (auto _ : state) {
    int sum = 0;
    for (const Descriptor& descriptor : descriptors) sum += distance(descriptors[0], descriptor);
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(descriptors.size()));
}

void RegisterPair(const std::string& name, const StereoImages& images) {
  const auto add = [&](const char* what, auto run) {
    return benchmark::RegisterBenchmark((std::string(what) + "/" + name).c_str(), run, images)
        ->Unit(benchmark::kMillisecond);
  };
  add("ExtractOrb", ExtractPair);
  add("MatchStereo", MatchPair);
  add("ExtractStereoFeatures", FrontEndPair)->Arg(1)->Arg(2)->UseRealTime();
}

// Reads an image pair of KITTI's raw drive 0001 below the folder CLUSTERVO_DATA; empty images if it
// does not exist.
StereoImages RealPair() {
  const char* folder = std::getenv("CLUSTERVO_DATA");
  if (folder == nullptr) return {};
  const std::string drive =
      std::string(folder) + "/kitti_raw/2011_09_26/2011_09_26_drive_0001_sync";
  const std::string file = "/data/0000000050.png";
  return {ReadImageFile(drive + "/image_00" + file, cv::IMREAD_GRAYSCALE),
          ReadImageFile(drive + "/image_01" + file, cv::IMREAD_GRAYSCALE)};
}

}  // namespace
}  // namespace cvo

int main(int argc, char** argv) {
  cv::setNumThreads(1);
  benchmark::Initialize(&argc, argv);
  benchmark::RegisterBenchmark("HammingDistance", cvo::RunHamming, cvo::HammingDistance);
  benchmark::RegisterBenchmark("HammingDistance/plain", cvo::RunHamming, cvo::HammingDistancePlain);
  cvo::RegisterPair("synthetic", cvo::SyntheticPair());
  const cvo::StereoImages real = cvo::RealPair();
  if (!real.left.empty() && !real.right.empty()) cvo::RegisterPair("real", real);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
