// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/features/options.h"
#include "core/features/orb.h"
#include "core/features/stereo_feature.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// Left corners with their column in the right image: search along rows, mutual and unique best
// descriptor, sub-pixel alignment of patches (METHOD.md 2.2). Order of the left corners is kept.
std::vector<StereoFeature> MatchStereo(const OrbImage& left, const OrbImage& right,
                                       const StereoCamera& camera, const OrbOptions& orb,
                                       const StereoMatchOptions& options);

}  // namespace cvo
