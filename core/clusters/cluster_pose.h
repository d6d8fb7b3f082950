// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/rng.h"
#include "core/clusters/cluster_track.h"
#include "core/estimation/camera_solver.h"

namespace cvo {

// What the cluster and the feature are given to be does not forbid that one belongs to the other.
bool IsAllowed(const FrameView& view, const Cluster& cluster, int feature);
// object_from_camera from matches, as a CameraSolution whose world is the object: from the
// predicted pose where it can be trusted (is_predicted) and explains most of them, else by RANSAC.
// Empty where fewer than min_inliers agree.
std::optional<CameraSolution> SolvePose(const ClusterSearch& search, const Cluster& cluster,
                                        const RigidTransform& world_from_object,
                                        const std::vector<Match>& matches, int min_inliers,
                                        bool is_predicted, Rng& rng);
// The track takes the solution's pose and inliers.
void AcceptPose(const FrameView& view, const std::vector<Match>& matches,
                const CameraSolution& solution, TakenFeatures& taken, ClusterTrack& track);
// The features of the frame that were matched move to where they show their landmarks:
// AlignToLandmarks (with align_patches), PlaceLeftOnly.
void PlaceFeatures(const ClusterSearch& search, const Cluster& cluster, const ClusterTrack& track,
                   std::span<StereoFeature> features);

}  // namespace cvo
