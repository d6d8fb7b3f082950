// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

#include "experiments/metrics/pose_errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/rng.h"
#include "core/geometry/stereo_camera.h"
#include "experiments/metrics/camera_metrics.h"
#include "tests/support/error_message.h"

namespace cvo::pose_errors_test {
namespace {

using testing::HasSubstr;

Eigen::Vector3d RandomVector(Rng& rng, double scale) {
  return scale * Eigen::Vector3d(rng.Normal(), rng.Normal(), rng.Normal());
}

RigidTransform RandomPose(Rng& rng) {
  return {ExpSo3(RandomVector(rng, 2.0)), RandomVector(rng, 5.0)};
}

// The same pose with the negated quaternion, which is the same rotation.
RigidTransform WithOtherSign(RigidTransform pose) {
  for (int k = 0; k < 4; ++k) pose.data()[k] = -pose.data()[k];
  return pose;
}

void Add(const RigidTransform& truth, const RigidTransform& estimate, CommonPoses& poses) {
  poses.frames.push_back(static_cast<int>(poses.frames.size()));
  poses.truth.push_back(truth);
  poses.estimate.push_back(estimate);
}

CommonPoses UnrelatedPoses(std::uint64_t seed, int frames) {
  Rng rng(seed, "poses");
  CommonPoses poses;
  for (int i = 0; i < frames; ++i) {
    const RigidTransform estimate = RandomPose(rng);
    Add(RandomPose(rng), i % 3 == 0 ? WithOtherSign(estimate) : estimate, poses);
  }
  return poses;
}

RelativeErrors ByDefinition(const CommonPoses& poses) {
  double rotation = 0.0;
  double translation = 0.0;
  std::int64_t pairs = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    for (std::size_t j = 0; j < poses.size(); ++j) {
      if (i == j) continue;
      const RigidTransform E = (poses.truth[i].Inverse() * poses.truth[j]).Inverse() *
                               (poses.estimate[i].Inverse() * poses.estimate[j]);
      rotation += std::pow(RotationAngle(Eigen::Quaterniond(E.rotation())), 2);
      translation += E.translation().squaredNorm();
      ++pairs;
    }
  }
  const auto n = static_cast<double>(pairs);
  return {std::sqrt(rotation / n), std::sqrt(translation / n), pairs};
}

// Covers rotations up to half a turn apart, and more poses than are summed in one block.
TEST(AllPairsErrors, MatchTheDefinitionForLargeErrors) {
  for (const int frames : {2, 3, 9, 40, 530}) {
    const CommonPoses poses = UnrelatedPoses(static_cast<std::uint64_t>(frames), frames);
    const RelativeErrors expected = ByDefinition(poses);
    const auto errors = AllPairsErrors(poses);
    ASSERT_TRUE(errors && errors->rotation_rad);
    EXPECT_NEAR(*errors->rotation_rad, *expected.rotation_rad, 1e-9) << frames;
    EXPECT_NEAR(errors->translation_m, expected.translation_m, 1e-9) << frames;
    EXPECT_EQ(errors->pairs, expected.pairs);
  }
}

// The estimate is 1 um off to alternating sides over a path of kilometres, in another world frame:
// half of the other poses are off to the opposite side, 2 um away.
TEST(AllPairsErrors, ArePreciseForSmallErrorsOnLongPaths) {
  constexpr int kPoses = 40;
  constexpr double kOff_m = 1e-6;
  const RigidTransform world(ExpSo3({1.0, -2.0, 0.5}), Eigen::Vector3d(10.0, -20.0, 30.0));
  CommonPoses poses;
  for (int i = 0; i < kPoses; ++i) {
    const Eigen::Quaterniond turned = ExpSo3({0.0, 0.1 * i, 0.0});
    const Eigen::Vector3d at(1000.0 * std::sin(0.1 * i), 100.0 * i, 1000.0 * std::cos(0.1 * i));
    const Eigen::Vector3d off(i % 2 == 0 ? kOff_m : -kOff_m, 0.0, 0.0);
    const RigidTransform estimate = world * RigidTransform(turned, Eigen::Vector3d(at + off));
    Add({turned, at}, i % 3 == 0 ? WithOtherSign(estimate) : estimate, poses);
  }
  const double expected_m = 2.0 * kOff_m * std::sqrt(0.5 * kPoses / (kPoses - 1.0));
  EXPECT_NEAR(AllPairsErrors(poses)->translation_m / expected_m, 1.0, 1e-4);
}

TEST(AllPairsErrors, OmitRotationsForTooManyPoses) {
  CommonPoses poses;
  for (std::size_t i = 0; i <= kMaxPairedRotations; ++i) {
    const double off_m = i % 2 == 0 ? 1.0 : -1.0;
    Add({}, {Eigen::Quaterniond::Identity(), Eigen::Vector3d(off_m, 0.0, 0.0)}, poses);
  }
  const auto errors = AllPairsErrors(poses);
  EXPECT_FALSE(errors->rotation_rad);
  EXPECT_NEAR(errors->translation_m, std::sqrt(2.0), 1e-4);
}

TEST(OneFrameErrors, EqualAllPairsErrorsForTwoFrames) {
  CommonPoses poses = UnrelatedPoses(4, 2);
  const RelativeErrors expected = ByDefinition(poses);  // E_ij and E_ji have equal norms
  const auto errors = OneFrameErrors(poses);
  EXPECT_NEAR(*errors->rotation_rad, *expected.rotation_rad, 1e-12);
  EXPECT_EQ(errors->pairs, 1);
  poses.frames[1] = 2;
  EXPECT_FALSE(OneFrameErrors(poses)) << "not consecutive";
  EXPECT_FALSE(MotionErrors(poses));
  EXPECT_FALSE(OneFrameErrors(UnrelatedPoses(4, 1)));
}

TEST(FindCommonPoses, NamesTheSideThatIsNotFinite) {
  const RigidTransform bad(Eigen::Quaterniond::Identity(),
                           Eigen::Vector3d(std::numeric_limits<double>::infinity(), 0, 0));
  EXPECT_THAT(ErrorMessage([&] {
                FindCommonPoses({RigidTransform(), bad}, {std::nullopt, std::nullopt});
              }),
              HasSubstr("truth of frame 1: found a pose that is not finite"));
  const RigidTransform good;
  const CommonPoses common =
      FindCommonPoses({std::nullopt, good, good, std::nullopt}, {good, std::nullopt, good, good});
  EXPECT_EQ(common.frames, std::vector<int>{2});
}

}  // namespace
}  // namespace cvo::pose_errors_test

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

}  // namespace
}  // namespace cvo::kitti_drift_test

namespace cvo::calibration_metrics_test {
namespace {

const Vector6d kTruth_px{{0.2, -0.01, 0.03, 0.02, 0.0, -0.05}};

CalibrationReport Estimate(const Vector6d& error_px) {
  return {kTruth_px + error_px, 1e4 * Matrix6d::Identity()};
}

TEST(EvaluateCalibration, ErrorIsTheRootMeanSquareOverTheImage) {
  StereoCamera camera;
  camera.width_px = 1242;
  camera.height_px = 375;
  const Vector6d error_px{{0.03, -0.02, 0.05, 0.04, -0.06, 0.01}};
  double squares = 0.0;
  for (int v = 0; v < camera.height_px; ++v) {
    for (int u = 0; u < camera.width_px; ++u) {
      squares += std::pow(error_px.dot(camera.BasisAt(u, v).value), 2);
    }
  }
  const auto metrics = EvaluateCalibration(kTruth_px, Estimate(error_px));
  ASSERT_EQ(metrics.size(), 2u);
  EXPECT_EQ(metrics[0].name, "calibration_error");
  EXPECT_NEAR(metrics[0].value, std::sqrt(squares / (camera.width_px * camera.height_px)), 1e-5);
}

TEST(EvaluateCalibration, NeesIsOneIfErrorsAreAsLargeAsClaimed) {
  CalibrationReport estimate = Estimate(Vector6d::Zero());
  const Vector6d sigma_px = estimate.Covariance_px2().diagonal().cwiseSqrt();
  estimate.right_field_px += sigma_px;
  EXPECT_NEAR(EvaluateCalibration(kTruth_px, estimate)[1].value, 1.0, 1e-9);
  estimate.right_field_px += sigma_px;
  EXPECT_NEAR(EvaluateCalibration(kTruth_px, estimate)[1].value, 4.0, 1e-9);
}

TEST(EvaluateCalibration, IsEmptyWithoutSelfCalibration) {
  EXPECT_TRUE(EvaluateCalibration(kTruth_px, {}).empty());
}

}  // namespace
}  // namespace cvo::calibration_metrics_test
