// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/association/feature_grid.h"
#include "core/association/match.h"
#include "core/association/projected_matching.h"
#include "core/base/rng.h"
#include "core/estimation/window.h"
#include "core/features/options.h"
#include "core/geometry/stereo_camera.h"
#include "core/interface/tracking_options.h"
#include "core/solvers/measurement_noise.h"

namespace cvo {

// What the camera is tracked with.
struct CameraTrackingOptions {
  FeatureNoise noise;
  OrbOptions orb;
  MatchingOptions matching;
  TrackingOptions tracking;
};

struct CameraTrack {
  RigidTransform world_from_camera;
  std::vector<Match> inliers;  // indices into window.landmarks and the frame's features
  int matches = 0;             // before the geometric check
};

// The camera of a frame from the landmarks of the window: windowed search around the predicted
// camera, robust solve, a second, narrower search around the solution, alignment of the patches
// that it finds (`features`, those of the grid, move), solve again. Where the first search finds
// too little, all recent descriptors are compared instead and RANSAC finds the camera. Empty where
// fewer than tracking.min_inliers landmarks agree. A given camera is taken as it is.
std::optional<CameraTrack> TrackCamera(const CameraTrackingOptions& options, const Window& window,
                                       const FeatureGrid& grid, std::span<StereoFeature> features,
                                       const RigidTransform& predicted_world_from_camera,
                                       bool is_given, Rng& rng);

}  // namespace cvo
