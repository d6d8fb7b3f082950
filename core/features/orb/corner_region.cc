// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/orb/corner_region.h"

#include <algorithm>
#include <cmath>

namespace cvo {

std::vector<CornerRegion> LeftRegions(const std::vector<cv::Rect2d>& boxes, const OrbOptions& orb) {
  std::vector<CornerRegion> regions;
  for (const cv::Rect2d& box : boxes) regions.push_back({box, orb.box_features});
  return regions;
}

std::vector<CornerRegion> RightRegions(const std::vector<cv::Rect2d>& boxes, const OrbOptions& orb,
                                       const StereoMatchOptions& stereo,
                                       const StereoCamera& camera) {
  const double max_disparity_px = camera.fx / stereo.min_depth_baselines;
  std::vector<CornerRegion> regions;
  for (const cv::Rect2d& box : boxes) {
    const double left_px = std::max(0.0, box.x - max_disparity_px);
    const cv::Rect2d seen(left_px, box.y, box.x + box.width - left_px, box.height);
    const double widening = seen.width / std::max(1.0, box.width);
    const double corners = std::clamp(orb.box_features * stereo.right_features * widening, 0.0,
                                      static_cast<double>(OrbOptions::kMaxFeatures));
    regions.push_back({seen, static_cast<int>(std::lround(corners))});
  }
  return regions;
}

}  // namespace cvo
