// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/types.hpp>
#include <vector>

#include "core/features/options.h"
#include "core/features/orb/orb.h"
#include "core/features/stereo_feature.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// Left corners with their column in the right image: search along rows, mutual and unique best
// descriptor, sub-pixel alignment of patches (METHOD.md 2.2). Corners in `boxes` without one are
// kept as features of the left image alone. Order of the left corners is kept.
std::vector<StereoFeature> MatchStereo(const OrbImage& left, const OrbImage& right,
                                       const StereoCamera& camera, const OrbOptions& orb,
                                       const StereoMatchOptions& options,
                                       const std::vector<cv::Rect2d>& boxes = {});

}  // namespace cvo
