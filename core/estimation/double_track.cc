// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/double_track.h"

#include <algorithm>

#include "core/estimation/window_problem.h"

namespace cvo {

namespace {

bool IsFar(const Window& window, const WindowFrame& reference, const WindowFrame& frame,
           const WindowOptions& options) {
  const double distance_m =
      (reference.world_from_camera.translation() - frame.world_from_camera.translation()).norm();
  return distance_m > options.promote_translation * window.MedianDepth(reference.id) ||
         window.CountCommonLandmarks(reference.id, frame.id) <
             options.promote_common * window.CountLandmarks(reference.id);
}

}  // namespace

bool PromoteFarFromFirst::Promotes(const Window& window, const WindowFrame& frame,
                                   const WindowOptions& options) {
  return window.spatial.empty() || IsFar(window, window.spatial.front(), frame, options);
}

bool PromoteDistant::Promotes(const Window& window, const WindowFrame& frame,
                              const WindowOptions& options) {
  if (window.spatial.empty()) return true;
  const WindowFrame& newest = window.spatial.back();
  const RigidTransform motion = newest.world_from_camera.Inverse() * frame.world_from_camera;
  return RotationAngle(Eigen::Quaterniond(motion.rotation())) > options.promote_rotation_rad ||
         IsFar(window, newest, frame, options);
}

Vector6d CalibrationDeviation(const NoiseOptions& noise) {
  // Negligible, but not so small that its information hides that of the frames (kRelativeRank).
  constexpr double kNone_px = 1e-3;
  Vector6d deviation = Vector6d::Constant(std::max(noise.right_field_px, kNone_px));
  deviation[0] = std::max(noise.right_mean_px, kNone_px);
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
