// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "core/features/feature_patch.h"
#include "core/features/options.h"
#include "core/features/orb/corner_region.h"
#include "core/features/stereo_feature.h"

namespace cvo {

struct OrbKeypoint {
  float u_px = 0.0F;  // in the full image
  float v_px = 0.0F;
  int octave = 0;
  float angle_rad = 0.0F;
  float response = 0.0F;
  bool is_reserve = false;  // beyond OrbOptions::features
  // Of its level: the pixel, and the corner from that pixel's centre.
  int x = 0;
  int y = 0;
  float move_x = 0.0F;
  float move_y = 0.0F;
  Descriptor descriptor{};
};

// Corners of one image and of its reserve, sorted by (v, u, octave), and the pyramid they were
// found in.
struct OrbImage {
  std::vector<OrbKeypoint> keypoints;
  std::vector<cv::Mat> pyramid;  // CV_8UC1, level 0 first, with mirrored edges around each level
};

// ORB corners spread over the image (METHOD.md 2.1), with a reserve in `regions`. `image` is
// CV_8UC1. Pure: the same image and regions give the same corners on any thread.
OrbImage ExtractOrb(const cv::Mat& image, const OrbOptions& options,
                    std::span<const CornerRegion> regions = {});

// The pixels around one of the image's corners.
FeaturePatch PatchAround(const OrbImage& image, const OrbKeypoint& keypoint);

}  // namespace cvo
