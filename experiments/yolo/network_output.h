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

// Meaning of the rows of a detection network's output.
enum class OutputLayout {
  kDarknet,  // N x (5 + classes), one per layer: centre and size as fractions of the input
  kYolox,    // 1 x N x (5 + classes): offsets in cells of 8, 16 and 32 px, logarithms of sizes
  kYolov5,   // 1 x 3N x (5 + classes): centre and size in pixels of the input
  kYolov8    // 1 x (4 + classes) x N: as kYolov5, but transposed and without objectness
};
constexpr std::array<const char*, 4> EnumNames(OutputLayout) {
  return {"darknet", "yolox", "yolov5", "yolov8"};
}

// Returns the layout of an output with these sizes, for a network input of `size`. Empty if it is
// none of the known ones.
std::optional<OutputLayout> LayoutOf(const std::vector<int>& output_sizes, const cv::Size& size);

struct RawBox {
  ImageBox box;  // in pixels of the network's input
  int category = 0;
  double score = 0.0;  // of the best class, times objectness if the network has one
};

// Returns the boxes with a score of at least `min_score`. Throws Error unless each row has
// `categories` class scores.
std::vector<RawBox> DecodeOutput(const cv::Mat& output, OutputLayout layout, const cv::Size& size,
                                 int categories, double min_score);

// Non-maximum suppression: of boxes of one class that overlap by more than `max_overlap`
// (intersection over union), keeps the one with the highest score. Sorted by decreasing score.
std::vector<RawBox> SuppressOverlaps(std::vector<RawBox> boxes, double max_overlap);

}  // namespace cvo
