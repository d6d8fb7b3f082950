// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests the rows computed from given scores: limits, counts and contracts.

#include "experiments/metrics/objects/object_scores.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/experiments/metrics/objects/object_world.h"
#include "tests/support/error_message.h"

namespace cvo::object_scores_test {
namespace {

using namespace test;  // NOLINT
using testing::HasSubstr;

TEST(ObjectScores, DescribeTheBody) {
  ObjectTruth truth = TruthOf(4);
  AddBody(truth, Line(4));
  truth.bodies[0].frames[2]->visible = false;
  ObjectEstimate estimate = PerfectEstimate(truth);
  estimate.differentiated = true;
  const ObjectScores scores = ScoreObjects(truth, estimate);
  ASSERT_EQ(scores.bodies.size(), 1U);
  const BodyScore& body = scores.bodies[0];
  EXPECT_EQ(body.id, 1);
  EXPECT_EQ(body.name, "body_1");
  EXPECT_EQ(body.category, "Ball");
  EXPECT_TRUE(body.mover);
  EXPECT_DOUBLE_EQ(body.travel_m, 3.0);
  EXPECT_EQ(body.visible_frames, 3);
  EXPECT_EQ(body.estimated_frames, 3);
  EXPECT_EQ(body.errors.frames, (std::vector<int>{0, 1, 3}));
  EXPECT_TRUE(body.max_drift);
  EXPECT_TRUE(scores.differentiated);
  EXPECT_EQ(scores.match_by, MatchBy::kLandmarks);
}

// With any object frame of the cluster, estimated and predicted positions are those of the body's
// origin.
TEST(ObjectScores, PositionsAreOfTheBodysOrigin) {
  ObjectTruth truth = TruthOf(4);
  AddBody(truth, Line(4));
  ObjectEstimate estimate =
      Restate(PerfectEstimate(truth), At(9, 8, 7), {Pose({0.3, -1.0, 2.0}, {0.5, 0.2, -0.1})});
  estimate.clusters[0].frames[3].predicted = true;
  const BodyScore body = ScoreObjects(truth, estimate).bodies.at(0);
  ASSERT_EQ(body.estimated_positions.size(), 3U);
  ASSERT_EQ(body.predicted_positions.size(), 1U);
  EXPECT_LT((body.estimated_positions[1] - Eigen::Vector3d(1, 0, 0)).norm(), 1e-12);
  EXPECT_LT((body.predicted_positions[0] - Eigen::Vector3d(3, 0, 0)).norm(), 1e-12);
  EXPECT_EQ(body.predicted.frames, std::vector<int>{3});
  EXPECT_NEAR(*body.predicted_ate_m, 0.0, 1e-12);
}

// Of four bodies, the first has no cluster and the second is never visible.
TEST(ObjectScores, EachBodyHasItsOwnCluster) {
  ObjectTruth truth = TruthOf(3);
  for (int i = 0; i < 4; ++i) AddBody(truth, Line(3, 2.0 * i));
  ObjectEstimate estimate = PerfectEstimate(truth);
  for (auto& frame : truth.bodies[1].frames) frame->visible = false;
  estimate.clusters.erase(estimate.clusters.begin());
  const ObjectScores scores = ScoreObjects(truth, estimate);
  ASSERT_EQ(scores.bodies.size(), 3U);
  EXPECT_EQ(scores.bodies[0].cluster, -1);
  EXPECT_EQ(scores.bodies[1].cluster, 3);
  EXPECT_EQ(scores.bodies[2].cluster, 4);
  EXPECT_EQ(scores.clusters, 3);
  EXPECT_EQ(scores.unmatched_clusters, 0);
}

TEST(ObjectScores, APredictedOnlyClusterEstimatesNothing) {
  ObjectTruth truth = TruthOf(3);
  AddBody(truth, Line(3));
  ObjectEstimate estimate = PerfectEstimate(truth);
  for (ClusterFrame& frame : estimate.clusters[0].frames) frame.predicted = true;
  const ObjectScores scores = ScoreObjects(truth, estimate);
  EXPECT_EQ(scores.bodies.at(0).cluster, 1);
  EXPECT_EQ(scores.bodies[0].estimated_frames, 0);
  EXPECT_FALSE(scores.bodies[0].ate_m || scores.bodies[0].predicted_ate_m);
  EXPECT_EQ(scores.clusters, 0);
}

TEST(ObjectScores, UnknownVelocitiesAreLeftOut) {
  ObjectTruth truth = TruthOf(4);
  AddBody(truth, Line(4));
  ObjectEstimate estimate = PerfectEstimate(truth);
  estimate.clusters[0].frames[0].velocity_m_s.reset();
  estimate.clusters[0].frames[1].velocity_m_s->x() += 3.0;
  EXPECT_NEAR(*ScoreObjects(truth, estimate).bodies[0].velocity_m_s, std::sqrt(3.0), 1e-9);
  for (ClusterFrame& frame : estimate.clusters[0].frames) frame.velocity_m_s.reset();
  EXPECT_FALSE(ScoreObjects(truth, estimate).bodies[0].velocity_m_s);
}

}  // namespace
}  // namespace cvo::object_scores_test

namespace cvo::object_rows_test {
namespace {

using namespace test;  // NOLINT
using testing::HasSubstr;

// A mover that is visible in `visible` frames, with these errors in the first of them.
BodyScore Mover(int id, int visible, const std::vector<double>& errors_m) {
  BodyScore body;
  body.id = id;
  body.mover = true;
  body.cluster = id;
  body.visible_frames = visible;
  body.estimated_frames = static_cast<int>(errors_m.size());
  body.errors.position_m = errors_m;
  return body;
}

std::vector<Metric> RowsOf(const std::vector<BodyScore>& bodies) {
  ObjectScores scores;
  scores.bodies = bodies;
  return ObjectMetrics(TruthOf(8), scores);
}

TEST(ObjectRows, AnErrorAtTheLimitIsASuccess) {
  const auto metrics = RowsOf({Mover(1, 5, {0.05, 0.1, 0.2, 0.2001})});
  EXPECT_EQ(Value(metrics, "object_success_5cm"), 0.2);
  EXPECT_EQ(Value(metrics, "object_success_10cm"), 0.4);
  EXPECT_EQ(Value(metrics, "object_success_20cm"), 0.6);
  EXPECT_EQ(Value(metrics, "object_coverage"), 0.8);
}

TEST(ObjectRows, MeansAreOverBodiesWithAValue) {
  std::vector<BodyScore> bodies = {Mover(1, 4, {0.1}), Mover(2, 4, {}), Mover(3, 2, {0.1, 0.3})};
  bodies[0].ate_m = 0.1;
  bodies[2].ate_m = 0.4;
  bodies[2].max_drift = reports::MaxDrifts{{0.1, 0.2, 0.3, 0.4}, {}, {0.5, 0.6, 0.7, 0.8}};
  const auto metrics = RowsOf(bodies);
  EXPECT_DOUBLE_EQ(Value(metrics, "object_ate"), 0.25);
  EXPECT_EQ(Count(metrics, "object_ate"), 2);
  EXPECT_EQ(FindMetric(metrics, "object_ate")->left_out,
            "1 of 3 bodies without an estimate, 7 of 10 visible object-frames without one");
  EXPECT_EQ(Value(metrics, "object_max_drift"), 0.1);
  EXPECT_EQ(Count(metrics, "object_max_drift"), 1);
  EXPECT_EQ(Value(metrics, "object_max_drift_first25_yaw"), 0.8);
}

TEST(ObjectRows, ContractsStateDifferentiatedVelocities) {
  ObjectScores scores;
  scores.bodies = {Mover(1, 4, {0.0})};
  scores.bodies[0].motion_in_camera_m = 0.5;
  scores.bodies[0].ate_in_camera_m = 0.5;
  scores.differentiated = true;
  const auto without = ObjectMetrics(TruthOf(8), scores);
  const Metric* last = FindMetric(without, "object_ate_in_camera");
  EXPECT_NE(last->contract.pairing, reports::Pairing::kVelocitiesOfPositions);
  scores.bodies[0].velocity_m_s = 0.25;
  const auto metrics = ObjectMetrics(TruthOf(8), scores);
  EXPECT_EQ(FindMetric(metrics, "object_velocity")->contract.pairing,
            reports::Pairing::kVelocitiesOfPositions);
  scores.differentiated = false;
  const auto estimated = ObjectMetrics(TruthOf(8), scores);
  EXPECT_NE(FindMetric(estimated, "object_velocity")->contract.pairing,
            reports::Pairing::kVelocitiesOfPositions);
}

// Contracts state the bodies, the truth source and the minimum number of landmarks, and the frame
// span only where motions depend on it.
TEST(ObjectRows, ContractsHaveTheFieldsOfTheirGroup) {
  ObjectTruth truth = TruthOf(8);
  truth.first_frame = 3;
  truth.contract.camera_truth = reports::TruthSource::kDevkit;
  ObjectScores scores;
  scores.bodies = {Mover(1, 4, {0.0})};
  scores.bodies[0].ate_m = 0.5;
  scores.bodies[0].motion_m = 0.5;
  scores.clusters = 2;
  scores.unmatched_clusters = 1;
  const auto metrics = ObjectMetrics(truth, scores);
  for (const char* name : {"object_ate", "object_motion_t", "object_coverage"}) {
    const reports::Contract& contract = FindMetric(metrics, name)->contract;
    EXPECT_EQ(contract.subject, reports::Subject::kMovers) << name;
    EXPECT_EQ(contract.travel_m, 0.2);
    EXPECT_EQ(contract.truth, reports::TruthSource::kScene);
    EXPECT_EQ(contract.camera_truth, reports::TruthSource::kDevkit);
    EXPECT_EQ(contract.matching, MatchBy::kLandmarks);
    EXPECT_EQ(contract.least_landmarks, 3);
  }
  EXPECT_EQ(FindMetric(metrics, "object_motion_t")->contract.frames, (reports::FrameSpan{3, 10}));
  EXPECT_NE(FindMetric(metrics, "object_ate")->contract.frames, (reports::FrameSpan{3, 10}));
  const Metric* clusters = FindMetric(metrics, "object_unmatched_clusters");
  EXPECT_EQ(clusters->contract.subject, reports::Subject::kClusters);
  EXPECT_EQ(clusters->contract.matching, MatchBy::kLandmarks);
}

TEST(ObjectRows, RefuseAnOverflow) {
  std::vector<BodyScore> bodies = {Mover(1, 4, {0.0})};
  bodies[0].ate_m = std::numeric_limits<double>::infinity();
  EXPECT_THAT(ErrorMessage([&] { RowsOf(bodies); }), HasSubstr("object_ate: found an overflow"));
}

}  // namespace
}  // namespace cvo::object_rows_test
