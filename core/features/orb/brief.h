// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/features/descriptor.h"

namespace cvo {

// Pixels around a corner that its orientation and its descriptor may read.
inline constexpr int kOrbPatchRadius = 15;

// Direction from the corner to the intensity centroid of the disc around it, rad in (-pi, pi]
// (Rublee et al. 2011). The disc must lie inside the image.
float PatchAngle(const cv::Mat& image, int x, int y);

// One comparison of the descriptor: bit = I(x0, y0) < I(x1, y1), in the patch's own orientation.
struct BriefTest {
  float x0, y0, x1, y1;
};

// The 256 comparisons. In the spirit of ORB they are chosen greedily to be uncorrelated with each
// other and with the orientation, but over a model of images (isotropic, exponential correlation)
// instead of a training set, from seeded draws.
const std::vector<BriefTest>& BriefPattern();

// Rotated comparisons on images of one row stride; the patch must lie inside the (blurred) image.
class BriefDescriber {
 public:
  explicit BriefDescriber(std::size_t row_stride);

  Descriptor Describe(const cv::Mat& blurred, int x, int y, float angle_rad) const;

 private:
  std::vector<std::int32_t> offsets_;  // by angle bin, test and end
};

}  // namespace cvo
