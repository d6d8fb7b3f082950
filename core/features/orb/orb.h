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
#include "core/features/stereo_feature.h"

namespace cvo {

// Builds a pyramid of at most `levels` CV_8UC1 images, each smaller than the one before by
// scale_factor. The pyramid ends before a side would become shorter than min_side_px. All levels
// share one row stride, so that a byte offset means the same displacement at every level. Level 0
// is a copy of the image. Each level is surrounded by `padding_px` pixels of its mirrored edges
// (see Padded).
std::vector<cv::Mat> BuildPyramid(const cv::Mat& image, int levels, double scale_factor,
                                  int min_side_px, int padding_px = 0);

// Allocates an image of this size with undefined content. It is a view into a buffer with
// `padding_px` more pixels on every side and rows of `stride` bytes.
cv::Mat AllocatePadded(const cv::Size& size, std::size_t stride, int padding_px);

// Returns the image together with its padding. The image must be a pyramid level or come from
// AllocatePadded.
cv::Mat Padded(const cv::Mat& image, int padding_px);

// Fills the padding of the image with its mirrored edges, without repeating the outermost row and
// column.
void MirrorEdges(const cv::Mat& image, int padding_px);

// Converts pixel coordinates between a pyramid level and the full image. Pixel centres are at
// integers, so u_full + 1/2 = (u_level + 1/2) scale, where scale is the exact ratio of the rounded
// sizes. Without the halves, corners would move by up to 1.3 px when their octave changes.
class LevelCoordinates {
 public:
  LevelCoordinates(const std::vector<cv::Mat>& pyramid, int level)
      : scale_x_(static_cast<double>(pyramid[0].cols) / pyramid[level].cols),
        scale_y_(static_cast<double>(pyramid[0].rows) / pyramid[level].rows) {}

  double FullU(double u_level) const { return (u_level + 0.5) * scale_x_ - 0.5; }
  double FullV(double v_level) const { return (v_level + 0.5) * scale_y_ - 0.5; }
  double LevelU(double u_full) const { return (u_full + 0.5) / scale_x_ - 0.5; }
  double LevelV(double v_full) const { return (v_full + 0.5) / scale_y_ - 0.5; }
  double scale_x() const { return scale_x_; }

 private:
  double scale_x_;
  double scale_y_;
};

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
