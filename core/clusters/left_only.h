// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/association/match.h"
#include "core/estimation/landmark.h"
#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// Gives features found in the left image only, and matched with landmarks of a body, the disparity
// that the body's pose predicts for these landmarks (METHOD.md 4.7).
void PlaceLeftOnly(const StereoCamera& camera, const RigidTransform& camera_from_object,
                   const std::vector<Landmark>& landmarks, const std::vector<Match>& matches,
                   std::span<StereoFeature> features);

}  // namespace cvo
