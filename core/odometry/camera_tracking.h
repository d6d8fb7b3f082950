// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/association/matching.h"
#include "core/base/rng.h"
#include "core/estimation/window.h"
#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"
#include "core/interface/options.h"

namespace cvo {

// Constant-velocity model of the camera in its own frame, rad/s and m/s, from the last two poses.
class MotionModel {
 public:
  // Sets the pose of the camera at a time; timestamps must increase.
  void Update(std::int64_t timestamp_ns, const RigidTransform& world_from_camera);
  // Predicts the pose of the camera; the identity before the first update.
  RigidTransform Predict(std::int64_t timestamp_ns) const;
  bool HasVelocity() const { return updates_ > 1; }

 private:
  int updates_ = 0;
  std::int64_t timestamp_ns_ = 0;
  RigidTransform world_from_camera_;
  // [rotation, translation] of previous_camera_from_camera, per second.
  Vector6d velocity_ = Vector6d::Zero();
};

struct CameraTrack {
  RigidTransform world_from_camera;
  std::vector<Match> inliers;  // indices into window.landmarks and the frame's features
  int matches = 0;             // number before the geometric check
};

// Expected camera pose, around which the search starts.
struct ExpectedCamera {
  RigidTransform world_from_camera;
  bool is_given = false;  // the pose is given and not estimated
  // Predicted from the preceding motion; otherwise the camera may have moved arbitrarily.
  bool has_motion = false;
};

// Estimates the camera pose of a frame from the landmarks of the window: a windowed search around
// the expected camera, a robust solve, a second, narrower search around the solution, alignment of
// the matched patches (which moves `features`, those of the grid), and a second solve. Before the
// second search, the first solution competes with the expected camera and, if it is in doubt, with
// one found from descriptors alone (METHOD.md 3.3). Empty if fewer than tracking.min_inliers
// landmarks agree.
std::optional<CameraTrack> TrackCamera(const Options& options, const Window& window,
                                       const FeatureGrid& grid, std::span<StereoFeature> features,
                                       const ExpectedCamera& expected, Rng& rng);

}  // namespace cvo
