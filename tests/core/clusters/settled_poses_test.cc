// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/settled_poses.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/cluster_poses.h"

namespace cvo::settled_poses_test {
namespace {

using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::UnorderedElementsAre;

// T_t holds frames 20 to 30. Cluster 1 has been observed in all frames since 0.
struct Settling {
  Window window;
  ClusterOptions options;
  ClusterMap map;

  Settling() {
    for (int frame = 20; frame <= 30; ++frame) window.temporal.push_back({FrameId{frame}, {}});
    map.live = {Make(1, 0, 30, 20)};
  }
  // Makes a cluster with poses from frame `first` to `last`, and states from frame `state` on.
  Cluster Make(std::int64_t id, std::int64_t first, std::int64_t last, std::int64_t state) {
    Cluster cluster;
    cluster.id = ClusterId{id};
    cluster.detections = options.confirm_detections;
    for (; state <= last; ++state) cluster.states.push_back({FrameId{state}, state, {}});
    ClusterTrajectory& trajectory = map.trajectories[cluster.id];
    trajectory.id = cluster.id;
    for (; first <= last; ++first) {
      trajectory.poses.push_back(test::PoseInFrame(first, first, ClusterStatus::kTracked, {}));
    }
    return cluster;
  }
  // Takes the settled poses. Returns the frame of the first remaining pose of each cluster, by id.
  std::map<std::int64_t, std::int64_t> FirstLeft() {
    std::map<std::int64_t, std::int64_t> first;
    std::map<std::int64_t, std::int64_t> taken;
    for (const ClusterTrajectory& cluster : TakeSettledPoses(window, options, map)) {
      taken[cluster.id.value] = cluster.poses.back().frame;
    }
    for (const auto& [id, trajectory] : map.trajectories) {
      first[id.value] = trajectory.poses.front().frame;
      if (taken.contains(id.value)) {
        EXPECT_EQ(taken[id.value] + 1, first[id.value]);
      }
    }
    return first;
  }
};

TEST(TakeSettledPoses, AreOlderThanTheWindow) {
  Settling s;
  EXPECT_THAT(s.FirstLeft(), UnorderedElementsAre(Pair(1, 20)));
  EXPECT_THAT(TakeSettledPoses(s.window, s.options, s.map), IsEmpty());
  s.window.temporal.erase(s.window.temporal.begin());
  s.map.live[0].states.erase(s.map.live[0].states.begin());
  EXPECT_THAT(s.FirstLeft(), UnorderedElementsAre(Pair(1, 21)));
}

TEST(TakeSettledPoses, AreEmptyWithoutAWindow) {
  Settling s;
  s.window.temporal.clear();
  EXPECT_THAT(TakeSettledPoses(s.window, s.options, s.map), IsEmpty());
}

TEST(TakeSettledPoses, OfAHiddenClusterAreOlderThanItsStates) {
  Settling s;
  s.map.live = {s.Make(2, 0, 14, 12)};
  EXPECT_EQ(s.FirstLeft().at(2), 12);
}

TEST(TakeSettledPoses, OfARecoveredClusterEndBeforeItsRecovery) {
  Settling s;
  s.map.live[0].former.since = FrameId{15};
  EXPECT_THAT(s.FirstLeft(), UnorderedElementsAre(Pair(1, 15)));
}

TEST(TakeSettledPoses, EndBeforeAnyUnconfirmedCluster) {
  Settling s;
  s.map.live.push_back(s.Make(2, 17, 30, 20));
  s.map.live.back().detections = s.options.confirm_detections - 1;
  EXPECT_THAT(s.FirstLeft(), UnorderedElementsAre(Pair(1, 17), Pair(2, 17)));
  s.map.live.back().detections = s.options.confirm_detections;
  EXPECT_THAT(s.FirstLeft(), UnorderedElementsAre(Pair(1, 20), Pair(2, 20)));
}

TEST(TakeSettledPoses, ArchivedClustersKeepRecentPosesAndRemovedOnesKeepNone) {
  Settling s;
  s.map.archived.push_back(s.Make(2, 0, 12, 10));
  (void)s.Make(3, 0, 12, 10);
  EXPECT_THAT(s.FirstLeft(), UnorderedElementsAre(Pair(1, 20), Pair(2, 10)));
}

}  // namespace
}  // namespace cvo::settled_poses_test
