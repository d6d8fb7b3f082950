// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

namespace cvo {

// Levels of CV_8UC1, each scale_factor smaller than the one before, at most `levels`: it ends
// before a side would fall under min_side_px. All levels share one row stride, so that an offset in
// bytes means the same displacement at each. Level 0 is a copy of the image. `padding_px` pixels
// around each are its mirrored edges (Padded).
std::vector<cv::Mat> BuildPyramid(const cv::Mat& image, int levels, double scale_factor,
                                  int min_side_px, int padding_px = 0);

// An image of this size with undefined content, a view into one that is `padding_px` larger on
// every side and has rows of `stride` bytes.
cv::Mat AllocatePadded(const cv::Size& size, std::size_t stride, int padding_px);

// A level, or what AllocatePadded gave, with the pixels around it.
cv::Mat Padded(const cv::Mat& image, int padding_px);

// Sets the pixels around it to its mirrored edges, the outermost row and column left out.
void MirrorEdges(const cv::Mat& image, int padding_px);

// Pixel coordinates at a level and in the full image. Centres of pixels are at integers, so
// u_full + 1/2 = (u_level + 1/2) scale, with the scale that the rounded sizes really have: leaving
// out the halves would move corners by up to 1.3 px when their octave changes.
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
