// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <vector>

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

}  // namespace cvo
