// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/yolo/letterbox.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace cvo {

ImageBox Letterbox::ToImage(const ImageBox& in_input) const {
  return {(in_input.left_px - offset_x_px) / scale, (in_input.top_px - offset_y_px) / scale,
          (in_input.right_px - offset_x_px) / scale, (in_input.bottom_px - offset_y_px) / scale};
}

Letterbox FillInput(const cv::Mat& image, const cv::Size& size, Placement placement,
                    cv::Mat& input) {
  constexpr int kFill = 114;
  Letterbox box;
  box.scale = std::min(static_cast<double>(size.width) / image.cols,
                       static_cast<double>(size.height) / image.rows);
  const cv::Size scaled(std::max(1, static_cast<int>(std::lround(box.scale * image.cols))),
                        std::max(1, static_cast<int>(std::lround(box.scale * image.rows))));
  const cv::Point corner =
      placement == Placement::kTopLeft
          ? cv::Point(0, 0)
          : cv::Point((size.width - scaled.width) / 2, (size.height - scaled.height) / 2);
  box.offset_x_px = corner.x;
  box.offset_y_px = corner.y;
  input.create(size, CV_8UC3);
  input.setTo(cv::Scalar::all(kFill));
  cv::resize(image, input(cv::Rect(corner, scaled)), scaled, 0.0, 0.0, cv::INTER_LINEAR);
  return box;
}

}  // namespace cvo
