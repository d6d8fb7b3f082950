// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
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

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

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

TEST(ObjectScores, HaveNoMotionForOneFrame) {
  ObjectTruth truth = TruthOf(3);
  AddBody(truth, Line(3));
  ObjectEstimate estimate = PerfectEstimate(truth);
  estimate.clusters[0].frames.resize(1);
  const BodyScore body = ScoreObjects(truth, estimate).bodies.at(0);
  EXPECT_NEAR(*body.ate_m, 0.0, 1e-12);
  EXPECT_FALSE(body.all_pairs_m || body.one_frame_m || body.motion_m || body.max_drift);
}

TEST(AlignByCamera, TranslationAlignsThePositions) {
  const OptionalPoses truth = {At(0), At(0, 0, 3), At(5)};
  const OptionalPoses estimate = {At(1, 2), At(1, 4, 3), At(6, 3)};
  const RigidTransform A = AlignByCamera(truth, estimate);
  EXPECT_LT((A.translation() - Eigen::Vector3d(-1, -3, 0)).norm(), 1e-12);
}

TEST(CheckEstimate, NamesTheClusterAndTheFrame) {
  ObjectTruth truth = TruthOf(3);
  AddBody(truth, Line(3));
  const auto error = [&](const auto& change) {
    ObjectEstimate estimate = PerfectEstimate(truth);
    change(estimate);
    return ErrorMessage([&] { CheckEstimate(truth, estimate); });
  };
  EXPECT_EQ(error([](ObjectEstimate&) {}), "");
  EXPECT_EQ(error([](ObjectEstimate& e) { e.clusters[0].frames[1].velocity_m_s.reset(); }), "");
  EXPECT_THAT(error([](ObjectEstimate& e) { e.clusters[0].frames[0].frame = -1; }),
              HasSubstr("cluster 1, frame -1: found a frame after -1"));
  EXPECT_THAT(error([](ObjectEstimate& e) { e.clusters[0].frames[2].point_in_object.z() = kNan; }),
              HasSubstr("cluster 1, frame 2: found a pose, velocity or point"));
  EXPECT_THAT(
      error([](ObjectEstimate& e) { e.clusters[0].frames[0].world_from_object = At(kNan); }),
      HasSubstr("cluster 1, frame 0: found a pose, velocity or point"));
  EXPECT_THAT(error([](ObjectEstimate& e) { e.clusters[0].id = -1; }),
              HasSubstr("found cluster -1 after cluster 0, expected ids that increase from 1 on"));
}

TEST(CheckEstimate, IdsStartAtZeroWithoutLandmarks) {
  ObjectTruth truth = TruthOf(3);
  AddBody(truth, Line(3));
  ObjectEstimate estimate = PerfectEstimate(truth);
  estimate.match_by = MatchBy::kNearness;
  estimate.clusters[0].id = 0;
  EXPECT_EQ(ErrorMessage([&] { CheckEstimate(truth, estimate); }), "");
  estimate.clusters[0].id = -1;
  EXPECT_THAT(ErrorMessage([&] { CheckEstimate(truth, estimate); }),
              HasSubstr("found cluster -1 after cluster -1, expected ids that increase from 0 on"));
}

}  // namespace
}  // namespace cvo::object_scores_test
