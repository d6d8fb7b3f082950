// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/left_only.h"

namespace cvo {

void PlaceLeftOnly(const StereoCamera& camera, const RigidTransform& camera_from_object,
                   const std::vector<Landmark>& landmarks, const std::vector<Match>& matches,
                   std::span<StereoFeature> features) {
  for (const Match& match : matches) {
    StereoFeature& feature = features[match.feature];
    if (!IsLeftOnly(feature)) continue;
    const auto zeta_px = camera.Project(camera_from_object * landmarks[match.landmark].p_in_object);
    if (zeta_px) feature.z_px[2] = feature.z_px[0] + (*zeta_px)[2] - (*zeta_px)[0];
  }
}

}  // namespace cvo
