// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/odometry/cluster_association.h"

namespace cvo {

// Where a body is, judged by its box and the nearest points in it alone: near its centre.
struct BoxFix {
  Eigen::Vector3d center_in_world = Eigen::Vector3d::Zero();
  double size_m = 0.0;  // smaller side of the box at the body's depth
};

// From surface points of the body (columns, in world) seen in the detection's box: their median,
// moved away from the camera by clusters.birth_depth of the box's smaller side.
BoxFix FixFromSurface(const FrameView& view, const Detection& detection,
                      const Eigen::Vector3d& surface_in_world);

// The same from the features in the box that are no cluster's (a body that stopped while it was
// lost has become static); empty where too few make a foreground.
std::optional<BoxFix> FixInBox(const FrameView& view, const Detection& detection,
                               const std::vector<ClusterTrack>& tracks);

// How far the fix is from where the cluster is predicted, in standard deviations.
double RelocationDistance(const BoxFix& fix, const PredictedCluster& predicted);

// None of the cluster's landmarks was found, but its box was: the body turned its back while it was
// hidden. It goes on from there, with its predicted rotation, under the same id.
void Relocate(const BoxFix& fix, int detection, ClusterTrack& track);

}  // namespace cvo
