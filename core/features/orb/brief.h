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

// One intensity comparison of the descriptor: bit = I(x0, y0) < I(x1, y1). Coordinates are relative
// to the corner and rotate with the orientation of the patch.
struct BriefTest {
  float x0, y0, x1, y1;
};

// The 256 comparisons of the descriptor. As in ORB, they are chosen greedily to be uncorrelated
// with each other and with the orientation, but under a statistical image model (isotropic,
// exponential correlation) instead of over a training set. Candidates are seeded random draws.
const std::vector<BriefTest>& BriefPattern();

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
