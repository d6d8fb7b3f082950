// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/max_drift.h"

#include <gtest/gtest.h>

#include <cmath>

#include "experiments/metrics/camera_metrics.h"

namespace cvo {
namespace {

constexpr int kFrames = 40;
constexpr int kWrong = 30;  // after the first 25

// A body that moves and turns, and what a system says of it: in a frame of its own, and wrong in
// one frame by half a metre along x and by turns of the true frame.
CommonPoses Poses(const RigidTransform& truth_from_estimate, const RigidTransform& error) {
  CommonPoses poses;
  for (int k = 0; k < kFrames; ++k) {
    const RigidTransform truth(ExpSo3({0.05 * k, 0.3 * std::sin(0.4 * k), 0.02 * k}),
                               Eigen::Vector3d(0.2 * k, std::cos(0.3 * k), 0.01 * k * k));
    poses.frames.push_back(k);
    poses.truth.push_back(truth);
    poses.estimate.push_back((k == kWrong ? truth * error : truth) * truth_from_estimate);
  }
  return poses;
}

const RigidTransform kNoError;
const RigidTransform kOwnFrame(ExpSo3({0.4, -0.9, 0.7}), Eigen::Vector3d(0.3, -0.2, 0.5));

class EveryProtocol : public testing::TestWithParam<DriftProtocol> {};
INSTANTIATE_TEST_SUITE_P(MaxDrift, EveryProtocol, testing::ValuesIn(kDriftProtocols));

TEST_P(EveryProtocol, TheFrameOfTheEstimateIsNoDrift) {
  const auto drift = MeasureMaxDrift(Poses(kOwnFrame, kNoError), GetParam());
  ASSERT_TRUE(drift);
  for (const double value : drift->Values()) EXPECT_LT(value, 1e-7);
}

TEST_P(EveryProtocol, FewerThanTwoPosesSayNothing) {
  EXPECT_FALSE(MeasureMaxDrift({{0}, {kNoError}, {kNoError}}, GetParam()));
}

TEST_P(EveryProtocol, TheLargestErrorCounts) {
  const auto drift = MeasureMaxDrift(
      Poses(kNoError, RigidTransform(ExpSo3({0.2, 0.0, 0.0}), Eigen::Vector3d(0.5, 0.0, 0.0))),
      GetParam());
  ASSERT_TRUE(drift);
  // One frame of 40 moves a registration over all frames by a little.
  EXPECT_NEAR(drift->roll_pitch_yaw_rad.norm(), 0.2, 0.02);
  EXPECT_GT(drift->translation_m, 0.4);
}

// By hand: registered by frames that are right, the error is what was put in.
TEST(MaxDrift, OfTheFirstFramesIsExact) {
  const RigidTransform error(ExpSo3({0.0, 0.0, 0.3}), Eigen::Vector3d(0.3, 0.4, 0.0));
  const CommonPoses poses = Poses(kOwnFrame, error);
  const auto drift = MeasureMaxDrift(poses, DriftProtocol::kFirstMotions);
  ASSERT_TRUE(drift);
  // E = T_est T_gt^-1 of the motions is the inverse of the error in the moving frame.
  const RigidTransform inverse = error.Inverse();
  EXPECT_NEAR(drift->translation_m, inverse.translation().norm(), 1e-6);
  EXPECT_NEAR(drift->roll_pitch_yaw_rad.z(), 0.3, 1e-6);
  EXPECT_NEAR(drift->roll_pitch_yaw_rad.x(), 0.0, 1e-6);
}

// Roll in one frame and yaw in another: ClusterVO's takes each, the tool those of one frame.
TEST(MaxDrift, AnglesAreEachAloneOrThoseOfOneFrame) {
  CommonPoses poses = Poses(kNoError, kNoError);
  poses.estimate[28] = poses.estimate[28] * RigidTransform(ExpSo3({0.2, 0.0, 0.0}), {0, 0, 0});
  poses.estimate[35] = poses.estimate[35] * RigidTransform(ExpSo3({0.0, 0.0, 0.3}), {0, 0, 0});
  const auto alone = MeasureMaxDrift(poses, DriftProtocol::kAllPoses);
  EXPECT_NEAR(alone->roll_pitch_yaw_rad.x(), 0.2, 0.02);
  EXPECT_NEAR(alone->roll_pitch_yaw_rad.z(), 0.3, 0.02);
  const auto together = MeasureMaxDrift(poses, DriftProtocol::kFirstMotions);
  EXPECT_NEAR(together->roll_pitch_yaw_rad.x(), 0.0, 1e-6);
  EXPECT_NEAR(together->roll_pitch_yaw_rad.z(), 0.3, 1e-6);
}

TEST(MaxDrift, OfTheCameraIsThatSinceItsFirstFrame) {
  const CommonPoses poses = Poses(kNoError, RigidTransform(ExpSo3({0, 0, 0}), {0.5, 0, 0}));
  const RigidTransform world(ExpSo3({0.1, 1.0, 0.2}), Eigen::Vector3d(5, 6, 7));
  OptionalPoses truth, estimate;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    truth.emplace_back(poses.truth[i]);
    estimate.emplace_back(world * poses.estimate[i]);
  }
  const auto metrics = EvaluateCamera(truth, estimate);
  const Metric* all = FindMetric(metrics, "camera_max_drift");
  const Metric* first = FindMetric(metrics, "camera_max_drift_first25");
  ASSERT_TRUE(all != nullptr && first != nullptr);
  EXPECT_NEAR(all->value, 0.5 * 39 / 40, 1e-9);
  EXPECT_NEAR(first->value, 0.5, 1e-6);
  EXPECT_EQ(all->contract.alignment, reports::Alignment::kAllPoses);
  EXPECT_EQ(first->contract.alignment, reports::Alignment::kFirstMotions);
  EXPECT_NE(FindMetric(metrics, "camera_max_drift_tool_yaw"), nullptr);
}

}  // namespace
}  // namespace cvo
