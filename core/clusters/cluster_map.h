// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <map>
#include <vector>

#include "core/association/matching.h"
#include "core/clustering/point_extent.h"
#include "core/estimation/cluster.h"
#include "core/estimation/window.h"
#include "core/geometry/stereo_camera.h"
#include "core/interface/cluster_options.h"
#include "core/interface/frame.h"

namespace cvo {

// What is known of a frame while it is processed.
struct FrameView {
  const StereoFrame& frame;
  ShownBodies shown;
  const FeatureGrid& grid;
  StereoCamera camera;
  RigidTransform world_from_camera;
  const Options& options;
};

// By feature: nonzero if it is already matched.
using TakenFeatures = std::vector<char>;

// The part of the estimator's state that describes moving bodies.
struct ClusterMap {
  std::vector<Cluster> live;                            // sorted by id; some not yet confirmed
  std::map<ClusterId, ClusterTrajectory> trajectories;  // of live clusters and confirmed past ones
  ClusterId next{1};
};

inline bool IsConfirmed(const Cluster& cluster, const ClusterOptions& options) {
  return cluster.detections >= options.confirm_detections || cluster.given_body.valid();
}

// The largest side of the body, m. That of a uniform solid is five of its half sides (METHOD.md
// 6.2).
inline double Size_m(const Cluster& cluster) { return 5.0 * cluster.half_size_m.maxCoeff(); }

// Returns the first pose in `frame` or later, as an iterator. Poses are sorted by frame.
auto FirstPoseFrom(std::int64_t frame, auto& trajectory) {
  return std::lower_bound(trajectory.poses.begin(), trajectory.poses.end(), frame,
                          [](const ClusterPose& pose, std::int64_t f) { return pose.frame < f; });
}

// Turns the cluster's observations in a frame that leaves T_t into past information on their
// landmarks (METHOD.md 8.4). The frame is no longer in the window. Nothing happens if
// options.max_past_observations is 0, as in the paper, where a cluster's energy covers T_t alone.
void AbsorbObservations(const Window& window, const WindowFrame& leaving, const FeatureNoise& noise,
                        const ClusterOptions& options, Cluster& cluster);

// Removes observations older than T_t, landmarks left without observations and past information,
// and, beyond options.max_landmarks, the landmarks unseen for longest. If the cluster was observed
// in the newest frame, also removes states older than T_t, but never the last one.
void TrimCluster(const Window& window, FrameId newest, const ClusterOptions& options,
                 Cluster& cluster);

// Removes clusters that were not observed for live_frames frames, or that stand still and were not
// detected for options.undetected_frames frames, nor for as many as they were ever detected in; and
// unconfirmed ones, with their trajectories, if they were not detected for options.confirm_frames
// frames.
void RetireClusters(FrameId newest, int live_frames, const ClusterOptions& options,
                    ClusterMap& map);

// Returns the trajectories of all clusters that were ever confirmed, sorted by id.
std::vector<ClusterTrajectory> ConfirmedTrajectories(const ClusterMap& map,
                                                     const ClusterOptions& options);

// Sets the cluster's centre and half sides from the 30th and 70th percentiles of its landmarks'
// coordinates (METHOD.md 6.2).
void UpdateExtent(Cluster& cluster);

}  // namespace cvo
