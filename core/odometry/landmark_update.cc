// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/odometry/landmark_update.h"

#include <algorithm>

namespace cvo {
namespace {

void Observe(const StereoFeature& feature, const WindowFrame& frame, double depth_m,
             Landmark& landmark) {
  landmark.observations.push_back({frame.id, feature.z_px, feature.octave});
  landmark.descriptor = feature.descriptor;
  landmark.depth_m = depth_m;
  landmark.last_seen = frame.id;
}

}  // namespace

void AddObservations(const WindowFrame& frame, std::span<const StereoFeature> features,
                     const std::vector<Match>& matches, Window& window) {
  const RigidTransform camera_from_world = frame.world_from_camera.Inverse();
  for (const Match& match : matches) {
    Landmark& landmark = window.landmarks[match.landmark];
    const double depth_m = (camera_from_world * landmark.p_in_world).z();
    Observe(features[match.feature], frame, std::max(depth_m, StereoCamera::kMinDepth_m), landmark);
  }
}

int AddLandmarks(const WindowFrame& frame, std::span<const StereoFeature> features,
                 const std::vector<Match>& matches, double min_disparity_px, LandmarkId& next_id,
                 Window& window) {
  std::vector<char> is_matched(features.size(), 0);
  for (const Match& match : matches) is_matched[match.feature] = 1;
  int added = 0;
  for (std::size_t i = 0; i < features.size(); ++i) {
    const Eigen::Vector3d& z = features[i].z_px;
    if (is_matched[i] || window.camera.Disparity(z) < min_disparity_px) continue;
    const auto p_in_camera = window.camera.BackProject(z);
    if (!p_in_camera) continue;
    Landmark landmark;
    landmark.id = next_id;
    landmark.p_in_world = frame.world_from_camera * *p_in_camera;
    Observe(features[i], frame, p_in_camera->z(), landmark);
    window.landmarks.push_back(std::move(landmark));
    ++next_id.value;
    ++added;
  }
  return added;
}

void RemoveUnconfirmed(FrameId newest, int frames, Window& window) {
  std::erase_if(window.landmarks, [&](const Landmark& landmark) {
    return landmark.observations.size() == 1 && landmark.last_seen.value <= newest.value - frames;
  });
}

}  // namespace cvo
