// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/rng.h"
#include "experiments/metrics/camera_metrics.h"

namespace cvo::max_drift_test {
namespace {

using Eigen::Vector3d;
using reports::MaxDrift;

constexpr std::size_t kFrames = 40;
constexpr std::size_t kWrong = 30;  // beyond the first 25
const RigidTransform kSame;

RigidTransform Turn(double x, double y, double z) { return {ExpSo3({x, y, z}), Vector3d::Zero()}; }

// True poses of a body that moves and turns, and an estimate without error.
CommonPoses RightPoses() {
  CommonPoses poses;
  for (std::size_t i = 0; i < kFrames; ++i) {
    const double t = static_cast<double>(i);
    poses.frames.push_back(static_cast<int>(i));
    poses.truth.emplace_back(ExpSo3({0.05 * t, 0.3 * std::sin(0.4 * t), 0.02 * t}),
                             Vector3d(0.2 * t, std::cos(0.3 * t), 0.01 * t * t));
  }
  poses.estimate = poses.truth;
  return poses;
}

CommonPoses Noisy(CommonPoses poses, double rotation_rad) {
  Rng rng(7, "noise");
  const auto random = [&rng](double scale) {
    return Vector3d(scale * Vector3d(rng.Normal(), rng.Normal(), rng.Normal()));
  };
  for (RigidTransform& pose : poses.estimate) {
    pose = pose * RigidTransform(ExpSo3(random(rotation_rad)), random(0.1));
  }
  return poses;
}

std::array<double, 12> Values(const CommonPoses& poses) {
  return MeasureMaxDrift(poses, kSame).value().Values();
}

// Expects that a change of the registration of noisy poses by `step` in any direction increases the
// squared errors.
void ExpectLeastSquares(double noise_rad, double step) {
  const CommonPoses poses = Noisy(RightPoses(), noise_rad);
  const RigidTransform found = AlignByMotions(poses, kFrames);
  const auto cost = [&](const RigidTransform& X) {
    double sum = 0.0;
    for (std::size_t i = 1; i < kFrames; ++i) {
      const RigidTransform error = X.Inverse() * poses.estimate[i].Inverse() * poses.estimate[0] *
                                   X * poses.truth[0].Inverse() * poses.truth[i];
      const double angle = RotationAngle(error.rotation());
      sum += angle * angle + error.translation().squaredNorm();
    }
    return sum;
  };
  for (int k = 0; k < 6; ++k) {
    for (const double signed_step : {-step, step}) {
      EXPECT_LT(cost(found), cost(found.Plus(signed_step * Vector6d::Unit(k))))
          << noise_rad << ", " << k;
    }
  }
}

TEST(MaxDrift, IsZeroForTheTruthInAnyFrame) {
  CommonPoses poses = RightPoses();
  for (RigidTransform& pose : poses.estimate) {
    pose = pose * RigidTransform(ExpSo3({0.4, -0.9, 0.7}), Vector3d(0.3, -0.2, 0.5));
  }
  for (const double value : Values(poses)) EXPECT_LT(value, 1e-9);
}

TEST(MaxDrift, DoesNotDependOnTheObjectFrameOfTheEstimate) {
  CommonPoses straight = RightPoses();
  for (RigidTransform& pose : straight.truth) pose = {kSame.rotation(), pose.translation()};
  straight.estimate = straight.truth;
  for (const CommonPoses& poses :
       {Noisy(RightPoses(), 0.1), Noisy(straight, 0.0), Noisy(straight, 0.02)}) {
    const auto expected = Values(poses);
    EXPECT_GT(expected[0], 0.1);
    for (const RigidTransform& frame :
         {RigidTransform(ExpSo3({0.4, -0.9, 0.7}), Vector3d(3.0, -2.0, 5.0)),
          RigidTransform(ExpSo3({-2.0, 1.0, 0.3}), Vector3d(-0.1, 8.0, 0.2))}) {
      CommonPoses other = poses;
      for (RigidTransform& pose : other.estimate) pose = pose * frame;
      const auto values = Values(other);
      for (std::size_t i = 0; i < values.size(); ++i) {
        EXPECT_NEAR(values[i], expected[i], 1e-9) << i;
      }
    }
  }
}

// Registration by motions finds a minimum of the squared errors: no X near it has smaller ones.
TEST(MaxDrift, RegistrationMinimisesTheSquaredErrors) { ExpectLeastSquares(0.1, 1e-3); }

TEST(MaxDrift, NeedsTwoPoses) {
  EXPECT_FALSE(MeasureMaxDrift({{0}, {kSame}, {kSame}}, kSame));
  EXPECT_FALSE(MeasureMaxDrift({}, kSame));
}

// Hand-computed: the first 25 frames are exact, so the drift is the error that was inserted.
TEST(MaxDrift, EqualsTheErrorIfRegisteredByExactFrames) {
  CommonPoses poses = RightPoses();
  poses.estimate[kWrong] =
      poses.estimate[kWrong] * RigidTransform(ExpSo3({0.0, 0.0, 0.3}), Vector3d(0.3, 0.4, 0.0));
  const auto drifts = MeasureMaxDrift(poses, kSame);
  EXPECT_NEAR(drifts->first_motions.translation_m, 0.5, 1e-9);
  EXPECT_NEAR(drifts->first_motions.yaw_rad, 0.3, 1e-9);
  EXPECT_NEAR(drifts->first_motions.roll_rad, 0.0, 1e-9);
  // One wrong frame of 40 slightly changes a registration over all frames.
  for (const MaxDrift& drift : {drifts->all_poses, drifts->all_motions}) {
    EXPECT_NEAR(drift.translation_m, 0.5, 0.1);
    EXPECT_NEAR(drift.yaw_rad, 0.3, 0.03);
  }
}

// A roll error in one frame and a yaw error in another: ClusterVO's drift takes the maximum of each
// angle, the others take the angles of one frame.
TEST(MaxDrift, AnglesAreSeparateMaximaOrThoseOfOneFrame) {
  CommonPoses poses = RightPoses();
  poses.estimate[28] = poses.estimate[28] * Turn(0.2, 0.0, 0.0);
  poses.estimate[35] = poses.estimate[35] * Turn(0.0, 0.0, 0.3);
  const auto drifts = MeasureMaxDrift(poses, kSame);
  EXPECT_NEAR(drifts->all_poses.roll_rad, 0.2, 0.02);
  EXPECT_NEAR(drifts->all_poses.yaw_rad, 0.3, 0.02);
  EXPECT_NEAR(drifts->first_motions.roll_rad, 0.0, 1e-9);
  EXPECT_NEAR(drifts->first_motions.yaw_rad, 0.3, 1e-9);
}

TEST(MaxDrift, OfTheCameraIsRelativeToItsFirstPose) {
  const RigidTransform world(ExpSo3({0.1, 1.0, 0.2}), Vector3d(5, 6, 7));
  const CommonPoses poses = RightPoses();
  OptionalPoses truth(poses.truth.begin(), poses.truth.end());
  OptionalPoses estimate;
  for (const RigidTransform& pose : poses.estimate) estimate.emplace_back(world * pose);
  *estimate[kWrong] = *estimate[kWrong] * RigidTransform(ExpSo3(Vector3d::Zero()), {0.5, 0, 0});
  const auto metrics = EvaluateCamera(truth, estimate);
  const Metric* all = FindMetric(metrics, "camera_max_drift");
  const Metric* first = FindMetric(metrics, "camera_max_drift_first25");
  ASSERT_TRUE(all != nullptr && first != nullptr);
  EXPECT_NEAR(all->value, 0.5 * 39 / 40, 1e-9);
  EXPECT_NEAR(first->value, 0.5, 1e-9);
  EXPECT_EQ(all->contract.alignment, reports::Alignment::kAllPoses);
  EXPECT_EQ(first->contract.alignment, reports::Alignment::kFirstMotions);
  EXPECT_EQ(FindMetric(metrics, "camera_max_drift_tool_yaw")->unit, reports::MetricUnit::kRadians);
}

// The drift is the inverse of the error that was inserted: yaw after pitch after roll. Signs do not
// count.
TEST(MaxDrift, AnglesAreRollPitchAndYaw) {
  for (const double sign : {-1.0, 1.0}) {
    CommonPoses poses = RightPoses();
    poses.estimate[kWrong] = poses.estimate[kWrong] * Turn(-0.1 * sign, 0, 0) *
                             Turn(0, 0.2 * sign, 0) * Turn(0, 0, -0.3 * sign);
    const MaxDrift drift = MeasureMaxDrift(poses, kSame)->first_motions;
    EXPECT_NEAR(drift.roll_rad, 0.1, 1e-9);
    EXPECT_NEAR(drift.pitch_rad, 0.2, 1e-9);
    EXPECT_NEAR(drift.yaw_rad, 0.3, 1e-9);
  }
}

TEST(MaxDrift, RegistersByTheFirst25FramesOnly) {
  const auto found_m = [](std::size_t wrong) {
    CommonPoses poses = RightPoses();
    poses.estimate[wrong] =
        poses.estimate[wrong] * RigidTransform(ExpSo3(Vector3d::Zero()), {0.3, 0.4, 0.0});
    return MeasureMaxDrift(poses, kSame)->first_motions.translation_m;
  };
  EXPECT_NEAR(found_m(25), 0.5, 1e-9);
  EXPECT_LT(found_m(24), 0.499) << "a frame that registers takes a part of its error";
}

}  // namespace
}  // namespace cvo::max_drift_test
