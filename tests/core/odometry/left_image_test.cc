// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/support/cluster_run.h"

namespace cvo {
namespace {

using testing::ClusterOfBody;
using testing::ClusterRun;
using testing::FindReport;
using testing::MovingWorld;
using testing::RunClusters;
using testing::RunSettings;
using testing::WorldView;

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
}  // namespace cvo
