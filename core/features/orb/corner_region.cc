// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/orb/corner_region.h"

#include <algorithm>
#include <cmath>

namespace cvo {

namespace {

constexpr double kGrowth = 0.1;  // of the size of a box, on each side and per frame

cv::Rect2d Grown(const cv::Rect2d& box, int frames) {
  const double x = kGrowth * frames * box.width;
  const double y = kGrowth * frames * box.height;
  return {box.x - x, box.y - y, box.width + 2.0 * x, box.height + 2.0 * y};
}

bool HasCenterOf(const cv::Rect2d& box, const CornerRegion& region) {
  return region.box.contains({box.x + 0.5 * box.width, box.y + 0.5 * box.height});
}

}  // namespace

std::vector<CornerRegion> LeftRegions(RecentBoxes boxes, const OrbOptions& orb) {
  std::vector<CornerRegion> regions;
  const int frames = std::min(orb.reserve_frames, static_cast<int>(boxes.size()));
  for (int age = 0; age < frames; ++age) {
    const std::size_t newer = regions.size();
    for (const cv::Rect2d& box : boxes[boxes.size() - 1 - static_cast<std::size_t>(age)]) {
      const bool is_seen_again =
          std::any_of(regions.begin(), regions.begin() + static_cast<std::ptrdiff_t>(newer),
                      [&](const CornerRegion& region) { return HasCenterOf(box, region); });
      if (!is_seen_again) regions.push_back({Grown(box, age), age == 0 ? orb.box_features : 0});
    }
  }
  return regions;
}

std::vector<CornerRegion> RightRegions(std::vector<CornerRegion> regions,
                                       const StereoMatchOptions& stereo,
                                       const StereoCamera& camera) {
  const double max_disparity_px = camera.fx / stereo.min_depth_baselines;
  for (CornerRegion& region : regions) {
    cv::Rect2d& box = region.box;
    const double left_px = std::max(0.0, box.x - max_disparity_px);
    const cv::Rect2d seen(left_px, box.y, box.x + box.width - left_px, box.height);
    const double widening = seen.width / std::max(1.0, box.width);
    const double corners = std::clamp(region.corners * stereo.right_features * widening, 0.0,
                                      static_cast<double>(OrbOptions::kMaxFeatures));
    region = {seen, static_cast<int>(std::lround(corners))};
  }
  return regions;
}

}  // namespace cvo
