// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// What a run keeps of each frame while it goes on.
#include <gtest/gtest.h>
#include <malloc.h>

#include <string>

#include "core/base/error.h"
#include "experiments/jobs/child_process.h"
#include "experiments/runner/run_job.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/support/temp_folder.h"
#include "variants/registry.h"

namespace cvo {
namespace {

double Held_bytes() {
  const struct mallinfo2 info = ::mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

// The rows of landmarks.csv alone would be many times as much.
TEST(RunnerGrowth, OfAFrameLittleIsKept) {
  if (!kLimitsMemory) GTEST_SKIP() << "the sanitizer counts otherwise";
  constexpr std::size_t kFull = 40;  // frames until the window is
  constexpr std::size_t kFrames = 3 * kFull;
  const test::TempFolder folder;
  test::WriteTinySequence(folder.path() / "tiny", kFrames);
  std::string labels;
  for (std::size_t i = 0; i < kFrames; ++i) {
    labels += StrCat(i, " 0 Car 0 0 0 90 30 160 90 3 3 3 0 1.5 10 0\n");
  }
  const Sequence sequence = OpenSequence({.folder = folder.path() / "tiny",
                                          .type = "kitti-odometry",
                                          .labels_file = folder.Write("labels.txt", labels)});
  RunRequest request{.sequence = sequence, .variant = FindVariant("static"), .options = {}};
  request.options.orb.features = 300;
  request.landmarks = true;
  double full_bytes = 0.0;
  double end_bytes = 0.0;
  request.progress = [&](std::size_t done) {
    if (done == kFull) full_bytes = Held_bytes();
    if (done == kFrames) end_bytes = Held_bytes();
  };
  ASSERT_TRUE(RunJob(request, folder.path()).has_value());
  EXPECT_LT((end_bytes - full_bytes) / (kFrames - kFull), 4e3);
}

}  // namespace
}  // namespace cvo
