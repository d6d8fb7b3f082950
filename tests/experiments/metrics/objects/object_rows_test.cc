// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests the rows computed from given scores: limits, counts and contracts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "experiments/metrics/objects/object_scores.h"
#include "tests/experiments/metrics/objects/object_world.h"
#include "tests/support/error_message.h"

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

TEST(ObjectRows, CountsAreSumsOverBodies) {
  std::vector<BodyScore> bodies = {Mover(1, 4, {}), Mover(2, 4, {0.0}), Mover(3, 2, {})};
  bodies[0].id_switches = 2;
  bodies[0].fragments = 1;
  bodies[1].id_switches = 3;
  bodies[2].fragments = 4;
  bodies[0].cluster = -1;
  bodies[2].cluster = -1;
  const auto metrics = RowsOf(bodies);
  EXPECT_EQ(Value(metrics, "object_id_switches"), 5.0);
  EXPECT_EQ(Value(metrics, "object_fragments"), 5.0);
  EXPECT_EQ(Value(metrics, "object_unmatched"), 2.0);
  for (const char* name : {"object_id_switches", "object_fragments", "object_unmatched"}) {
    EXPECT_EQ(Count(metrics, name), 3) << name;
    EXPECT_EQ(FindMetric(metrics, name)->left_out, "nothing");
  }
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

TEST(ObjectRows, PredictionSuccessIsAFractionOfThePredictions) {
  BodyScore one = Mover(1, 4, {0.0});
  one.predicted = {{1, 2, 3}, {0.05, 0.15, 9.0}};
  one.predicted_ate_m = 2.0;
  BodyScore two = Mover(2, 4, {0.0});
  two.predicted = {{5}, {0.01}};
  const auto metrics = RowsOf({one, two});
  EXPECT_EQ(Value(metrics, "object_predicted_success_5cm"), 0.5);
  EXPECT_EQ(Value(metrics, "object_predicted_success_20cm"), 0.75);
  EXPECT_EQ(Count(metrics, "object_predicted_success_5cm"), 4);
  EXPECT_EQ(Value(metrics, "object_predicted_ate"), 2.0);
  EXPECT_EQ(FindMetric(metrics, "object_predicted_ate")->left_out,
            "bodies that are estimated in no frame");
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

TEST(ClusteringRows, StateTheMotionLimitsAndTheTruthSource) {
  ObjectTruth truth = TruthOf(1);
  truth.contract.camera_truth = reports::TruthSource::kDevkit;
  ObjectEstimate estimate;
  estimate.world_from_camera = truth.world_from_camera;
  estimate.landmarks.resize(1);
  Observe(estimate, 0, 0, 0);
  const auto metrics = ClusteringMetrics(truth, estimate, {});
  ASSERT_EQ(metrics.size(), 1U);
  const reports::Contract& contract = metrics[0].contract;
  EXPECT_EQ(contract.subject, reports::Subject::kLandmarks);
  EXPECT_EQ(contract.travel_m, 0.02);
  EXPECT_EQ(contract.travel_frames, 15);
  EXPECT_EQ(contract.truth, reports::TruthSource::kScene);
  EXPECT_EQ(contract.camera_truth, reports::TruthSource::kDevkit);
  EXPECT_EQ(metrics[0].n, 1);
}

}  // namespace
}  // namespace cvo::object_rows_test
