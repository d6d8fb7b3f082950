// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "core/features/descriptor.h"
#include "core/features/feature_patch.h"
#include "core/features/options.h"
#include "core/features/orb/corner_selection.h"
#include "core/features/orb/pyramid.h"
#include "core/features/stereo_feature.h"

namespace cvo {

struct OrbKeypoint {
  float u_px = 0.0F;  // in the full-resolution image
  float v_px = 0.0F;
  int octave = 0;
  float angle_rad = 0.0F;
  float response = 0.0F;
  bool is_reserve = false;  // kept in addition to OrbOptions::features
  // Pixel of the corner at its level, and sub-pixel offset of the corner from the pixel centre.
  int x = 0;
  int y = 0;
  float move_x = 0.0F;
  float move_y = 0.0F;
  Descriptor descriptor{};
};

// Corners of one image, including its reserve, sorted by (v, u, octave), and the pyramid in which
// they were detected.
struct OrbImage {
  std::vector<OrbKeypoint> keypoints;
  std::vector<cv::Mat> pyramid;  // CV_8UC1, level 0 first, each padded with its mirrored edges
};

// Extracts ORB corners spread over the image (METHOD.md 2.1), with a reserve in `regions`. Throws
// Error if the image is empty or not CV_8UC1, or if an option is invalid. Pure function: the same
// image and regions give the same corners on any thread.
OrbImage ExtractOrb(const cv::Mat& image, const OrbOptions& options,
                    std::span<const CornerRegion> regions = {});

// Returns the patch around one of the corners of `image`.
FeaturePatch PatchAround(const OrbImage& image, const OrbKeypoint& keypoint);

}  // namespace cvo
