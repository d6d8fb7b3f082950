// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/association/box_association.h"
#include "core/association/matching.h"
#include "core/base/rng.h"
#include "core/clusters/cluster_map.h"
#include "core/estimation/camera_solver.h"
#include "core/estimation/cluster.h"
#include "core/estimation/motion_extrapolation.h"
#include "core/estimation/window.h"

namespace cvo {

// A cluster extrapolated to the current frame (section 3.1 of the paper).
struct PredictedCluster {
  RigidTransform world_from_object;
  Eigen::Vector3d velocity_m_s = Eigen::Vector3d::Zero();
  double translation_variance_m2 = 0.0;  // of its origin, per axis
  double rotation_variance_rad2 = 0.0;
};

// Extrapolate with the policies of a variant.
using Extrapolation = PredictedMotion(const MotionPriorOptions&, std::span<const MotionState>,
                                      double time_s);

// Predicts the cluster at a time after its latest state.
PredictedCluster PredictCluster(const Cluster& cluster, std::int64_t timestamp_ns,
                                Extrapolation& extrapolate, const MotionPriorOptions& motion);

// Whether position and orientation are each within the gate, in squared deviations, of the
// predicted ones (METHOD.md 4.4).
bool AgreesWithPrediction(const PredictedCluster& predicted,
                          const RigidTransform& world_from_object, double gate);

// Predicts any cluster at one fixed time.
using ClusterPredictor = std::function<PredictedCluster(const Cluster&)>;

// Predicts how the current camera sees a landmark of the cluster. Empty if the landmark is behind
// the camera or outside the image.
std::optional<PredictedLandmark> PredictLandmark(const FrameView& view,
                                                 const PredictedCluster& predicted,
                                                 const Landmark& landmark);

// Result of the association for one live cluster in the current frame.
struct ClusterTrack {
  PredictedCluster predicted;
  RigidTransform world_from_object;  // provisional P_t^q if is_tracked, otherwise predicted
  bool is_tracked = false;           // has a pose in the frame (METHOD.md 4.4, 4.6)
  std::vector<Match> matches;        // inliers: index into cluster.landmarks, feature
  int detection = -1;                // index into the frame's detections; -1: none
  ImageBox box;                      // around its matched or predicted landmarks; unset if detected
};

// False if the given labels (GivenKnowledge) assign the feature to a body other than the cluster's.
bool IsAllowed(const FrameView& view, const Cluster& cluster, int feature);
// Estimates object_from_camera from matches, as a CameraSolution whose world is the object frame.
// If world_from_object can be trusted (is_predicted), the solution that starts from it is taken,
// provided that at least half of the matches agree with it; otherwise RANSAC is used. Empty if
// fewer than min_inliers matches agree.
std::optional<CameraSolution> SolvePose(const FrameView& view, const Cluster& cluster,
                                        const RigidTransform& world_from_object,
                                        const std::vector<Match>& matches, int min_inliers,
                                        bool is_predicted, Rng& rng);
// Sets the track's pose and matches to the solution and its inliers, and marks the features of the
// inliers as taken.
void AcceptPose(const FrameView& view, const std::vector<Match>& matches,
                const CameraSolution& solution, TakenFeatures& taken, ClusterTrack& track);
// Moves the matched features to where they show their landmarks: AlignToLandmarks (if align_patches
// is set), then PlaceLeftOnly.
void PlaceFeatures(const FrameView& view, const Cluster& cluster, const ClusterTrack& track,
                   std::span<StereoFeature> features);

}  // namespace cvo
