// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/trace_back.h"

#include <gtest/gtest.h>

#include "tests/support/cluster_run.h"

namespace cvo::trace_back_test {
namespace {

using test::ClusterOfBody;
using test::ClusterRun;
using test::FindReport;
using test::FindTrajectory;
using test::MovingWorld;
using test::RunClusters;
using test::RunSettings;
using test::WorldView;

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
    if (frame < story.features_from) test::RemoveFeatures(1, view);
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

// Makes features beyond the left border of the right image visible in the left image only.
void HideBeyondTheRightImage(WorldView& view) {
  for (StereoFeature& feature : view.frame.features) {
    if (feature.z_px[2] >= 0.0) continue;
    feature.z_px[2] = feature.z_px[0];
    feature.disagreement_px = kNoDisparity_px;
  }
}

// Number of frames in which only the left image shows the body, and of those in which it is
// tracked.
struct BlindFrames {
  int all = 0;
  int tracked = 0;
};
BlindFrames WatchABodyLeave(bool uses_left_only) {
  const auto path = [](double time_s) {
    return RigidTransform(
        Eigen::Quaterniond::Identity(),
        Eigen::Vector3d(-0.6 - 0.5 * std::min(time_s, 2.0), 0.0, 2.6 + 0.5 * time_s));
  };
  const MovingWorld world(5, {{"crate", {0.2, 0.2, 0.2}, 120, path}});
  RunSettings settings;
  settings.options.association.left_only = uses_left_only;
  const ClusterRun run = RunClusters("full", world, settings,
                                     [](int, WorldView& view) { HideBeyondTheRightImage(view); });
  const ClusterId id = ClusterOfBody(run, 10, 1);
  BlindFrames blind;
  for (int i = 10; i < settings.frames; ++i) {
    const WorldView& view = run.views[i];
    bool is_blind = true;
    for (std::size_t k = 0; k < view.of_body.size(); ++k) {
      is_blind = is_blind && (view.of_body[k] != 1 || IsLeftOnly(view.frame.features[k]));
    }
    if (!is_blind) continue;
    ++blind.all;
    const ClusterReport* report = FindReport(run.reports[i], id);
    blind.tracked += report != nullptr && report->status == ClusterStatus::kTracked;
  }
  return blind;
}

TEST(MovingBodies, AreTrackedWhereOnlyTheLeftImageShowsThem) {
  const BlindFrames with = WatchABodyLeave(true);
  EXPECT_GE(with.all, 4);
  EXPECT_EQ(with.tracked, with.all);
  EXPECT_EQ(WatchABodyLeave(false).tracked, 0);
}

}  // namespace
}  // namespace cvo::trace_back_test
