// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/trace_back.h"

#include <gtest/gtest.h>

#include "tests/support/cluster_run.h"

namespace cvo {
namespace {

using testing::ClusterOfBody;
using testing::ClusterRun;
using testing::FindTrajectory;
using testing::MovingWorld;
using testing::RunClusters;
using testing::RunSettings;
using testing::WorldView;

constexpr int kFrames = 30;

// A crate that slides and turns in front of the camera.
MovingWorld SlidingCrate() {
  const auto path = [](double time_s) {
    return RigidTransform(ExpSo3({0.0, 0.2 * time_s, 0.0}),
                          Eigen::Vector3d(-0.5 + 0.3 * time_s, 0.0, 3.0 + 0.3 * time_s));
  };
  return MovingWorld(5, {{"crate", {0.3, 0.3, 0.3}, 120, path}});
}

struct Story {
  int detected_from = 0;
  int features_from = 0;  // the body has no features earlier
  int trace_states = ClusterOptions().trace_states;
};

// The frames in which the final trajectory tracks the body, and the largest position error before
// its first detection, relative to its pose in that frame, m.
struct Told {
  std::vector<int> frames;
  double worst_m = 0.0;
};

Told Watch(const Story& story) {
  const MovingWorld world = SlidingCrate();
  RunSettings settings;
  settings.frames = kFrames;
  settings.options.clusters.trace_states = story.trace_states;
  const ClusterRun run = RunClusters("full", world, settings, [&](int frame, WorldView& view) {
    // Without a box the estimator takes the body for static, which must not affect the camera here.
    view.frame.given.world_from_camera = MovingWorld::CameraAt(frame);
    if (frame < story.detected_from) view.frame.detections.clear();
    if (frame >= story.features_from) return;
    for (std::size_t k = view.frame.features.size(); k-- > 0;) {
      if (view.of_body[k] != 1) continue;
      view.frame.features.erase(view.frame.features.begin() + static_cast<std::ptrdiff_t>(k));
      view.of_body.erase(view.of_body.begin() + static_cast<std::ptrdiff_t>(k));
    }
  });
  Told told;
  const ClusterTrajectory* trajectory = FindTrajectory(run, ClusterOfBody(run, kFrames - 1, 1));
  if (trajectory == nullptr) return told;
  const auto first =
      std::find_if(trajectory->poses.begin(), trajectory->poses.end(),
                   [&](const ClusterPose& pose) { return pose.frame >= story.detected_from; });
  const RigidTransform body_from_object =
      world.BodyAt(0, static_cast<int>(first->frame)).Inverse() * first->world_from_object;
  for (const ClusterPose& pose : trajectory->poses) {
    if (pose.status != ClusterStatus::kTracked) continue;
    const int frame = static_cast<int>(pose.frame);
    const RigidTransform expected = world.BodyAt(0, frame) * body_from_object;
    told.frames.push_back(frame);
    if (frame >= story.detected_from) continue;
    told.worst_m = std::max(told.worst_m,
                            (pose.world_from_object.translation() - expected.translation()).norm());
  }
  return told;
}

TEST(TraceBack, FindsABodyInTheFramesBeforeItsFirstDetection) {
  const Told with = Watch({.detected_from = 8});
  ASSERT_EQ(with.frames.size(), kFrames);
  EXPECT_EQ(with.frames.front(), 0);
  EXPECT_LT(with.worst_m, 0.03);
  EXPECT_EQ(Watch({.detected_from = 8, .trace_states = 0}).frames.front(), 8);
}

TEST(TraceBack, EndsAtTheOldestFrameOfTheWindow) {
  // The cluster starts in frame 20 and is traced at its third state, when T_t begins with frame 8.
  EXPECT_EQ(Watch({.detected_from = 20}).frames.front(), 8);
}

TEST(TraceBack, EndsWhereTheBodyWasNotObserved) {
  EXPECT_EQ(Watch({.detected_from = 8, .features_from = 4}).frames.front(), 4);
}

// T_t holds frames 0 to 6. The cluster was created in frame 4; its trajectory begins with frame 0.
struct Found {
  Window window;
  Cluster cluster;
  ClusterTrajectory trajectory;
  ClusterOptions options;

  Found() {
    cluster.detections = options.confirm_detections;
    for (const int frame : {0, 1, 2, 3, 4, 5, 6}) {
      window.temporal.push_back({FrameId{frame}, {}});
      ClusterPose pose;
      pose.frame = frame;
      pose.status = frame >= 4 ? ClusterStatus::kTracked : ClusterStatus::kPredicted;
      trajectory.poses.push_back(pose);
      if (frame >= 4)
        cluster.states.push_back({FrameId{frame}, MovingWorld::TimeOf(frame), {}, {}});
    }
  }
  std::vector<FrameId> Frames() const {
    return internal::FramesToTrace(options, window, trajectory, cluster);
  }
};

TEST(FramesToTrace, AreThoseBeforeTheClusterWasFound) {
  const std::vector<FrameId> all = {FrameId{3}, FrameId{2}, FrameId{1}, FrameId{0}};
  EXPECT_EQ(Found().Frames(), all);
  EXPECT_EQ(internal::FirstTracked(Found().window, Found().cluster), FrameId{4});
}

TEST(FramesToTrace, EndWhereTheClusterWasTracked) {
  const std::vector<FrameId> two = {FrameId{3}, FrameId{2}};
  Found by_trajectory;  // under an inherited identity
  by_trajectory.trajectory.poses[1].status = ClusterStatus::kTracked;
  EXPECT_EQ(by_trajectory.Frames(), two);
  // Too few landmarks to count as tracked, but the frame must not get a second state.
  Found by_state;
  by_state.cluster.states.insert(by_state.cluster.states.begin(),
                                 {FrameId{1}, MovingWorld::TimeOf(1), {}, {}});
  EXPECT_EQ(by_state.Frames(), two);
}

TEST(FramesToTrace, AreNoneIfDisabledOrTooEarly) {
  Found off;
  off.options.trace_states = 0;
  EXPECT_TRUE(off.Frames().empty());
  Found young;
  young.options.trace_states = 4;
  EXPECT_TRUE(young.Frames().empty());
  Found unconfirmed;
  unconfirmed.cluster.detections = 1;
  EXPECT_TRUE(unconfirmed.Frames().empty());
  Found just_confirmed;
  just_confirmed.cluster.last_detected = just_confirmed.cluster.last_observed = FrameId{6};
  EXPECT_TRUE(just_confirmed.Frames().empty());
  Found lost;
  lost.cluster.states.pop_back();
  EXPECT_TRUE(lost.Frames().empty());
  Found done;
  done.cluster.lost_before = FrameId{4};
  EXPECT_TRUE(done.Frames().empty());
}

TEST(PredictBack, ExtrapolatesBackwardsFromTheNextTwoStates) {
  const auto at = [](double time_s) {
    return RigidTransform(ExpSo3({0.0, 0.5 * time_s, 0.0}), Eigen::Vector3d(time_s, 0.0, 4.0));
  };
  const Eigen::Vector3d velocity(1.0, 0.0, 0.0);
  Cluster cluster;
  cluster.frames = 3;
  for (const int frame : {5, 6, 7}) {
    cluster.states.push_back(
        {FrameId{frame}, MovingWorld::TimeOf(frame), at(0.1 * frame), velocity});
  }
  // A state from before the loss must not be used.
  cluster.states.insert(cluster.states.begin(), {FrameId{1}, MovingWorld::TimeOf(1), at(9.0), {}});
  const Options options;
  const PredictorAnytime predict = [&](const Cluster& moving, std::int64_t timestamp_ns) {
    return PredictCluster<WhiteNoiseOnTranslation, ConstantAngularVelocity>(
        moving, timestamp_ns, options.motion_prior, options.clusters);
  };
  KeptFrame kept;
  kept.id = FrameId{3};
  kept.frame.timestamp_ns = MovingWorld::TimeOf(3);
  const PredictedCluster predicted = internal::PredictBack(predict, cluster, kept);
  const RigidTransform off = predicted.world_from_object.Inverse() * at(0.3);
  EXPECT_LT(off.translation().norm(), 1e-9);
  EXPECT_LT(LogSo3(Eigen::Quaterniond(off.rotation())).norm(), 1e-9);
  EXPECT_LT((predicted.velocity_m_s - velocity).norm(), 1e-12);
  EXPECT_GT(predicted.translation_variance_m2, 0.0);
}

}  // namespace
}  // namespace cvo
