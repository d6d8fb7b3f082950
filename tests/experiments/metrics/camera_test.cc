// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/experiments/metrics/objects/object_world.h"
#include "tests/support/error_message.h"

namespace cvo::camera_test {
namespace {

using namespace test;  // NOLINT
using testing::HasSubstr;
using testing::IsEmpty;

// A random walk as truth, and an estimate with noise on each step.
struct Pair {
  OptionalPoses truth, estimate;
};
Pair RandomPair(std::uint64_t seed, int frames) {
  Rng rng(seed, "trajectories");
  Pair pair;
  RigidTransform truth, estimate = Pose(RandomVector(rng, 1.0), RandomVector(rng, 10.0));
  for (int i = 0; i < frames; ++i) {
    pair.truth.push_back(truth);
    pair.estimate.push_back(estimate);
    const Eigen::Vector3d turn = RandomVector(rng, 0.1), move = RandomVector(rng, 1.0);
    truth = truth * Pose(turn, move);
    estimate = estimate * Pose(turn + RandomVector(rng, 0.01), move + RandomVector(rng, 0.05));
  }
  return pair;
}

TEST(Ate, SquareThatIsTooLarge) {
  // The best alignment is the identity; every corner is off by 0.1 sqrt(2).
  OptionalPoses truth, estimate;
  for (const auto& [x, y] : {std::pair{1, 1}, {1, -1}, {-1, -1}, {-1, 1}}) {
    truth.push_back(At(x, y));
    estimate.push_back(At(1.1 * x, 1.1 * y));
  }
  const auto metrics = EvaluateCamera(truth, estimate);
  for (const char* name :
       {"camera_ate", "camera_ate_mean", "camera_ate_median", "camera_ate_max"}) {
    EXPECT_NEAR(Value(metrics, name), 0.1 * std::numbers::sqrt2, 1e-12) << name;
    EXPECT_EQ(Count(metrics, name), 4) << name;
  }
}

TEST(Ate, IsZeroForARigidlyMovedTruthButNotForAScaledOne) {
  const Pair pair = RandomPair(3, 50);
  const RigidTransform motion = Pose({1.0, -2.0, 0.5}, {100.0, -7.0, 3.0});
  OptionalPoses moved, scaled;
  for (const auto& pose : pair.truth) {
    moved.push_back(motion * *pose);
    scaled.push_back(RigidTransform(Eigen::Quaterniond(pose->rotation()),
                                    Eigen::Vector3d(2.0 * pose->translation())));
  }
  EXPECT_NEAR(Value(EvaluateCamera(pair.truth, moved), "camera_ate"), 0.0, 1e-12);
  EXPECT_GT(Value(EvaluateCamera(pair.truth, scaled), "camera_ate"), 0.5);
}

TEST(Ate, PartsAreInTheAxesOfTheTrueCamera) {
  // Cameras that look along y of the world, x to the right: errors along x, y, z of the world are
  // lateral, longitudinal and vertical. Opposite signs leave no alignment.
  const Eigen::Vector3d look = {-0.5 * std::numbers::pi, 0.0, 0.0};
  const Eigen::Vector3d error = {0.1, 0.2, 0.3};
  OptionalPoses truth, estimate;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d corner((i & 1) * 2e6 - 1e6, (i & 2) * 1e6 - 1e6, (i & 4) * 5e5 - 1e6);
    const double sign = (i == 0 || i == 3 || i == 5 || i == 6) ? 1.0 : -1.0;
    truth.push_back(Pose(look, corner));
    estimate.push_back(Pose(look, corner + sign * error));
  }
  const auto metrics = EvaluateCamera(truth, estimate);
  EXPECT_NEAR(Value(metrics, "camera_ate_lateral"), 0.1, 1e-6);
  EXPECT_NEAR(Value(metrics, "camera_ate_longitudinal"), 0.2, 1e-6);
  EXPECT_NEAR(Value(metrics, "camera_ate_vertical"), 0.3, 1e-6);
}

TEST(EndRotation, IsThatOfTheWholeMotion) {
  const OptionalPoses truth = {Pose({0, 1, 0}, {0, 0, 0}), At(1), Pose({0, 1.5, 0}, {2, 0, 0})};
  const OptionalPoses estimate = {At(0), Pose({1, 0, 0}, {1, 0, 0}), Pose({0, 0.4, 0}, {2, 0, 0})};
  EXPECT_NEAR(Value(EvaluateCamera(truth, estimate), "camera_end_rotation"), 0.1, 1e-12);
}

TEST(Truths, TheirGapAndTheErrorAgainstTheSecond) {
  const OptionalPoses truth = {At(0), At(1), At(2)}, second = {At(0), At(1.1), At(2.2)};
  const auto same = CompareTruths(truth, second, second);
  EXPECT_NEAR(Value(same, "camera_ate_velocity"), 0.0, 1e-12);
  EXPECT_NEAR(Value(same, "camera_truth_gap"), 0.1 * std::sqrt(2.0 / 3.0), 1e-12);
}

TEST(CameraMetrics, DoNotDependOnTheWorldFrameOfTheEstimate) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Pair pair = RandomPair(seed, 60);
    Rng rng(seed, "motion");
    const RigidTransform motion = Pose(RandomVector(rng, 1.0), RandomVector(rng, 100.0));
    OptionalPoses moved;
    for (const auto& pose : pair.estimate) moved.push_back(motion * *pose);
    const auto a = EvaluateCamera(pair.truth, pair.estimate);
    const auto b = EvaluateCamera(pair.truth, moved);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_NEAR(a[i].value, b[i].value, 1e-9) << a[i].name;
    }
  }
}

TEST(AllPairsRpe, HandComputed) {
  // Distances 1, 1, 2 and angles 0.1, 0.2, 0.3, each in both directions.
  const OptionalPoses truth = {At(0), At(0), At(0)};
  const OptionalPoses estimate = {At(0), Pose({0, 0, 0.1}, {1, 0, 0}),
                                  Pose({0, 0, 0.3}, {2, 0, 0})};
  const auto metrics = EvaluateCamera(truth, estimate);
  EXPECT_NEAR(Value(metrics, "camera_trpe_all_pairs"), std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(Value(metrics, "camera_rrpe_all_pairs"), std::sqrt(0.14 / 3.0), 1e-12);
  EXPECT_EQ(Count(metrics, "camera_trpe_all_pairs"), 6);
}

TEST(OneFrameRpe, HandComputed) {
  const OptionalPoses truth = {At(0), At(1), At(2)};
  const OptionalPoses estimate = {At(0), At(1.5), Pose({0, 0.1, 0}, {2.5, 0, 0})};
  const auto metrics = EvaluateCamera(truth, estimate);
  EXPECT_NEAR(Value(metrics, "camera_trpe_1_frame"), std::sqrt(0.25 / 2.0), 1e-12);
  EXPECT_NEAR(Value(metrics, "camera_rrpe_1_frame"), std::sqrt(0.01 / 2.0), 1e-12);
  EXPECT_EQ(Count(metrics, "camera_trpe_1_frame"), 2);
}

TEST(OneFrameRpe, SkipsGaps) {
  // The estimate has frames 0, 1, 3 and 4, of which 1 and 3 are not consecutive.
  const OptionalPoses truth = {At(0), At(1), At(2), At(3), At(4)};
  const OptionalPoses estimate = {At(0), At(1), std::nullopt, At(50), At(51)};
  const auto metrics = EvaluateCamera(truth, estimate);
  EXPECT_EQ(Count(metrics, "camera_trpe_1_frame"), 2);
  EXPECT_NEAR(Value(metrics, "camera_trpe_1_frame"), 0.0, 1e-12);
  const OptionalPoses every_second = {At(0), std::nullopt, At(2), std::nullopt, At(4)};
  EXPECT_EQ(FindMetric(EvaluateCamera(truth, every_second), "camera_trpe_1_frame"), nullptr);
}

TEST(Coverage, CountsOnlyFramesWithTruth) {
  const OptionalPoses truth = {std::nullopt, At(1), At(2), At(3), At(4)};
  const OptionalPoses estimate = {At(0), At(1), std::nullopt, At(3), At(4)};
  const auto metrics = EvaluateCamera(truth, estimate, reports::TruthSource::kOfficial);
  EXPECT_EQ(Value(metrics, "camera_coverage"), 0.75);
  EXPECT_EQ(Count(metrics, "camera_coverage"), 4);
  const Metric* ate = FindMetric(metrics, "camera_ate");
  ASSERT_NE(ate, nullptr);
  EXPECT_EQ(ate->n, 3);
  EXPECT_EQ(ate->contract.truth, reports::TruthSource::kOfficial);
  EXPECT_EQ(ate->left_out, "1 of 5 frames without truth, 1 with truth but without an estimate");
}

TEST(CameraMetrics, DegenerateInputsLeaveMetricsOut) {
  EXPECT_THAT(EvaluateCamera({}, {}), IsEmpty());
  EXPECT_THAT(EvaluateCamera({std::nullopt}, {At(0)}), IsEmpty());
  const auto lost = EvaluateCamera({At(0), At(1)}, {std::nullopt, std::nullopt});
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_EQ(Value(lost, "camera_coverage"), 0.0);
  const auto one = EvaluateCamera({At(0), At(1)}, {At(0), std::nullopt});
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(Value(one, "camera_coverage"), 0.5);
}

TEST(CameraMetrics, RefuseNonFiniteValues) {
  EXPECT_THAT(ErrorMessage([] {
                EvaluateCamera({At(0), At(1)}, {At(0), At(std::nan(""))});
              }),
              HasSubstr("estimate of frame 1: found a pose that is not finite"));
  EXPECT_THAT(ErrorMessage([] {
                EvaluateCamera({At(0), At(1)}, {At(0), At(1e300)});
              }),
              HasSubstr("camera_ate: found an overflow"));
}

TEST(CameraMetrics, HaveACompleteContract) {
  OptionalPoses truth, estimate;
  for (int i = 0; i < 150; ++i) truth.push_back(At(0, 0, i)), estimate.push_back(At(0, 0, i));
  const auto metrics = EvaluateCamera(truth, estimate, reports::TruthSource::kDevkit);
  EXPECT_EQ(metrics.size(), 16u + 12u);
  ExpectContracts(metrics);
}

OptionalPoses Straight(int frames, double step_m) {
  OptionalPoses poses;
  for (int i = 0; i < frames; ++i) poses.push_back(At(0, 0, step_m * i));
  return poses;
}

TEST(KittiDrift, BridgesFramesWithoutTruth) {
  OptionalPoses truth = Straight(121, 1.0);
  truth[10].reset();   // no sub-sequence starts here
  truth[101].reset();  // the one from 0 ends a frame later, after 102 m
  const auto drift = ComputeKittiDrift(truth, Straight(121, 1.01));
  ASSERT_TRUE(drift.has_value());
  EXPECT_EQ(drift->segments, 1);
  EXPECT_NEAR(drift->translation_percent, 1.02, 1e-9);
}

TEST(CameraMetrics, PathErrorIsOfTheLengthOverConsecutiveFrames) {
  OptionalPoses truth = Straight(11, 1.0);
  OptionalPoses estimate = Straight(11, 0.98);
  EXPECT_NEAR(Value(EvaluateCamera(truth, estimate), "camera_path_error"), 2.0, 1e-9);
  // The path is not measured across a gap.
  estimate[5] = At(100);
  truth[5].reset();
  const auto metrics = EvaluateCamera(truth, estimate);
  EXPECT_NEAR(Value(metrics, "camera_path_error"), 2.0, 1e-9);
  EXPECT_EQ(FindMetric(metrics, "camera_path_error")->n, 8);
}

TEST(CameraMetrics, DriftReportsWhatItLeftOut) {
  OptionalPoses estimate = Straight(121, 1.0);
  estimate[10].reset();
  const auto metrics = EvaluateCamera(Straight(121, 1.0), estimate);
  EXPECT_EQ(Count(metrics, "camera_t_drift"), 1);
  EXPECT_EQ(FindMetric(metrics, "camera_r_drift")->left_out,
            "0 of 121 frames without truth, 1 with truth but without an estimate; 1 sub-sequences "
            "without an estimate at an end");
}

}  // namespace
}  // namespace cvo::camera_test
