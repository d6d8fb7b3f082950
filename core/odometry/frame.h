// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/features/stereo_feature.h"
#include "core/geometry/rigid_transform.h"

namespace cvo {

// What the front end makes of one stereo pair; what the estimator is given.
struct StereoFrame {
  std::int64_t timestamp_ns = 0;  // strictly increasing from frame to frame
  std::vector<StereoFeature> features;
};

enum class FrameStatus {
  kFirst,      // starts the map: the pose is the identity or, after a restart, the prediction
  kTracked,    // pose from at least min_inliers landmarks
  kRecovered,  // tracked again after at least one lost frame
  kLost,       // too few landmarks: the pose is predicted
  kSkipped,    // no image: the pose is predicted
};
const char* ToString(FrameStatus status);

// What the estimator says of one frame.
struct FrameReport {
  FrameStatus status = FrameStatus::kFirst;
  RigidTransform world_from_camera;  // world = left camera of the first frame
  int features = 0;                  // stereo features in the frame
  int matches = 0;                   // landmarks found in the frame
  int inliers = 0;                   // of these, consistent with the camera pose
  int new_landmarks = 0;
  int window_frames = 0;        // spatial and temporal track together, this frame included
  int window_landmarks = 0;     // optimised with the window
  int window_iterations = 0;    // of the bundle adjustment
  double right_shift_px = 0.0;  // as estimated so far (StereoCamera)
  double mean_error_px = 0.0;   // RMS whitened reprojection error of the inliers after it
};

}  // namespace cvo
