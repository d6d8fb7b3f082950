// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/association/image_box.h"

namespace cvo {

// What the rows of a detection network's output mean.
enum class OutputLayout {
  kDarknet,  // N x (5 + classes), one per layer: centre and size as fractions of the input
  kYolox,    // 1 x N x (5 + classes): offsets within cells of 8, 16 and 32 px, logarithms of sizes
  kYolov5,   // 1 x 3N x (5 + classes): centre and size in pixels of the input
  kYolov8    // 1 x (4 + classes) x N: the same without the score of there being an object
};
constexpr std::array<const char*, 4> EnumNames(OutputLayout) {
  return {"darknet", "yolox", "yolov5", "yolov8"};
}

// That of an output with these sizes for an input of `size`; empty for one that is none of them.
std::optional<OutputLayout> LayoutOf(const std::vector<int>& output_sizes, const cv::Size& size);

struct RawBox {
  ImageBox box;  // in pixels of the input
  int category = 0;
  double score = 0.0;  // of its best class, times that of an object where the network has one
};

// Boxes of at least `min_score`. Throws Error unless each row is of `categories` classes.
std::vector<RawBox> DecodeOutput(const cv::Mat& output, OutputLayout layout, const cv::Size& size,
                                 int categories, double min_score);

// Of boxes of one class that overlap by more than `max_overlap` (intersection over union), the one
// of highest score; best first.
std::vector<RawBox> SuppressOverlaps(std::vector<RawBox> boxes, double max_overlap);

}  // namespace cvo
