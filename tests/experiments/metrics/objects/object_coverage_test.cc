// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

// Tests which frames and bodies enter the object metrics, and how the rest are reported.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/metrics/objects/object_world.h"

namespace cvo::object_coverage_test {
namespace {

using namespace test;  // NOLINT
using testing::HasSubstr;
using testing::IsEmpty;

TEST(ObjectMetrics, MissingFramesLowerCoverageAndSuccessButNotTheAte) {
  ObjectTruth truth = OneMover(4);
  ObjectEstimate estimate = PerfectEstimate(truth);
  estimate.clusters[0].frames.erase(estimate.clusters[0].frames.begin() + 1);
  const auto metrics = Evaluate(truth, estimate);
  EXPECT_EQ(Value(metrics, "object_coverage"), 0.75);
  EXPECT_EQ(Value(metrics, "object_success_20cm"), 0.75);
  EXPECT_NEAR(Value(metrics, "object_ate"), 0.0, 1e-12);
  EXPECT_THAT(FindMetric(metrics, "object_ate")->left_out,
              HasSubstr("1 of 4 visible object-frames without one"));
}

TEST(ObjectMetrics, OneFrameErrorsSkipGaps) {
  ObjectTruth truth = OneMover(4);
  ObjectEstimate estimate = OffBy(truth, {0.0, 0.0, 0.5, 0.5});
  EXPECT_GT(Value(Evaluate(truth, estimate), "object_motion_t"), 0.1);
  estimate.clusters[0].frames.erase(estimate.clusters[0].frames.begin() + 2);
  EXPECT_NEAR(Value(Evaluate(truth, estimate), "object_motion_t"), 0.0, 1e-12);
  estimate.clusters[0].frames.erase(estimate.clusters[0].frames.begin() + 1);
  EXPECT_EQ(Count(Evaluate(truth, estimate), "object_motion_t"), -1);
}

TEST(ObjectMetrics, AnEstimateNeedsThreeObservedLandmarks) {
  ObjectTruth truth = OneMover(4);
  ObjectEstimate estimate = OffBy(truth, {0.0, 0.0, 0.0, 0.3});
  estimate.clusters[0].frames[3].observed_landmarks = 2;
  auto metrics = Evaluate(truth, estimate);
  EXPECT_EQ(Value(metrics, "object_coverage"), 0.75);
  EXPECT_NEAR(Value(metrics, "object_ate"), 0.0, 1e-12);
  EXPECT_NEAR(Value(metrics, "object_predicted_ate"), 0.3, 1e-12);
  estimate.clusters[0].frames[3].observed_landmarks = 3;
  metrics = Evaluate(truth, estimate);
  EXPECT_EQ(Value(metrics, "object_coverage"), 1.0);
  EXPECT_EQ(FindMetric(metrics, "object_predicted_ate"), nullptr);
  estimate.clusters[0].frames[3].predicted = true;
  EXPECT_EQ(Value(Evaluate(truth, estimate), "object_coverage"), 0.75);
}

TEST(ObjectMetrics, PredictionsAreScoredSeparatelyEvenIfTheBodyIsHidden) {
  ObjectTruth truth = OneMover(5);
  truth.bodies[0].frames[2]->visible = false;
  truth.bodies[0].frames[3]->visible = false;
  ObjectEstimate estimate = OffBy(truth, {0.0, 0.0, 0.03, 0.4, 0.0});
  estimate.clusters[0].frames[2].predicted = true;
  estimate.clusters[0].frames[3].predicted = true;
  const auto metrics = Evaluate(truth, estimate);
  EXPECT_EQ(Value(metrics, "object_coverage"), 1.0);
  EXPECT_EQ(Count(metrics, "object_coverage"), 3);
  EXPECT_NEAR(Value(metrics, "object_ate"), 0.0, 1e-12);
  EXPECT_NEAR(Value(metrics, "object_predicted_ate"), std::sqrt((0.0009 + 0.16) / 2.0), 1e-12);
  EXPECT_EQ(Value(metrics, "object_predicted_success_5cm"), 0.5);
}

TEST(ObjectMetrics, StandingBodiesAreScoredSeparatelyFromMovers) {
  ObjectTruth truth = OneMover(4);
  AddBody(truth, {At(0, 5), At(0.1, 5), At(0.2, 5), At(0.1, 5)});  // travel 0.2 m: not a mover
  ObjectEstimate estimate = PerfectEstimate(truth);
  for (std::size_t k = 0; k < 4; ++k) {
    RigidTransform& pose = estimate.clusters[1].frames[k].world_from_object;
    pose = At(0, k < 2 ? 0.15 : -0.15) * pose;
  }
  const auto metrics = Evaluate(truth, estimate);
  EXPECT_NEAR(Value(metrics, "object_ate"), 0.0, 1e-12);
  EXPECT_EQ(Value(metrics, "object_success_10cm"), 1.0);
  EXPECT_NEAR(Value(metrics, "object_standing_ate"), 0.15, 1e-12);
  EXPECT_EQ(Value(metrics, "object_standing_success_10cm"), 0.0);
  const reports::Contract& contract = FindMetric(metrics, "object_standing_ate")->contract;
  EXPECT_EQ(contract.subject, reports::Subject::kStanding);
  EXPECT_EQ(contract.travel_m, 0.2);
}

TEST(ObjectMetrics, ClustersWithoutABodyAreCounted) {
  ObjectTruth truth = OneMover(4);
  ObjectEstimate estimate = PerfectEstimate(truth);
  ClusterEstimate ghost = estimate.clusters[0];
  ghost.id = 7;
  estimate.clusters.push_back(ghost);
  for (ClusterFrame& frame : ghost.frames) frame.observed_landmarks = 2;
  ghost.id = 8;  // too few landmarks in every frame
  estimate.clusters.push_back(ghost);
  for (int k = 0; k < 4; ++k) Observe(estimate, k, 7, 0);
  const auto metrics = Evaluate(truth, estimate);
  EXPECT_EQ(Value(metrics, "object_unmatched_clusters"), 1.0);
  EXPECT_EQ(Count(metrics, "object_unmatched_clusters"), 2);
}

TEST(ObjectMetrics, BodiesThatAreNeverVisibleAreIgnored) {
  ObjectTruth truth = OneMover(3);
  const ObjectEstimate estimate = PerfectEstimate(truth);
  for (auto& frame : truth.bodies[0].frames) frame->visible = false;
  EXPECT_THAT(ScoreObjects(truth, estimate).bodies, IsEmpty());
  EXPECT_EQ(FindMetric(Evaluate(truth, estimate), "object_coverage"), nullptr);
}

TEST(ObjectMetrics, NoDataGivesNoMetrics) {
  EXPECT_THAT(Evaluate(TruthOf(0), {}), IsEmpty());
  const ObjectTruth truth = TruthOf(3);
  EXPECT_THAT(Evaluate(truth, PerfectEstimate(truth)), IsEmpty());
  ObjectTruth with_body = TruthOf(3);
  AddBody(with_body, Line(3));
  ObjectEstimate nothing;
  nothing.world_from_camera.resize(3);
  nothing.landmarks.resize(3);
  const auto metrics = Evaluate(with_body, nothing);
  EXPECT_EQ(Value(metrics, "object_coverage"), 0.0);
  EXPECT_EQ(Value(metrics, "object_success_10cm"), 0.0);
  EXPECT_EQ(Value(metrics, "object_unmatched"), 1.0);
  EXPECT_EQ(FindMetric(metrics, "object_ate"), nullptr);
}

TEST(ObjectMetrics, HaveACompleteContract) {
  ObjectTruth truth = RandomTruth(2, 8);
  AddBody(truth, std::vector<RigidTransform>(8));
  truth.first_frame = 10;
  ObjectEstimate estimate = Noisy(truth, 2);
  estimate.clusters[0].frames[3].predicted = true;
  const auto metrics = Evaluate(truth, estimate);
  EXPECT_EQ(metrics.size(), 19u + 12u + 4u + 19u + 1u);
  ExpectContracts(metrics);
  EXPECT_EQ(FindMetric(metrics, "object_motion_t")->contract.frames, (reports::FrameSpan{10, 17}));
}

}  // namespace
}  // namespace cvo::object_coverage_test
