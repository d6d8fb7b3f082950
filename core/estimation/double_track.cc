// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/double_track.h"

#include <algorithm>

#include "core/estimation/window_problem.h"

namespace cvo {

bool PromoteDistant::Promotes(const Window& window, const WindowFrame& frame,
                              const WindowOptions& options) {
  if (window.spatial.empty()) return true;
  const WindowFrame& reference = window.spatial.back();
  const RigidTransform motion = reference.world_from_camera.Inverse() * frame.world_from_camera;
  if (RotationAngle(Eigen::Quaterniond(motion.rotation())) > options.promote_rotation_rad) {
    return true;
  }
  if (motion.translation().norm() >
      options.promote_translation * window.MedianDepth(reference.id)) {
    return true;
  }
  return window.CountCommonLandmarks(reference.id, frame.id) <
         options.promote_common * window.CountLandmarks(reference.id);
}

Vector6d EstimateRightField::Deviation(const NoiseOptions& noise) {
  Vector6d deviation = Vector6d::Constant(noise.right_field_px);
  deviation[0] = noise.right_mean_px;
  return deviation;
}

Vector6d EstimateRightShift::Deviation(const NoiseOptions& noise) {
  constexpr double kNone_px = 1e-6;
  Vector6d deviation = Vector6d::Constant(kNone_px);
  deviation[0] = noise.right_mean_px;
  return deviation;
}

void MarginalizeFrame(FrameId frame, const std::vector<LandmarkId>& landmarks,
                      const FeatureNoise& noise, Window& window) {
  WindowProblem problem = MakeFrames(window);
  for (const Landmark& landmark : window.landmarks) {
    if (std::binary_search(landmarks.begin(), landmarks.end(), landmark.id)) {
      AddLandmark(landmark, noise, problem);
    }
  }
  window.prior = Marginalize(noise.options, problem, frame);
}

}  // namespace cvo
