// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>

#include "experiments/metrics/camera_metrics.h"
#include "experiments/metrics/objects/object_scores.h"
#include "tests/experiments/metrics/objects/object_world.h"

namespace cvo::clustering_test {
namespace {

using namespace test;  // NOLINT
using testing::IsEmpty;

struct World {
  ObjectTruth truth;
  ObjectEstimate estimate;

  explicit World(int frames, int bodies = 2) : truth(TruthOf(frames)) {
    for (int i = 0; i < bodies; ++i) AddBody(truth, Line(frames, i));
    estimate.world_from_camera = truth.world_from_camera;
    estimate.landmarks.resize(truth.frame_count());
    for (int i = 1; i <= bodies; ++i) estimate.clusters.push_back({i, "Ball", {}});
  }
  std::vector<Metric> Evaluate() const {
    return ClusteringMetrics(truth, estimate, MatchObjects(truth, estimate));
  }
  double operator()(const std::string& name) const {
    const std::vector<Metric> metrics = Evaluate();
    const Metric* metric = FindMetric(metrics, name);
    return metric == nullptr ? -1.0 : metric->value;
  }
};

TEST(ClusteringMetrics, AreOneForTheTruthWithAnyIds) {
  World world(3);
  for (int k = 0; k < 3; ++k) {
    Observe(world.estimate, k, 0, 0, 20);
    Observe(world.estimate, k, 2, 1, 5);
    Observe(world.estimate, k, 1, 2, 6);
  }
  for (const char* name :
       {"moving_precision", "moving_recall", "clustering_iou", "clustering_ari"}) {
    EXPECT_EQ(world(name), 1.0) << name;
  }
}

TEST(ClusteringMetrics, HandComputed) {
  World world(1, 1);
  Observe(world.estimate, 0, 0, 0, 6);
  Observe(world.estimate, 0, 1, 0, 2);   // background in the cluster
  Observe(world.estimate, 0, 1, 1, 6);   // correct
  Observe(world.estimate, 0, 0, 1, 1);   // labelled static
  Observe(world.estimate, 0, -1, 1, 1);  // in no cluster
  EXPECT_EQ(world("moving_precision"), 6.0 / 8.0);
  EXPECT_EQ(world("moving_recall"), 6.0 / 8.0);
  // IoU of the static scene: 6 / (8 + 7 - 6). IoU of the body: 6 / (8 + 8 - 6).
  EXPECT_DOUBLE_EQ(world("clustering_iou"), 0.5 * (6.0 / 9.0 + 6.0 / 10.0));
  // Pairs of landmarks in the same group, of 120: 28 + 28 in the truth, 21 + 28 in the clusters,
  // 15 + 1 + 15 + 0 in both.
  const double chance = 56.0 * 49.0 / 120.0;
  EXPECT_DOUBLE_EQ(world("clustering_ari"), (31.0 - chance) / (0.5 * (56.0 + 49.0) - chance));
}

TEST(ClusteringMetrics, ACountEqualsThatManyLandmarks) {
  World one_by_one(2);
  World counted(2);
  for (const auto& [cluster, body, count] :
       {std::tuple(0, 0, 9), {1, 0, 2}, {1, 1, 6}, {0, 1, 3}, {2, 2, 4}, {1, 2, 5}, {0, -1, 2}}) {
    Observe(one_by_one.estimate, 1, cluster, body, count);
    counted.estimate.landmarks[1].push_back(
        {cluster, {static_cast<std::int16_t>(body), PointMotion::kMoving}, count});
  }
  const std::vector<Metric> expected = one_by_one.Evaluate();
  const std::vector<Metric> found = counted.Evaluate();
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].value, expected[i].value) << found[i].name;
    EXPECT_EQ(found[i].left_out, expected[i].left_out) << found[i].name;
  }
}

TEST(ClusteringMetrics, PurityIsTheShareOfTheMajorityBody) {
  World world(2);
  Observe(world.estimate, 0, 1, 1, 6);   // cluster 1 is body 1
  Observe(world.estimate, 1, 1, 2, 2);   // on another body
  Observe(world.estimate, 1, 1, 0, 1);   // on the background
  Observe(world.estimate, 1, 1, -1, 5);  // not known
  Observe(world.estimate, 1, 0, 2, 4);   // in no cluster
  for (int i = 0; i < 3; ++i) {
    world.estimate.landmarks[0].push_back({2, {2, PointMotion::kStill}});
  }
  EXPECT_EQ(world("cluster_purity"), 9.0 / 12.0);
}

TEST(ClusteringMetrics, StandingBodiesDoNotCount) {
  World world(1);
  Observe(world.estimate, 0, 0, 0, 5);
  Observe(world.estimate, 0, 1, 1, 5);
  for (int i = 0; i < 4; ++i) {
    world.estimate.landmarks[0].push_back({2, {2, PointMotion::kStill}});
    world.estimate.landmarks[0].push_back({0, {2, PointMotion::kStill}});
  }
  Observe(world.estimate, 0, 2, -1, 7);  // not known
  for (const char* name :
       {"moving_precision", "moving_recall", "clustering_iou", "clustering_ari"}) {
    EXPECT_EQ(world(name), 1.0) << name;
  }
  const auto metrics = world.Evaluate();
  EXPECT_EQ(FindMetric(metrics, "moving_precision")->left_out,
            "7 observations of unknown truth, 8 on bodies that have not moved yet, of 25");
}

TEST(ClusteringMetrics, AStoppedMoverStaysAnObject) {
  World world(1, 1);
  Observe(world.estimate, 0, 0, 0, 5);
  for (const int cluster : {1, 1, 1, 0}) {
    world.estimate.landmarks[0].push_back({cluster, {1, PointMotion::kStopped}});
  }
  EXPECT_EQ(world("moving_precision"), 1.0);
  EXPECT_EQ(world("moving_recall"), 0.75);
}

TEST(ClusteringMetrics, ABodyWithoutAClusterHasZeroIou) {
  World world(1);
  Observe(world.estimate, 0, 0, 0, 6);
  Observe(world.estimate, 0, 1, 1, 6);
  Observe(world.estimate, 0, 1, 2, 3);  // both bodies in one cluster
  EXPECT_DOUBLE_EQ(world("clustering_iou"), (1.0 + 6.0 / 9.0 + 0.0) / 3.0);
  EXPECT_EQ(world("moving_precision"), 1.0);
  EXPECT_LT(world("clustering_ari"), 1.0);
}

TEST(ClusteringMetrics, AveragesIouAndAriOverFramesAndRecallOverLandmarks) {
  World world(3, 1);
  Observe(world.estimate, 0, 0, 0, 4);
  Observe(world.estimate, 0, 1, 1, 4);
  Observe(world.estimate, 1, 0, 0, 4);
  Observe(world.estimate, 1, 0, 1, 8);  // all missed; frame 2 is empty
  EXPECT_EQ(world("moving_recall"), 4.0 / 12.0);
  EXPECT_DOUBLE_EQ(world("clustering_iou"), 0.5 * (1.0 + 0.5 * (4.0 / 12.0)));
  EXPECT_DOUBLE_EQ(world("clustering_ari"), 0.5);
}

TEST(ClusteringMetrics, UndeterminedMetricsAreAbsent) {
  EXPECT_THAT(World(3).Evaluate(), IsEmpty());
  World world(1, 1);
  Observe(world.estimate, 0, 0, 0, 4);
  EXPECT_EQ(world("moving_precision"), -1.0);
  EXPECT_EQ(world("moving_recall"), -1.0);
  EXPECT_EQ(world("clustering_iou"), 1.0);
  EXPECT_EQ(world("clustering_ari"), -1.0);
  for (const Metric& metric : world.Evaluate()) {
    const reports::Contract& c = metric.contract;
    EXPECT_TRUE(c.subject && c.truth && c.alignment && c.pairing && c.delta && c.aggregation)
        << metric.name;
    EXPECT_FALSE(metric.left_out.empty()) << metric.name;
  }
}

TEST(AdjustedRandIndex, HandComputed) {
  // Of 15 pairs, 3 + 3 are together in the first labelling, 1 + 6 in the second and 1 + 3 in both.
  EXPECT_DOUBLE_EQ(AdjustedRandIndex({0, 0, 0, 1, 1, 1}, {0, 0, 1, 1, 1, 1}),
                   (4.0 - 42.0 / 15.0) / (6.5 - 42.0 / 15.0));
  EXPECT_EQ(AdjustedRandIndex({0, 0, 1, 1}, {5, 5, 3, 3}), 1.0);
  EXPECT_DOUBLE_EQ(AdjustedRandIndex({0, 0, 1, 1}, {0, 1, 0, 1}), -0.5);
}

TEST(AdjustedRandIndex, DegenerateLabellings) {
  EXPECT_EQ(AdjustedRandIndex({}, {}), 1.0);
  EXPECT_EQ(AdjustedRandIndex({4}, {2}), 1.0);
  EXPECT_EQ(AdjustedRandIndex({1, 1, 1}, {2, 2, 2}), 1.0);
  EXPECT_EQ(AdjustedRandIndex({1, 2, 3}, {-1, -1, -1}), 1.0);
  EXPECT_EQ(AdjustedRandIndex({1, 1, 1}, {1, 2, 3}), 0.0);
  EXPECT_EQ(AdjustedRandIndex({1, 1, 1}, {-1, -1, -1}), 0.0);
}

}  // namespace
}  // namespace cvo::clustering_test
