// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/undetected_clusters.h"

#include <gtest/gtest.h>

#include "tests/core/clusters/small_windows.h"

namespace cvo::undetected_clusters_test {
namespace {

using test::At;
using test::kCamera;
using test::StateAt;

constexpr FrameId kNewest{20};

// A confirmed cluster of ten landmarks, seen in frames 6 to 20 by a camera at the origin and last
// detected in frame `detected`, which moves by `step_m` to the right per frame.
Cluster Moving(double step_m, std::int64_t detected) {
  Cluster cluster;
  cluster.id = ClusterId{1};
  cluster.detections = 5;
  cluster.last_detected = FrameId{detected};
  cluster.last_observed = kNewest;
  for (std::int64_t f = 6; f <= kNewest.value; ++f) {
    cluster.states.push_back(StateAt(f, At(step_m * static_cast<double>(f), 0, 5)));
  }
  for (int i = 0; i < 10; ++i) {
    Landmark landmark;
    landmark.id = LandmarkId{i};
    landmark.p_in_object = {0.1 * i, 0.05 * i, 0.0};
    landmark.last_seen = kNewest;
    for (const ClusterState& state : cluster.states) {
      const auto z_px = kCamera.Project(state.world_from_object * landmark.p_in_object);
      landmark.observations.push_back({state.frame, *z_px, 0});
    }
    cluster.landmarks.push_back(landmark);
  }
  return cluster;
}

bool Still(const Cluster& cluster) {
  return StandsStill(test::WindowOf(6, kNewest.value), {}, kNewest, cluster);
}

TEST(StandsStill, IsDecidedByMostOfTheLandmarks) {
  EXPECT_TRUE(Still(Moving(0.0, 5)));
  EXPECT_FALSE(Still(Moving(0.01, 5)));  // 14 cm in T_t
  Cluster half = Moving(0.0, 5);
  for (int i = 0; i < 5; ++i) half.landmarks[i].observations.front().z_px.x() += 20.0;
  EXPECT_TRUE(Still(half));
  half.landmarks[5].observations.front().z_px.x() += 20.0;
  EXPECT_FALSE(Still(half));
}

TEST(StandsStill, NeedsALandmarkSeenNowAndBefore) {
  Cluster hidden = Moving(0.0, 5);
  for (Landmark& landmark : hidden.landmarks) landmark.last_seen = FrameId{19};
  EXPECT_FALSE(Still(hidden));
  Cluster fresh = Moving(0.0, 5);
  for (Landmark& landmark : fresh.landmarks) {
    landmark.observations = {landmark.observations.back()};
  }
  EXPECT_FALSE(Still(fresh));
  Cluster empty = Moving(0.0, 5);
  empty.landmarks.clear();
  EXPECT_FALSE(Still(empty));
}

TEST(ArchiveUndetected, TakesConfirmedClustersThatStandStill) {
  const auto is_archived = [](const Cluster& cluster, int undetected_frames) {
    ClusterOptions options;
    options.undetected_frames = undetected_frames;
    ClusterMap map;
    map.live = {cluster};
    ArchiveUndetected(test::WindowOf(6, kNewest.value), {}, kNewest, options, map);
    EXPECT_EQ(map.live.size() + map.archived.size(), 1U);
    return map.live.empty();
  };
  EXPECT_TRUE(is_archived(Moving(0.0, 5), 15));
  EXPECT_FALSE(is_archived(Moving(0.0, 6), 15));
  EXPECT_FALSE(is_archived(Moving(0.0, 5), 0));
  EXPECT_FALSE(is_archived(Moving(0.01, 5), 15));
  Cluster unconfirmed = Moving(0.0, 5);
  unconfirmed.detections = 1;  // RetireClusters drops it
  EXPECT_FALSE(is_archived(unconfirmed, 15));
  Cluster given = Moving(0.0, 5);
  given.given_body = BodyId{3};
  EXPECT_FALSE(is_archived(given, 15));
}

}  // namespace
}  // namespace cvo::undetected_clusters_test
