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

// False if the given labels (GivenKnowledge) assign the feature to a body other than the cluster's.
bool IsAllowed(const FrameView& view, const Cluster& cluster, int feature);
// Estimates object_from_camera from matches, as a CameraSolution whose world is the object frame.
// If world_from_object can be trusted (is_predicted), the solution that starts from it is taken,
// provided that at least half of the matches agree with it; otherwise RANSAC is used. Empty if
// fewer than min_inliers matches agree.
std::optional<CameraSolution> SolvePose(const ClusterSearch& search, const Cluster& cluster,
                                        const RigidTransform& world_from_object,
                                        const std::vector<Match>& matches, int min_inliers,
                                        bool is_predicted, Rng& rng);
// Sets the track's pose and matches to the solution and its inliers, and marks the features of the
// inliers as taken.
void AcceptPose(const FrameView& view, const std::vector<Match>& matches,
                const CameraSolution& solution, TakenFeatures& taken, ClusterTrack& track);
// Moves the matched features to where they show their landmarks: AlignToLandmarks (if align_patches
// is set), then PlaceLeftOnly.
void PlaceFeatures(const ClusterSearch& search, const Cluster& cluster, const ClusterTrack& track,
                   std::span<StereoFeature> features);

}  // namespace cvo
