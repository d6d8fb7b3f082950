// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/landmark_alignment.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/stereo_camera.h"

namespace cvo {
namespace {

// The reference is renewed if the scales differ by more than this factor.
constexpr double kMaxZoom = 1.25;
// Patches whose scales differ by more than this factor are not compared: samples would leave them.
constexpr double kMaxComparedZoom = 1.5;

double LevelScale(double scale_factor, const StereoFeature& feature) {
  return std::pow(scale_factor, feature.octave);
}

bool IsWithin(double zoom, double limit) { return zoom <= limit && zoom * limit >= 1.0; }

}  // namespace

void AlignToLandmarks(double scale_factor, const RigidTransform& camera_from_object,
                      const std::vector<Landmark>& landmarks, const std::vector<Match>& matches,
                      std::span<StereoFeature> features) {
  for (const Match& match : matches) {
    const Landmark& landmark = landmarks[match.landmark];
    StereoFeature& feature = features[match.feature];
    feature.is_aligned = false;  // it may have been aligned with another landmark
    const double depth_m = (camera_from_object * landmark.p_in_object).z();
    const double scale = LevelScale(scale_factor, feature);
    const double zoom =
        landmark.reference.size_m / (std::max(depth_m, StereoCamera::kMinDepth_m) * scale);
    if (!IsWithin(zoom, kMaxComparedZoom)) continue;
    const auto shift = AlignFeaturePatch(landmark.reference.patch, feature.patch, zoom);
    if (!shift) continue;
    feature.patch.corner_u += static_cast<float>(shift->x());
    feature.patch.corner_v += static_cast<float>(shift->y());
    feature.z_px += scale * Eigen::Vector3d(shift->x(), shift->y(), shift->x());
    feature.is_aligned = true;
  }
}

void UpdateReference(double scale_factor, const StereoFeature& feature, Landmark& landmark) {
  const double size_m = landmark.depth_m * LevelScale(scale_factor, feature);
  const bool is_kept = feature.is_aligned && IsWithin(landmark.reference.size_m / size_m, kMaxZoom);
  if (!is_kept) landmark.reference = {feature.patch, size_m};
}

}  // namespace cvo
