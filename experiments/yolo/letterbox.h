// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/association/image_box.h"

namespace cvo {

// Placement of an image in a network's input: the scale is the same in x and y, and the rest is
// filled.
struct Letterbox {
  double scale = 1.0;  // p_in_input = scale * p_in_image + offset
  double offset_x_px = 0.0;
  double offset_y_px = 0.0;

  // Maps a box in the input to pixels of the image.
  ImageBox ToImage(const ImageBox& in_input) const;
};

enum class Placement { kCentered, kTopLeft };

// Makes `input`, of the given size, from a CV_8UC3 image. The rest is filled with grey level 114.
Letterbox FillInput(const cv::Mat& image, const cv::Size& size, Placement placement,
                    cv::Mat& input);

}  // namespace cvo
