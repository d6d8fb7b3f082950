// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/features/descriptor.h"

namespace cvo {

// Radius, px, of the patch around a corner from which its orientation and descriptor are computed.
inline constexpr int kOrbPatchRadius = 15;

// Direction from the corner to the intensity centroid of the disc around it, rad in (-pi, pi]
// (Rublee et al. 2011). The disc must lie inside the image.
float PatchAngle(const cv::Mat& image, int x, int y);

// Computes descriptors in images with the given row stride. The patch must lie inside the (blurred)
// image.
class BriefDescriber {
 public:
  explicit BriefDescriber(std::size_t row_stride);

  Descriptor Describe(const cv::Mat& blurred, int x, int y, float angle_rad) const;

 private:
  std::vector<std::int32_t> offsets_;  // by angle bin, test and end point
};

}  // namespace cvo
