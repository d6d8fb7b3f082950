// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <deque>
#include <map>
#include <vector>

#include "core/clustering/point_extent.h"
#include "core/estimation/cluster.h"
#include "core/estimation/window.h"
#include "core/interface/cluster_options.h"
#include "core/interface/odometry.h"

namespace cvo {

// The moving half of the estimator's state.
struct ClusterMap {
  std::vector<Cluster> live;                            // by id; some not yet confirmed
  std::deque<Cluster> archived;                         // the latest archived last
  std::map<ClusterId, ClusterTrajectory> trajectories;  // of all clusters ever, confirmed or not
  ClusterId next{1};
};

// Live or archived; null: neither.
const Cluster* FindCluster(const ClusterMap& map, ClusterId id);

inline bool IsConfirmed(const Cluster& cluster, const ClusterOptions& options) {
  return cluster.detections >= options.confirm_detections || cluster.given_body.valid();
}

// By a detection in the newest frame: it may yet turn out to be a lost cluster (IdentityPolicy).
inline bool IsJustConfirmed(const Cluster& cluster, const ClusterOptions& options, FrameId newest) {
  return IsConfirmed(cluster, options) && cluster.detections == options.confirm_detections &&
         cluster.last_detected == newest && cluster.last_observed == newest;
}

// The first pose in the frame or after it. Poses are by frame.
auto FirstPoseFrom(std::int64_t frame, auto& trajectory) {
  return std::lower_bound(trajectory.poses.begin(), trajectory.poses.end(), frame,
                          [](const ClusterPose& pose, std::int64_t f) { return pose.frame < f; });
}

// The observations of a frame that leaves T_t become past knowledge of their landmarks; the frame
// is no longer in the window.
void AbsorbObservations(const Window& window, const WindowFrame& leaving, const FeatureNoise& noise,
                        const ClusterOptions& options, Cluster& cluster);

// What becomes of what a cluster saw in a frame that leaves T_t.
template <typename Policy>
concept PastPolicy = requires(const Window& window, const WindowFrame& leaving,
                              const FeatureNoise& noise, const ClusterOptions& options,
                              Cluster& cluster) {
  Policy::Leave(window, leaving, noise, options, cluster);
};

// Policy: past knowledge of its landmarks (METHOD.md 8.4).
struct KeepPastInformation {
  static void Leave(const Window& window, const WindowFrame& leaving, const FeatureNoise& noise,
                    const ClusterOptions& options, Cluster& cluster) {
    AbsorbObservations(window, leaving, noise, options, cluster);
  }
};
// Policy: nothing, as in the paper: the energy of a cluster is that of T_t alone.
struct ForgetPast {
  static void Leave(const Window&, const WindowFrame&, const FeatureNoise&, const ClusterOptions&,
                    Cluster&) {}
};

// States and observations older than T_t go (the last state stays, to predict from), and so do the
// longest unseen landmarks beyond the cap.
void TrimCluster(const Window& window, FrameId newest, const ClusterOptions& options,
                 Cluster& cluster);

// Clusters unseen for live_frames go to the archive; those that were never confirmed are dropped.
void RetireClusters(FrameId newest, int live_frames, const ClusterOptions& options,
                    ClusterMap& map);

// Trajectories of the clusters that were ever confirmed, by id.
std::vector<ClusterTrajectory> ConfirmedTrajectories(const ClusterMap& map,
                                                     const ClusterOptions& options);

// Centre and half sides from the landmarks' 30th and 70th percentiles (METHOD.md 6.2).
void UpdateExtent(const ExtentOptions& options, Cluster& cluster);

}  // namespace cvo
