// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <numbers>

#include "core/base/error.h"
#include "experiments/metrics/pose_errors.h"

namespace cvo::kitti_drift_test {
namespace {

// A path along z that turns about y by `rad_per_m` per frame, which is per metre at a step of 1 m.
OptionalPoses Path(int frames, double step_m, double rad_per_m = 0.0) {
  OptionalPoses poses;
  for (int i = 0; i < frames; ++i) {
    poses.emplace_back(RigidTransform(ExpSo3({0.0, rad_per_m * i, 0.0}), {0.0, 0.0, step_m * i}));
  }
  return poses;
}

// On 1000 frames at 1 m per frame, a sub-sequence of length L ends after L + 1 m, so the last one
// starts at 999 - (L + 1): 90, 80, ..., 20 starts.
TEST(KittiDrift, TakesEightLengthsFromEveryTenthFrame) {
  const auto drift = ComputeKittiDrift(Path(1000, 1.0), Path(1000, 1.01, 1e-5));
  ASSERT_TRUE(drift);
  EXPECT_EQ(drift->segments, 90 + 80 + 70 + 60 + 50 + 40 + 30 + 20);
  double rotation_rad_per_m = 0.0;
  for (int k = 1; k <= 8; ++k) {
    rotation_rad_per_m += (100.0 - 10.0 * k) * 1e-5 * (100.0 * k + 1.0) / (100.0 * k);
  }
  EXPECT_NEAR(drift->rotation_deg_per_100m,
              100.0 * rotation_rad_per_m / 440.0 * 180.0 / std::numbers::pi, 1e-9);
  EXPECT_EQ(drift->segments_without_estimate, 0);
}

TEST(KittiDrift, StraightPathHandComputed) {
  const auto drift = ComputeKittiDrift(Path(1000, 1.0), Path(1000, 1.01));
  double translation = 0.0;
  for (int k = 1; k <= 8; ++k) translation += (100.0 - 10.0 * k) * (1.0 + 0.01 / k);
  EXPECT_NEAR(drift->translation_percent, translation / 440.0, 1e-9);
}

// A sub-sequence with an estimate at only one end does not count.
TEST(KittiDrift, IsAbsentIfNoSubSequenceHasAnEstimate) {
  OptionalPoses start = Path(111, 1.0);
  OptionalPoses end = start;
  start[101].reset();
  end[0].reset();
  EXPECT_FALSE(ComputeKittiDrift(Path(111, 1.0), start));
  EXPECT_FALSE(ComputeKittiDrift(Path(111, 1.0), end));
  EXPECT_FALSE(ComputeKittiDrift(OptionalPoses(111), Path(111, 1.0)));
}

TEST(KittiDrift, RefusesLengthsThatDiffer) {
  EXPECT_THROW((void)ComputeKittiDrift(Path(111, 1.0), Path(110, 1.0)), Error);
}

}  // namespace
}  // namespace cvo::kitti_drift_test
