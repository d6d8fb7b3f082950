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

// Where the camera is looked for.
struct ExpectedCamera {
  RigidTransform world_from_camera;
  bool is_given = false;    // taken as it is
  bool has_motion = false;  // continues the motion before; else it may have moved in any way
};

// The camera of a frame from the landmarks of the window: windowed search around the expected
// camera, robust solve, a second, narrower search around the solution, alignment of the patches
// that it finds (`features`, those of the grid, move), solve again. The first solution competes
// with the expected camera and, where it is in doubt, with one found from descriptors alone
// (METHOD.md 3.3). Empty where fewer than tracking.min_inliers landmarks agree.
std::optional<CameraTrack> TrackCamera(const CameraTrackingOptions& options, const Window& window,
                                       const FeatureGrid& grid, std::span<StereoFeature> features,
                                       const ExpectedCamera& expected, Rng& rng);

}  // namespace cvo
