// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// frame_time FOLDER [BOXES [CAMERA]]: what a frame costs, beside what its two images cost OpenCV.
//
// The bound is the time to decode a pair and to extract 2,000 of OpenCV's ORB corners from each
// image, which no ORB-based stereo odometry can avoid. All systems process the sequence in turn, in
// several rounds, so that a noisy machine disturbs them alike; the ratios are what to compare.
// BOXES: a file of detections, or the level of a scene ("good"); without, full is what static is.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <opencv2/features2d.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/run_files.h"
#include "experiments/runner/run_job.h"
#include "variants/registry.h"

namespace cvo {
namespace {

constexpr int kRounds = 5;
constexpr int kBoundFeatures = 2000;

struct Seconds {
  double cpu = 0.0;
  double wall = 0.0;
};

struct Cost {
  std::vector<double> cpu_ms, wall_ms;  // per frame, one element per round
};

Seconds ExtractWithOpenCv(const Sequence& sequence) {
  const double cpu_s = CpuSeconds();
  const auto start = std::chrono::steady_clock::now();
  const auto orb = cv::ORB::create(kBoundFeatures);
  for (const StereoPaths& pair : sequence.images) {
    for (const auto& path : {pair.left, pair.right}) {
      std::vector<cv::KeyPoint> corners;
      cv::Mat descriptors;
      orb->detectAndCompute(cv::imread(path.string(), cv::IMREAD_GRAYSCALE), cv::noArray(), corners,
                            descriptors);
    }
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  return {CpuSeconds() - cpu_s, wall.count()};
}

// Of the frames alone: checks and scores of a whole run cost the more the shorter it is.
Seconds RunVariant(const Sequence& sequence, const char* variant, int threads) {
  const VariantInfo& info = FindVariant(variant);
  const auto run = RunSequence(
      {.sequence = sequence, .variant = info, .options = info.defaults(), .threads = threads},
      nullptr, {});
  Require(run && run->status != RunStatus::kFailed, "frame_time: the run failed");
  return {run->cpu_s, run->wall_s};
}

int Main(int argc, char** argv) {
  if (argc < 2) ThrowError("frame_time", "no folder", "FOLDER [BOXES [CAMERA]]");
  SequenceRequest request{.folder = argv[1], .min_score = 0.0};
  if (argc > 2) request.detections_file = argv[2];
  if (argc > 3) request.detections_camera = std::stoi(argv[3]);
  const Sequence sequence = OpenSequence(request);
  cv::setNumThreads(1);
  struct System {
    std::string name;
    std::function<Seconds()> process;
    Cost cost = {};
  };
  std::vector<System> systems = {{"bound", [&] { return ExtractWithOpenCv(sequence); }}};
  for (const char* variant : {"static", "full", "paper"}) {
    for (const int threads : {1, 2}) {
      systems.push_back(
          {StrCat(variant, ", ", Counted(static_cast<std::size_t>(threads), "thread")),
           [&sequence, variant, threads] { return RunVariant(sequence, variant, threads); }});
    }
  }
  const double ms_per_frame = 1e3 / static_cast<double>(sequence.images.size());
  for (int round = 0; round < kRounds; ++round) {
    for (System& system : systems) {
      const Seconds taken = system.process();
      system.cost.cpu_ms.push_back(ms_per_frame * taken.cpu);
      system.cost.wall_ms.push_back(ms_per_frame * taken.wall);
    }
  }
  std::printf("%s: %zu frames, medians of %d rounds\n", sequence.name.c_str(),
              sequence.images.size(), kRounds);
  std::printf("%-18s %10s %10s %12s\n", "", "CPU [ms]", "wall [ms]", "CPU / bound");
  for (const System& system : systems) {
    std::vector<double> ratios;
    for (int round = 0; round < kRounds; ++round) {
      ratios.push_back(system.cost.cpu_ms[round] / systems[0].cost.cpu_ms[round]);
    }
    std::printf("%-18s %10.1f %10.1f %12.2f\n", system.name.c_str(), Median(system.cost.cpu_ms),
                Median(system.cost.wall_ms), Median(ratios));
  }
  return 0;
}

}  // namespace
}  // namespace cvo

int main(int argc, char** argv) {
  try {
    return cvo::Main(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "frame_time: error: %s\n", error.what());
    return 2;
  }
}
