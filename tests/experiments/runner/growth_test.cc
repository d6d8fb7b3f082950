// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests how much memory a run retains per frame.
#include <gtest/gtest.h>
#include <malloc.h>

#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/interface/odometry.h"
#include "experiments/jobs/child_process.h"
#include "experiments/runner/run_job.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/support/temp_folder.h"
#include "variants/registry.h"

namespace cvo::growth_test {
namespace {

double Held_bytes() {
  const struct mallinfo2 info = ::mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

constexpr std::size_t kFull = 60;  // frames until the window is full
constexpr std::size_t kFrames = 240;
// 1 MB per 1,000 frames.
constexpr double kMost_bytes = 1e3;

constexpr int kBodies = 4;

// Reports kBodies clusters in every frame, and their poses as settled immediately.
class CrowdedOdometry : public Odometry {
 public:
  FrameReport Process(const StereoFrame& frame, StageTimes&) override {
    FrameReport report;
    report.status = FrameStatus::kTracked;
    for (int i = 1; i <= kBodies; ++i) {
      ClusterReport cluster;
      cluster.id = ClusterId{i};
      cluster.category = "Car";
      report.clusters.push_back(cluster);
      settled_.push_back({cluster.id, "Car", {{cluster, frames_, frame.timestamp_ns}}});
    }
    ++frames_;
    return report;
  }
  FrameReport Skip(std::int64_t) override { throw Error("CrowdedOdometry: no frame is skipped"); }
  std::vector<RigidTransform> Trajectory() const override {
    return std::vector<RigidTransform>(static_cast<std::size_t>(frames_));
  }
  std::vector<ClusterTrajectory> ClusterTrajectories() const override { return {}; }
  std::vector<ClusterTrajectory> TakeSettledPoses() override { return std::exchange(settled_, {}); }

 private:
  std::int64_t frames_ = 0;
  std::vector<ClusterTrajectory> settled_;
};

std::unique_ptr<Odometry> Make(const OdometrySetup&, TaskPool&) {
  return std::make_unique<CrowdedOdometry>();
}
Options Defaults() { return {}; }
const VariantInfo kCrowded{"crowded", "", &Defaults, &Make};

void RunFrames(const VariantInfo& variant, int frames,
               const std::function<void(std::size_t)>& progress) {
  const test::TempFolder folder;
  test::WriteTinySequence(folder.path() / "tiny", frames);
  std::string labels;
  for (int i = 0; i < frames; ++i) {
    labels += StrCat(i, " 0 Car 0 0 0 90 30 160 90 3 3 3 0 1.5 10 0\n");
  }
  const Sequence sequence = OpenSequence({.folder = folder.path() / "tiny",
                                          .type = "kitti-odometry",
                                          .labels_file = folder.Write("labels.txt", labels)});
  RunRequest request{.sequence = sequence, .variant = variant, .options = {}};
  request.options.orb.features = 150;
  request.landmarks = true;
  request.progress = progress;
  EXPECT_TRUE(RunJob(request, folder.path()).has_value());
}

// Live heap bytes that a run gains per frame, whatever the allocator makes of them.
double Growth_bytes(const VariantInfo& variant) {
  double full_bytes = 0.0;
  double end_bytes = 0.0;
  RunFrames(variant, kFrames, [&](std::size_t done) {
    if (done == kFull) full_bytes = Held_bytes();
    if (done == kFrames) end_bytes = Held_bytes();
  });
  return (end_bytes - full_bytes) / (kFrames - kFull);
}

// Anonymous resident memory of the process, without mapped files.
double Resident_mb() {
  std::ifstream status("/proc/self/status");
  std::string word;
  double kib = 0.0;
  while (status >> word && word != "RssAnon:") continue;
  status >> kib;
  return kib * 1.024e-3;
}

// Allocates 64 MB and frees half of them, in holes between live blocks.
std::vector<std::unique_ptr<char[]>> MakeHoles() {
  std::vector<std::unique_ptr<char[]>> blocks;
  for (int i = 0; i < 1'000; ++i) blocks.push_back(std::make_unique<char[]>(64'000));
  for (std::size_t i = 0; i < blocks.size(); i += 2) blocks[i].reset();
  return blocks;
}

// The rows of landmarks.csv alone would be many times the limit.
TEST(RunnerGrowth, KeepsLittlePerFrame) {
  if (!kLimitsMemory) GTEST_SKIP() << "the sanitizer counts otherwise";
  EXPECT_LT(Growth_bytes(FindVariant("static")), kMost_bytes);
}

TEST(RunnerGrowth, KeepsLittlePerBodyAndFrame) {
  if (!kLimitsMemory) GTEST_SKIP() << "the sanitizer counts otherwise";
  EXPECT_LT(Growth_bytes(kCrowded), kMost_bytes);
}

TEST(RunnerGrowth, ReturnsFreeMemoryBetweenLiveBlocks) {
  if (!kLimitsMemory) GTEST_SKIP() << "the sanitizer keeps what is freed";
  const auto blocks = MakeHoles();
  double begin_mb = 0.0;
  double end_mb = 0.0;
  RunFrames(kCrowded, kFull, [&](std::size_t done) {
    if (done == 1) begin_mb = Resident_mb();
    if (done == kFull) end_mb = Resident_mb();
  });
  EXPECT_LT(end_mb, begin_mb - 16.0);
}

}  // namespace
}  // namespace cvo::growth_test
