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

// Matches left corners to the right image: a search along rows for the mutually best and unique
// descriptor, then sub-pixel patch alignment (METHOD.md 2.2). Unmatched corners in `boxes` are kept
// as left-only features. Preserves the order of the left corners.
std::vector<StereoFeature> MatchStereo(const OrbImage& left, const OrbImage& right,
                                       const StereoCamera& camera, const OrbOptions& orb,
                                       const StereoMatchOptions& options,
                                       const std::vector<cv::Rect2d>& boxes = {});

}  // namespace cvo
