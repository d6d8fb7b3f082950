// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "experiments/metrics/objects/object_scores.h"
#include "experiments/metrics/trajectory.h"
#include "tests/experiments/metrics/objects/object_world.h"

namespace cvo::object_test {
namespace {

using namespace test;  // NOLINT

const std::vector<std::string> kErrors = {
    "object_ate",          "object_rrpe_all_pairs", "object_trpe_all_pairs",
    "object_rrpe_1_frame", "object_trpe_1_frame",   "object_motion_r",
    "object_motion_t",     "object_ate_in_camera",  "object_motion_t_in_camera"};

TEST(ObjectMetrics, AreZeroForTheTruthInAnyWorldAndAnyClusterFrame) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const ObjectTruth truth = RandomTruth(seed, 20);
    Rng rng(seed, "frames");
    const auto random = [&] { return Pose(RandomVector(rng, 1.0), RandomVector(rng, 5.0)); };
    const ObjectEstimate estimate = Restate(PerfectEstimate(truth), random(), {random(), random()});
    const auto metrics = Evaluate(truth, estimate);
    for (const std::string& name : kErrors) EXPECT_NEAR(Value(metrics, name), 0.0, 1e-6) << name;
    EXPECT_NEAR(Value(metrics, "object_velocity"), 0.0, 1e-9);
    for (const char* name : {"object_coverage", "object_success_5cm", "object_success_20cm"}) {
      EXPECT_EQ(Value(metrics, name), 1.0) << name;
    }
    for (const char* name :
         {"object_id_switches", "object_fragments", "object_joins", "object_joins_wrong",
          "object_unmatched", "object_unmatched_clusters"}) {
      EXPECT_EQ(Value(metrics, name), 0.0) << name;
    }
  }
}

TEST(ObjectMetrics, DoNotDependOnTheWorldNorOnTheClusterFrame) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const ObjectTruth truth = RandomTruth(seed, 20);
    const ObjectEstimate estimate = Noisy(truth, seed);
    Rng rng(seed, "frames");
    const auto random = [&] { return Pose(RandomVector(rng, 1.0), RandomVector(rng, 5.0)); };
    const auto a = Evaluate(truth, estimate);
    const auto b = Evaluate(truth, Restate(estimate, random(), {random(), random()}));
    ASSERT_EQ(a.size(), b.size());
    EXPECT_GT(Value(a, "object_ate"), 0.01);
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_NEAR(a[i].value, b[i].value, 1e-9) << a[i].name;
    }
  }
}

TEST(ObjectMetrics, JoinsAreWrongWhereTheBodyIsElsewhereInItsCluster) {
  const ObjectTruth truth = RandomTruth(1, 20);
  for (const double off_m : {0.0, 0.09, 0.11}) {
    ObjectEstimate estimate = PerfectEstimate(truth);
    std::vector<ClusterFrame>& frames = estimate.clusters.front().frames;
    ASSERT_EQ(frames.size(), 20u);
    for (std::size_t i = 9; i < 20; ++i) {
      frames[i].world_from_object =
          frames[i].world_from_object * Pose({0.0, 0.0, 0.0}, {0.0, off_m, 0.0});
    }
    std::erase_if(frames, [](const ClusterFrame& f) { return f.frame == 2 || f.frame / 2 == 4; });
    const auto metrics = Evaluate(truth, estimate);
    EXPECT_EQ(Value(metrics, "object_joins"), 1.0) << "frame 2 alone is no gap";
    EXPECT_EQ(Value(metrics, "object_joins_wrong"), off_m > 0.1 ? 1.0 : 0.0);
  }
}

TEST(ObjectMetrics, MotionErrorEqualsItsDefinition) {
  const ObjectTruth truth = RandomTruth(3, 20);
  const ObjectEstimate estimate = Noisy(truth, 3);
  const Eigen::Matrix4d A =
      AlignByCamera(truth.world_from_camera, estimate.world_from_camera).Matrix();
  double rotation = 0.0, translation = 0.0;
  for (std::size_t body = 0; body < 2; ++body) {
    double rotation_sum = 0.0, translation_sum = 0.0;
    const auto G = [&](std::size_t k) {
      return truth.bodies[body].frames[k]->world_from_object.Matrix();
    };
    const auto P = [&](std::size_t k) {
      return Eigen::Matrix4d(A * estimate.clusters[body].frames[k].world_from_object.Matrix());
    };
    for (std::size_t k = 0; k < 19; ++k) {
      const Eigen::Matrix4d H_gt = G(k + 1) * G(k).inverse();
      const Eigen::Matrix4d H_est = P(k + 1) * P(k).inverse();
      const Eigen::Matrix4d E = G(k).inverse() * H_gt.inverse() * H_est * G(k);
      const double angle = std::acos(0.5 * (E.topLeftCorner<3, 3>().trace() - 1.0));
      rotation_sum += angle * angle;
      translation_sum += E.topRightCorner<3, 1>().squaredNorm();
    }
    rotation += std::sqrt(rotation_sum / 19) / 2;
    translation += std::sqrt(translation_sum / 19) / 2;
  }
  const auto metrics = Evaluate(truth, estimate);
  EXPECT_NEAR(Value(metrics, "object_motion_r"), rotation, 1e-6);
  EXPECT_NEAR(Value(metrics, "object_motion_t"), translation, 1e-9);
}

TEST(ObjectMetrics, HandComputed) {
  ObjectTruth truth = OneMover(4);
  // The mean offset is 0.07 m, which leaves errors of 0.07, 0.07, 0.03 and 0.11 m.
  const auto metrics = Evaluate(truth, OffBy(truth, {0.0, 0.0, 0.1, 0.18}));
  EXPECT_NEAR(Value(metrics, "object_ate"), std::sqrt((0.0049 * 2 + 0.0009 + 0.0121) / 4.0), 1e-12);
  EXPECT_EQ(Value(metrics, "object_success_5cm"), 0.25);
  EXPECT_EQ(Value(metrics, "object_success_10cm"), 0.75);
  EXPECT_EQ(Value(metrics, "object_success_20cm"), 1.0);
  EXPECT_EQ(Count(metrics, "object_success_5cm"), 4);
  // The steps are off by 0, 0.1 and 0.08 m.
  EXPECT_NEAR(Value(metrics, "object_trpe_1_frame"), std::sqrt((0.01 + 0.0064) / 3.0), 1e-12);
  EXPECT_NEAR(Value(metrics, "object_motion_t"), std::sqrt((0.01 + 0.0064) / 3.0), 1e-12);
  // The pairs are off by 0, 0.1, 0.18, 0.1, 0.18 and 0.08 m, each in both directions.
  EXPECT_NEAR(Value(metrics, "object_trpe_all_pairs"),
              std::sqrt((2 * 0.01 + 2 * 0.0324 + 0.0064) / 6.0), 1e-12);
  EXPECT_NEAR(Value(metrics, "object_velocity"), 0.0, 1e-12);
}

TEST(ObjectMetrics, TheWorldIsAlignedByTheCameraAlone) {
  ObjectTruth truth = TruthOf(3);
  truth.world_from_camera = {At(0), At(0, 0, 1), At(0, 0, 2)};
  AddBody(truth, {At(0), Pose({0, 0, 1.5}, {1, 0, 0}), Pose({0, 0, 3.0}, {2, 0, 0})});
  ObjectEstimate estimate = PerfectEstimate(truth);
  for (auto& pose : estimate.world_from_camera) pose = At(0, 0.3) * *pose;
  // The camera is 0.3 m off, the body is not. As the body turns, the direction of the offset
  // changes in its frame, and the alignment of the object frame absorbs only the mean.
  EXPECT_GT(Value(Evaluate(truth, estimate), "object_ate"), 0.2);
  const RigidTransform A = AlignByCamera(truth.world_from_camera, estimate.world_from_camera);
  EXPECT_NEAR((A.translation() - Eigen::Vector3d(0, -0.3, 0)).norm(), 0.0, 1e-12);
}

TEST(ObjectMetrics, ErrorsInCameraExcludeThoseOfTheCameraAndItsTruth) {
  ObjectTruth truth = OneMover(4);
  ObjectEstimate estimate = PerfectEstimate(truth);
  // The true camera drifts, and the bodies that it observed drift with it, as labels do.
  for (int k = 0; k < 4; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const RigidTransform drift = Pose({0.0, 0.01 * k, 0.0}, {0.0, 0.0, 0.5 * k * k});
    truth.world_from_camera[i] = drift * *truth.world_from_camera[i];
    truth.bodies[0].frames[i]->world_from_object =
        drift * truth.bodies[0].frames[i]->world_from_object;
  }
  const auto metrics = Evaluate(truth, estimate);
  EXPECT_GT(Value(metrics, "object_ate"), 0.5);
  EXPECT_GT(Value(metrics, "object_motion_t"), 0.5);
  EXPECT_NEAR(Value(metrics, "object_ate_in_camera"), 0.0, 1e-12);
  EXPECT_NEAR(Value(metrics, "object_motion_t_in_camera"), 0.0, 1e-12);
  // An error of the body counts: it is 0.4 m off in one of four frames, and the alignment of the
  // object frame absorbs a quarter of that.
  estimate.clusters[0].frames[2].world_from_object = At(2.0, 0.4);
  EXPECT_NEAR(Value(Evaluate(truth, estimate), "object_ate_in_camera"), 0.4 * std::sqrt(3.0) / 4.0,
              1e-12);
  // Frames without a camera pose are left out.
  estimate.world_from_camera[2].reset();
  EXPECT_NEAR(Value(Evaluate(truth, estimate), "object_ate_in_camera"), 0.0, 1e-12);
}

TEST(AlignByCamera, RotationComesFromOrientationsNotPositions) {
  // On a straight path, positions leave the roll free, but orientations determine it.
  const RigidTransform roll = Pose({0, 0, 0.7}, {1, 2, 3});
  OptionalPoses truth, estimate;
  for (int k = 0; k < 5; ++k) {
    truth.push_back(At(0, 0, k));
    estimate.push_back(roll.Inverse() * At(0, 0, k));
  }
  EXPECT_NEAR(AlignByCamera(truth, estimate).Minus(roll).norm(), 0.0, 1e-12);
  EXPECT_EQ(AlignByCamera({}, {}).Matrix(), Eigen::Matrix4d::Identity());
}

TEST(AlignObject, MinimisesTheSquaredErrors) {
  Rng rng(1, "poses");
  CommonPoses poses;
  const RigidTransform X = Pose(RandomVector(rng, 1.0), RandomVector(rng, 1.0));
  for (int k = 0; k < 10; ++k) {
    poses.frames.push_back(k);
    poses.estimate.push_back(Pose(RandomVector(rng, 1.0), RandomVector(rng, 3.0)));
    poses.truth.push_back(poses.estimate.back() * X *
                          Pose(RandomVector(rng, 0.1), RandomVector(rng, 0.1)));
  }
  const auto cost = [&](const RigidTransform& x) {
    double sum = 0.0;
    for (std::size_t k = 0; k < poses.size(); ++k) {
      sum += ((poses.estimate[k] * x).Matrix() - poses.truth[k].Matrix()).squaredNorm();
    }
    return sum;
  };
  const RigidTransform best = AlignObject(poses);
  for (int i = 0; i < 6; ++i) {
    for (const double step : {-1e-3, 1e-3}) {
      EXPECT_GT(cost(best.Plus(step * Vector6d::Unit(i))), cost(best)) << i;
    }
  }
}

TEST(ObjectMetrics, VelocityIsThatOfTheGivenPoint) {
  // A body turns in place by 0.2 rad per frame: a point 1 m off its origin moves on a circle.
  ObjectTruth truth = TruthOf(3);
  truth.mover_travel_m = -1.0;
  AddBody(truth, {Pose({0, 0, -0.2}, {0, 0, 0}), At(0), Pose({0, 0, 0.2}, {0, 0, 0})});
  ObjectEstimate estimate = PerfectEstimate(truth);
  EXPECT_NEAR(Value(Evaluate(truth, estimate), "object_velocity"), 0.0, 1e-12);
  for (ClusterFrame& frame : estimate.clusters[0].frames) {
    frame.point_in_object = Eigen::Vector3d::UnitX();
  }
  // The point moves by 2 sin(0.2) over the two frames around the middle one, and by a chord of
  // 2 sin(0.1) over one frame at either end.
  const double middle = std::sin(0.2) / 0.1, side = 2.0 * std::sin(0.1) / 0.1;
  EXPECT_NEAR(Value(Evaluate(truth, estimate), "object_velocity"),
              std::sqrt((middle * middle + 2 * side * side) / 3.0), 1e-9);
}

}  // namespace
}  // namespace cvo::object_test
