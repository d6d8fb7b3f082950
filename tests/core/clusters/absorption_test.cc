// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests the information that remains of observations that leave the window.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "core/clusters/cluster_map.h"
#include "tests/core/clusters/small_windows.h"

namespace cvo::absorption_test {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

using test::At;
using test::kCamera;
using test::MakeLandmark;
using test::StateAt;
using test::WindowOf;

// A rotated body with one landmark, observed in frames 0 and 1. Frame 0 is leaving the window.
struct Absorption {
  Window window = WindowOf(1, 2);
  WindowFrame leaving{FrameId{0}, At(0.2, 0.1, 0.3, 0.1), false};
  Cluster cluster;
  ClusterOptions options;

  Absorption() {
    cluster.states = {StateAt(0, At(1.0, 0.5, 8.0, 0.7)), StateAt(1, At(1.1, 0.5, 8.0, 0.8))};
    cluster.landmarks = {MakeLandmark(0, {0, 1})};
    cluster.landmarks[0].p_in_object = {0.3, -0.2, 0.4};
    cluster.landmarks[0].observations[0].octave = 2;
    cluster.landmarks[0].observations[0].z_px = Project(cluster.landmarks[0].p_in_object);
  }
  // Projects a point of the body into the leaving frame.
  Eigen::Vector3d Project(const Eigen::Vector3d& p_in_object) const {
    return *kCamera.Project(leaving.world_from_camera.Inverse() *
                            (cluster.states[0].world_from_object * p_in_object));
  }
  void Absorb() { AbsorbObservations(window, leaving, {{}, 1.2}, options, cluster); }
  const Landmark& landmark() const { return cluster.landmarks[0]; }
};

TEST(AbsorbObservations, InformationIsThatOfTheReprojectionError) {
  Absorption a;
  a.Absorb();
  EXPECT_THAT(a.landmark().observations, SizeIs(1));
  EXPECT_EQ(a.landmark().observations[0].frame, FrameId{1});
  // J, by central differences of the projection of a point of the body.
  Eigen::Matrix3d J;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d step = 1e-5 * Eigen::Vector3d::Unit(k);
    J.col(k) =
        (a.Project(a.landmark().p_in_object + step) - a.Project(a.landmark().p_in_object - step)) /
        2e-5;
  }
  const Eigen::Matrix3d expected =
      J.transpose() *
      MeasurementCovariance({.disparity_px = NoiseOptions().least_disparity_px}, 1.2 * 1.2)
          .inverse() *
      J;
  EXPECT_LT((a.landmark().past_information - expected).norm(), 1e-6 * expected.norm());
}

TEST(AbsorbObservations, MeanIsWhereTheObservationsPlaceThePoint) {
  Absorption a;
  Landmark& landmark = a.cluster.landmarks[0];
  const Eigen::Vector3d truth = landmark.p_in_object + Eigen::Vector3d(1e-3, -1e-3, 2e-3);
  landmark.observations[0].z_px = a.Project(truth);
  a.Absorb();
  EXPECT_LT((landmark.past_mean_in_object - truth).norm(), 1e-5);
  // Later changes of the estimate do not shift the remembered mean.
  landmark.p_in_object += Eigen::Vector3d(5e-3, 0.0, 0.0);
  landmark.observations.insert(landmark.observations.begin(), {FrameId{0}, a.Project(truth), 2});
  a.Absorb();
  EXPECT_LT((landmark.past_mean_in_object - truth).norm(), 5e-5);
}

TEST(AbsorbObservations, ErrorsBeyondTheRobustThresholdAreDownweighted) {
  Absorption a;
  a.Absorb();
  Absorption b;
  b.cluster.landmarks[0].observations[0].z_px[0] += 30.0;
  b.Absorb();
  EXPECT_LT(b.landmark().past_information.norm(), 0.5 * a.landmark().past_information.norm());
}

TEST(PastPolicies, LeavingObservationsAreKeptOrForgotten) {
  Absorption kept;
  KeepPastInformation::Leave(kept.window, kept.leaving, {{}, 1.2}, kept.options, kept.cluster);
  EXPECT_FALSE(kept.landmark().past_information.isZero());
  Absorption forgotten;
  ForgetPast::Leave(forgotten.window, forgotten.leaving, {{}, 1.2}, forgotten.options,
                    forgotten.cluster);
  EXPECT_TRUE(forgotten.landmark().past_information.isZero());
}

TEST(AbsorbObservations, PastInformationIsBounded) {
  Absorption a;
  a.options.max_past_observations = 10.0;
  a.Absorb();
  const Eigen::Matrix3d one = a.landmark().past_information;
  for (int k = 0; k < 500; ++k) {
    a.cluster.landmarks[0].observations.insert(
        a.cluster.landmarks[0].observations.begin(),
        {FrameId{0}, a.Project(a.landmark().p_in_object), 2});
    a.Absorb();
    EXPECT_LE(a.landmark().past_information.norm(), 10.0 * one.norm() * (1.0 + 1e-12));
  }
  EXPECT_NEAR(a.landmark().past_information.norm(), 10.0 * one.norm(), 1e-6 * one.norm());
}

TEST(AbsorbObservations, PointsSeenOnceLeaveNoInformation) {
  Absorption a;
  a.cluster.landmarks[0].observations.pop_back();
  a.Absorb();
  EXPECT_THAT(a.landmark().observations, IsEmpty());
  EXPECT_TRUE(a.landmark().past_information.isZero());
}

TEST(AbsorbObservations, FramesWithoutAStateLeaveNoInformation) {
  Absorption a;
  a.cluster.states.erase(a.cluster.states.begin());
  a.Absorb();
  EXPECT_TRUE(a.landmark().past_information.isZero());
}

}  // namespace
}  // namespace cvo::absorption_test
