// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/objects/object_matching.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/metrics/objects/object_world.h"

namespace cvo::object_matching_test {
namespace {

using namespace test;  // NOLINT
using testing::IsEmpty;

// A truth with `bodies` bodies and an estimate with `clusters` clusters, still without landmarks.
struct World {
  ObjectTruth truth;
  ObjectEstimate estimate;

  World(int frames, int bodies, int clusters) : truth(TruthOf(frames)) {
    for (int i = 0; i < bodies; ++i) AddBody(truth, Line(frames, i));
    estimate.world_from_camera = truth.world_from_camera;
    estimate.landmarks.resize(truth.frame_count());
    for (int i = 1; i <= clusters; ++i) estimate.clusters.push_back({i, "Ball", {}});
  }
  // Index of the cluster matched to each body, by body index; -1 if there is none.
  std::vector<int> Matched() const {
    std::vector<int> clusters(truth.bodies.size(), -1);
    for (const ObjectMatch& match : MatchObjects(truth, estimate)) {
      clusters[match.body] = static_cast<int>(match.cluster);
    }
    return clusters;
  }
  Continuity First() const { return MeasureContinuity(truth, estimate).front(); }
};

TEST(MatchObjects, SwappedIdsDoNotMatter) {
  World world(2, 2, 2);
  for (int k = 0; k < 2; ++k) {
    Observe(world.estimate, k, 2, 1);
    Observe(world.estimate, k, 1, 2);
  }
  EXPECT_EQ(world.Matched(), (std::vector<int>{1, 0}));
  EXPECT_EQ(MatchObjects(world.truth, world.estimate)[0].shared, 8.0);
}

TEST(MatchObjects, IsOneToOne) {
  World world(1, 2, 1);
  Observe(world.estimate, 0, 1, 1, 5);
  Observe(world.estimate, 0, 1, 2, 6);
  EXPECT_EQ(world.Matched(), (std::vector<int>{-1, 0}));
  World split(1, 1, 2);
  Observe(split.estimate, 0, 1, 1, 5);
  Observe(split.estimate, 0, 2, 1, 6);
  EXPECT_EQ(split.Matched(), (std::vector<int>{1}));
}

TEST(MatchObjects, MaximisesSharedLandmarksRatherThanPairs) {
  World world(1, 2, 2);
  Observe(world.estimate, 0, 1, 1, 100);
  Observe(world.estimate, 0, 2, 1, 1);
  Observe(world.estimate, 0, 1, 2, 1);
  EXPECT_EQ(world.Matched(), (std::vector<int>{0, -1}));
  // Body 1 shares most landmarks with cluster 1, but the total is higher with cluster 2.
  World total(1, 2, 2);
  Observe(total.estimate, 0, 1, 1, 10);
  Observe(total.estimate, 0, 2, 1, 8);
  Observe(total.estimate, 0, 1, 2, 5);
  EXPECT_EQ(total.Matched(), (std::vector<int>{1, 0}));
}

TEST(MatchObjects, IgnoresStaticUnknownAndUnlistedIds) {
  World world(1, 2, 1);
  Observe(world.estimate, 0, 0, 1);   // labelled static
  Observe(world.estimate, 0, -1, 1);  // no cluster
  Observe(world.estimate, 0, 1, 0);   // on the static scene
  Observe(world.estimate, 0, 1, -1);  // unknown truth
  Observe(world.estimate, 0, 9, 1);   // no such cluster
  Observe(world.estimate, 0, 1, 9);   // no such body
  EXPECT_EQ(world.Matched(), (std::vector<int>{-1, -1}));
  EXPECT_THAT(MatchObjects(TruthOf(0), {}), IsEmpty());
}

TEST(Continuity, AnotherClusterIsASwitch) {
  World world(5, 1, 3);
  const int clusters[] = {1, 1, 2, 2, 1};
  for (int k = 0; k < 5; ++k) Observe(world.estimate, k, clusters[k], 1);
  EXPECT_EQ(world.First().id_switches, 2);
  EXPECT_EQ(world.First().fragments, 0);
}

TEST(Continuity, ReappearingAfterAVisibleGapIsAFragment) {
  World world(7, 1, 1);
  for (const int k : {1, 3, 6}) Observe(world.estimate, k, 1, 1);
  Observe(world.estimate, 4, 1, 1, 2);  // too few landmarks
  EXPECT_EQ(world.First().fragments, 2);
  EXPECT_EQ(world.First().id_switches, 0);
}

TEST(Continuity, HiddenFramesAreNoGapButTheIdMustPersist) {
  World world(4, 1, 2);
  world.truth.bodies[0].frames[1]->visible = false;
  world.truth.bodies[0].frames[2].reset();
  Observe(world.estimate, 0, 1, 1);
  Observe(world.estimate, 1, 2, 1);  // hidden: ignored
  Observe(world.estimate, 3, 1, 1);
  EXPECT_EQ(world.First().fragments, 0);
  EXPECT_EQ(world.First().id_switches, 0);
  world.estimate.landmarks[3].clear();
  Observe(world.estimate, 3, 2, 1);
  EXPECT_EQ(world.First().fragments, 0);
  EXPECT_EQ(world.First().id_switches, 1);
}

TEST(Continuity, MostLandmarksDecideAndTiesKeepThePreviousCluster) {
  World world(3, 1, 2);
  Observe(world.estimate, 0, 2, 1, 4);
  Observe(world.estimate, 0, 1, 1, 3);
  Observe(world.estimate, 1, 1, 1, 4);
  Observe(world.estimate, 1, 2, 1, 4);
  Observe(world.estimate, 2, 1, 1, 5);
  Observe(world.estimate, 2, 2, 1, 4);
  EXPECT_EQ(world.First().id_switches, 1);
}

TEST(ObjectTruth, TravelIsTheLargestDistanceNotThePathLength) {
  // Back and forth by 0.15 m: the path is metres long, but the travel is 0.15 m.
  ObjectTruth truth = TruthOf(20);
  std::vector<RigidTransform> jitter;
  for (int k = 0; k < 20; ++k) jitter.push_back(At(k % 2 == 0 ? 0.0 : 0.15));
  AddBody(truth, jitter);
  AddBody(truth, Line(20));
  truth.bodies[1].frames[19].reset();
  FinishTruth(truth);
  EXPECT_DOUBLE_EQ(truth.bodies[0].travel_m, 0.15);
  EXPECT_FALSE(truth.bodies[0].mover);
  EXPECT_DOUBLE_EQ(truth.bodies[1].travel_m, 18.0);
  EXPECT_TRUE(truth.bodies[1].mover);
  EXPECT_EQ(FindBody(truth, 2), &truth.bodies[1]);
  EXPECT_EQ(FindBody(truth, 3), nullptr);
}

TEST(PointVelocity, IsACentralDifferenceAndOneSidedAtTheEnds) {
  ObjectTruth truth = TruthOf(6);
  AddBody(truth, {At(0), At(1), At(4), At(9), At(0), At(7)});
  TruthBody& body = truth.bodies[0];
  body.frames[4].reset();
  const auto velocity = [&](int k) { return PointVelocity(truth, body, k, {0, 0, 0}); };
  EXPECT_NEAR(velocity(0)->x(), 10.0, 1e-12);
  EXPECT_NEAR(velocity(1)->x(), 20.0, 1e-12);
  EXPECT_NEAR(velocity(3)->x(), 50.0, 1e-12);
  EXPECT_FALSE(velocity(4).has_value());
  EXPECT_FALSE(velocity(5).has_value());
}

TEST(MotionOfPoint, MovesThenHasStopped) {
  ObjectTruth truth = TruthOf(40);
  std::vector<RigidTransform> poses;
  for (int k = 0; k < 40; ++k) poses.push_back(At(k < 5 ? 0.0 : k < 10 ? 0.01 * (k - 4) : 0.05));
  AddBody(truth, poses);
  const auto motion = [&](int k) { return MotionOfPoint(truth, truth.bodies[0], k, {1, 2, 3}); };
  EXPECT_EQ(motion(0), PointMotion::kStill);
  EXPECT_EQ(motion(5), PointMotion::kStill);   // 1 cm
  EXPECT_EQ(motion(7), PointMotion::kMoving);  // 3 cm
  EXPECT_EQ(motion(20), PointMotion::kMoving);
  EXPECT_EQ(motion(21), PointMotion::kMoving);  // 3 cm since frame 6, 15 frames ago
  EXPECT_EQ(motion(23), PointMotion::kStopped);
  EXPECT_EQ(motion(39), PointMotion::kStopped);
}

TEST(MotionOfPoint, IsOfThePointNotOfTheOrigin) {
  ObjectTruth truth = TruthOf(2);
  AddBody(truth, {At(0), Pose({0, 0, 0.1}, {0, 0, 0})});
  const TruthBody& body = truth.bodies[0];
  EXPECT_EQ(MotionOfPoint(truth, body, 1, {0.19, 0, 0}), PointMotion::kStill);
  EXPECT_EQ(MotionOfPoint(truth, body, 1, {0.21, 0, 0}), PointMotion::kMoving);
  EXPECT_EQ(MotionOfPoint(truth, body, 1, {0, 0, 5}), PointMotion::kStill);
  truth.movers_alone_move = true;
  EXPECT_EQ(MotionOfPoint(truth, body, 1, {0.21, 0, 0}), PointMotion::kStill);
}

// The truth as the estimate of a system that reports no landmarks.
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

// Body 2 has no estimate in frame 1 and must not take that of its neighbour.
TEST(MatchByNearness, ABodyWithoutAnEstimateDoesNotTakeItsNeighbours) {
  const ObjectTruth truth = TwoLines();
  ObjectEstimate estimate = WithoutLandmarks(truth);
  estimate.clusters[1].frames.erase(estimate.clusters[1].frames.begin() + 1);
  const std::vector<Continuity> continuity = MeasureContinuity(truth, estimate);
  EXPECT_EQ(continuity[0].id_switches + continuity[1].id_switches, 0);
  EXPECT_EQ(continuity[0].fragments, 0);
  EXPECT_EQ(continuity[1].fragments, 1);
}

// So that a table can state how the rows of other systems differ.
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

// The two clusters swap places in the last frame.
TEST(MatchByNearness, SwappedClustersAreIdSwitches) {
  const ObjectTruth truth = TwoLines();
  ObjectEstimate estimate = WithoutLandmarks(truth);
  EXPECT_DOUBLE_EQ(MatchObjects(truth, estimate).at(1).shared, 3.0);
  std::swap(estimate.clusters[0].frames[2].world_from_object,
            estimate.clusters[1].frames[2].world_from_object);
  for (const Continuity& continuity : MeasureContinuity(truth, estimate)) {
    EXPECT_EQ(continuity.id_switches, 1);
    EXPECT_EQ(continuity.fragments, 0);
  }
}

}  // namespace
}  // namespace cvo::object_matching_test
