// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/cluster_optimization.h"

#include <gtest/gtest.h>

#include "core/solvers/motion_prior.h"

namespace cvo::cluster_optimization_test {
namespace {

constexpr std::int64_t kFrames = 5;

// A body that moves 5 cm to the right per frame in front of a static camera. Its twelve points are
// observed in every frame without noise. All states start at the truth, except the pose in the last
// frame, which is off by 3 cm.
struct Moving {
  Options options;
  TaskPool pool{1};
  Window window;
  ClusterMap map;

  Moving() {
    window.camera = {450.0, 450.0, 320.0, 240.0, 0.3, 640, 480};
    Cluster cluster;
    cluster.id = ClusterId{1};
    for (int i = 0; i < 12; ++i) {
      Landmark landmark;
      landmark.id = LandmarkId{i};
      landmark.p_in_object = {0.2 * (i % 4) - 0.3, 0.2 * (i / 4) - 0.2, 0.1 * (i % 3)};
      cluster.landmarks.push_back(landmark);
    }
    for (std::int64_t f = 0; f < kFrames; ++f) {
      window.temporal.push_back({FrameId{f}, {}, false});
      cluster.states.push_back(
          {FrameId{f}, f * 100'000'000, Truth(f), Eigen::Vector3d(0.5, 0.0, 0.0)});
      for (Landmark& landmark : cluster.landmarks) {
        const auto z_px = window.camera.Project(Truth(f) * landmark.p_in_object);
        landmark.observations.push_back({FrameId{f}, *z_px, 0});
      }
    }
    cluster.states.back().world_from_object = Truth(kFrames - 1) * At(0.03);
    cluster.last_observed = FrameId{kFrames - 1};
    map.live.push_back(cluster);
  }

  static RigidTransform At(double x) {
    return {Eigen::Quaterniond::Identity(), Eigen::Vector3d(x, 0.0, 0.0)};
  }
  static RigidTransform Truth(std::int64_t frame) {
    return {Eigen::Quaterniond::Identity(),
            Eigen::Vector3d(0.05 * static_cast<double>(frame), 0.0, 4.0)};
  }
  double LastError_m() const {
    const RigidTransform& pose = map.live[0].Latest().world_from_object;
    return (pose.translation() - Truth(kFrames - 1).translation()).norm();
  }
  template <OutlierPolicy Outliers = RemoveOutliers>
  SolverEndings Optimize() {
    return OptimizeClusters<WhiteNoiseOnAcceleration, Outliers, OwnSchur>(
        {options.NoiseOfFeatures(), options.solver, options.motion_prior}, window, pool, map);
  }
};

TEST(OptimizeClusters, FindsThePoses) {
  Moving body;
  body.Optimize();
  EXPECT_LT(body.LastError_m(), 1e-5);
}

TEST(OptimizeClusters, RemovesOutliersOfTheLastFrame) {
  Moving body;
  for (int i = 0; i < 4; ++i) {
    body.map.live[0].landmarks[i].observations.back().z_px += Eigen::Vector3d(12.0, 0.0, 12.0);
  }
  body.Optimize();
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(FindObservation(body.map.live[0].landmarks[i], FrameId{kFrames - 1}), nullptr) << i;
  }
  // With Huber's loss alone they would still have an influence.
  EXPECT_LT(body.LastError_m(), 1e-4);
}

TEST(OptimizeClusters, KeepsOutliersIfAskedTo) {
  Moving body;
  body.map.live[0].landmarks[0].observations.back().z_px += Eigen::Vector3d(12.0, 0.0, 12.0);
  body.Optimize<KeepOutliers>();
  EXPECT_NE(FindObservation(body.map.live[0].landmarks[0], FrameId{kFrames - 1}), nullptr);
}

TEST(OptimizeClusters, SolvesAgainWhileOutliersAreFound) {
  const auto solves = [](int rounds) {
    Moving body;
    body.options.solver.cluster_rounds = rounds;
    for (int i = 0; i < 4; ++i) {
      body.map.live[0].landmarks[i].observations.back().z_px += Eigen::Vector3d(12.0, 0.0, 12.0);
    }
    const SolverEndings endings = body.Optimize();
    return endings.converged + endings.iteration_limit + endings.no_usable_step;
  };
  EXPECT_EQ(solves(1), 1);
  EXPECT_EQ(solves(3), 2) << "the second finds none";
}

TEST(OptimizeClusters, LeavesHiddenClustersUnchanged) {
  Moving body;
  body.map.live[0].last_observed = FrameId{kFrames - 2};
  const RigidTransform before = body.map.live[0].Latest().world_from_object;
  const SolverEndings endings = body.Optimize();
  EXPECT_EQ(endings.converged + endings.iteration_limit + endings.no_usable_step, 0);
  EXPECT_EQ(body.map.live[0].Latest().world_from_object.Minus(before).norm(), 0.0);
}

}  // namespace
}  // namespace cvo::cluster_optimization_test
