// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/metrics/object_matching.h"
#include "tests/experiments/metrics/object_world.h"

namespace cvo {
namespace {

using namespace test;  // NOLINT

// The truth as a system without landmarks tells it.
ObjectEstimate WithoutLandmarks(const ObjectTruth& truth) {
  ObjectEstimate estimate = PerfectEstimate(truth);
  estimate.match_by = MatchBy::kNearness;
  estimate.landmarks.assign(truth.frame_count(), {});
  for (ClusterEstimate& cluster : estimate.clusters) {
    for (ClusterFrame& frame : cluster.frames) frame.observed_landmarks.reset();
  }
  return estimate;
}

ObjectTruth TwoLines() {
  ObjectTruth truth = TruthOf(3);
  AddBody(truth, Line(3));
  AddBody(truth, Line(3, 1.0));
  for (TruthBody& body : truth.bodies) body.diagonal_m = 2.0;
  return truth;
}

TEST(MatchByNearness, SharesOneMinusDistanceOverDiagonal) {
  const ObjectTruth truth = TwoLines();
  ObjectEstimate estimate = WithoutLandmarks(truth);
  const Eigen::Matrix2d expected = (Eigen::Matrix2d() << 1.0, 0.5, 0.5, 1.0).finished();
  EXPECT_TRUE(NearnessInFrame(truth, estimate, 1).isApprox(expected));
  estimate.clusters[0].frames[1].point_in_object.y() = -3.0;
  EXPECT_EQ(NearnessInFrame(truth, estimate, 1)(0, 0), 0.0);
  estimate.clusters[0].frames.erase(estimate.clusters[0].frames.begin() + 1);
  EXPECT_TRUE(NearnessInFrame(truth, estimate, 1).col(0).isZero());
  estimate.world_from_camera[0].reset();
  EXPECT_TRUE(NearnessInFrame(truth, estimate, 0).isZero());
}

TEST(MatchByNearness, CameraDriftDoesNotMatter) {
  const ObjectTruth truth = TwoLines();
  const RigidTransform drift = Pose({0.0, 0.5, 0.0}, {100.0, 0.0, 0.0});
  const ObjectEstimate estimate = WithoutLandmarks(truth);
  const ObjectEstimate drifted = Restate(estimate, drift, {RigidTransform(), RigidTransform()});
  EXPECT_TRUE(
      NearnessInFrame(truth, drifted, 2).isApprox(NearnessInFrame(truth, estimate, 2), 1e-9));
}

// Body 2 has no estimate in frame 1: its neighbour's is not taken for it.
TEST(MatchByNearness, ABodyWithoutAnEstimateDoesNotTakeItsNeighbours) {
  const ObjectTruth truth = TwoLines();
  ObjectEstimate estimate = WithoutLandmarks(truth);
  estimate.clusters[1].frames.erase(estimate.clusters[1].frames.begin() + 1);
  const std::vector<Continuity> continuity = MeasureContinuity(truth, estimate);
  EXPECT_EQ(continuity[0].id_switches + continuity[1].id_switches, 0);
  EXPECT_EQ(continuity[0].fragments, 0);
  EXPECT_EQ(continuity[1].fragments, 1);
}

// So that a table can say what sets the rows of other systems apart.
TEST(MatchByNearness, OnlyTheMatchingDiffersInTheContract) {
  const ObjectTruth truth = TwoLines();
  const std::vector<Metric> own = Evaluate(truth, PerfectEstimate(truth));
  const std::vector<Metric> other = Evaluate(truth, WithoutLandmarks(truth));
  ASSERT_EQ(own.size(), other.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    EXPECT_EQ(own[i].name, other[i].name);
    EXPECT_NEAR(own[i].value, other[i].value, 1e-12) << own[i].name;
    EXPECT_EQ(reports::FirstDifference(own[i].contract, other[i].contract), "matching");
    reports::Contract contract = other[i].contract;
    contract.matching = own[i].contract.matching;
    contract.least_landmarks = own[i].contract.least_landmarks;
    EXPECT_EQ(contract, own[i].contract) << own[i].name;
  }
}

}  // namespace
}  // namespace cvo
