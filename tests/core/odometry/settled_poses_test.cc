// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests that poses taken from the estimator during a run equal those it would have at the end.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "tests/support/cluster_run.h"

namespace cvo {
namespace {

using testing::MovingWorld;
using testing::RunClusters;
using testing::RunSettings;
using testing::WorldView;

// Returns all numbers of a pose.
std::vector<double> NumbersOf(const ClusterPose& pose) {
  std::vector<double> numbers = {static_cast<double>(pose.frame),
                                 static_cast<double>(pose.timestamp_ns),
                                 static_cast<double>(pose.id.value),
                                 static_cast<double>(pose.status),
                                 static_cast<double>(pose.observed_landmarks),
                                 static_cast<double>(pose.detection),
                                 pose.score};
  numbers.insert(numbers.end(), pose.world_from_object.data(), pose.world_from_object.data() + 7);
  numbers.insert(numbers.end(), pose.box.object_from_box.data(),
                 pose.box.object_from_box.data() + 7);
  for (const Eigen::Vector3d* vector :
       {&pose.velocity_m_s, &pose.center_in_object, &pose.half_size_m, &pose.box.size_m}) {
    numbers.insert(numbers.end(), vector->data(), vector->data() + 3);
  }
  return numbers;
}

using PosesById = std::map<ClusterId, std::vector<std::vector<double>>>;

void AppendPoses(const std::vector<ClusterTrajectory>& clusters, PosesById& all) {
  for (const ClusterTrajectory& cluster : clusters) {
    std::vector<std::vector<double>>& poses = all[cluster.id];
    for (const ClusterPose& pose : cluster.poses) poses.push_back(NumbersOf(pose));
  }
}

constexpr int kWatched = 90;

// Hides the bodies for some time, partly for longer than the window, while they turn. They are
// predicted, archived, recovered by their landmarks or their position, and traced back.
void SpoilView(int frame, WorldView& view) {
  const auto hide = [&](int body) {
    testing::RemoveFeatures(body, view);
    testing::RemoveBoxes(body, view);
  };
  if (frame >= 14 && frame < 19) hide(1);
  if (frame >= 30 && frame < 50) hide(1);
  if (frame >= 38 && frame < 46) hide(2);
  if (frame >= 62 && frame < 66) view.frame.detections.clear();
  if (frame == 70) view.frame.timestamp_ns = -1;
}

struct Outcome {
  PosesById trajectories;
  std::size_t most_kept = 0;  // largest number of poses held by the estimator
  std::size_t taken = 0;
};

Outcome WatchOutcome(const char* variant, bool takes) {
  const MovingWorld world(5, testing::TwoBodies());
  TaskPool pool(1);
  const auto odometry =
      FindVariant(variant).make({world.camera(), FindVariant(variant).defaults(), 0}, pool);
  Outcome run;
  StageTimes times;
  for (int i = 0; i < kWatched; ++i) {
    // The camera moves back and forth, so that it stays within the world.
    const int there = i % 60 < 30 ? i % 60 : 60 - i % 60;
    WorldView view = world.Observe(there, 0.3);
    view.frame.timestamp_ns = MovingWorld::TimeOf(i);
    SpoilView(i, view);
    if (view.frame.timestamp_ns < 0) {
      (void)odometry->Skip(MovingWorld::TimeOf(i));
    } else {
      (void)odometry->Process(view.frame, times);
    }
    if (!takes) continue;
    const std::vector<ClusterTrajectory> settled = odometry->TakeSettledPoses();
    for (const ClusterTrajectory& cluster : settled) run.taken += cluster.poses.size();
    AppendPoses(settled, run.trajectories);
    std::size_t kept = 0;
    for (const ClusterTrajectory& cluster : odometry->ClusterTrajectories()) {
      kept += cluster.poses.size();
    }
    run.most_kept = std::max(run.most_kept, kept);
  }
  AppendPoses(odometry->ClusterTrajectories(), run.trajectories);
  return run;
}

class SettledPoses : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Variants, SettledPoses, ::testing::Values("full", "clustervo", "2d"));

TEST_P(SettledPoses, AreFinal) {
  const Outcome whole = WatchOutcome(GetParam(), false);
  const Outcome taken = WatchOutcome(GetParam(), true);
  EXPECT_EQ(taken.trajectories, whole.trajectories);
  EXPECT_GT(taken.taken, 60u);
  EXPECT_LT(taken.most_kept, 100u);
}

}  // namespace
}  // namespace cvo
