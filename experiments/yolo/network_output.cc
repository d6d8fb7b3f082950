// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/yolo/network_output.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace cvo {
namespace {

constexpr std::array<int, 3> kCells_px = {8, 16, 32};

int CellCount(const cv::Size& size) {
  int count = 0;
  for (const int cell : kCells_px) count += (size.width / cell) * (size.height / cell);
  return count;
}

// The output as a matrix of floats with one box per row.
cv::Mat RowsOf(const cv::Mat& output, OutputLayout layout) {
  if (layout == OutputLayout::kDarknet) return output;
  const cv::Mat plane(output.size[1], output.size[2], CV_32F, const_cast<uchar*>(output.data));
  return layout == OutputLayout::kYolov8 ? cv::Mat(plane.t()) : plane;
}

struct CenteredBox {
  double x, y, width, height;
};

// Decodes a box relative to its cell. The cells are ordered by size, the smallest first, then row
// by row.
CenteredBox FromCell(const CenteredBox& box, int row, const cv::Size& size) {
  for (const int cell : kCells_px) {
    const int columns = size.width / cell;
    const int count = columns * (size.height / cell);
    if (row >= count) {
      row -= count;
      continue;
    }
    return {(box.x + row % columns) * cell, (box.y + row / columns) * cell,
            std::exp(box.width) * cell, std::exp(box.height) * cell};
  }
  throw Error("FromCell: no such cell");
}

CenteredBox ToPixels(const CenteredBox& box, OutputLayout layout, int row, const cv::Size& size) {
  switch (layout) {
    case OutputLayout::kDarknet:
      return {box.x * size.width, box.y * size.height, box.width * size.width,
              box.height * size.height};
    case OutputLayout::kYolox:
      return FromCell(box, row, size);
    case OutputLayout::kYolov5:
    case OutputLayout::kYolov8:
      return box;
  }
  throw Error("OutputLayout: not one of the enumerators");
}

}  // namespace

std::optional<OutputLayout> LayoutOf(const std::vector<int>& output_sizes, const cv::Size& size) {
  if (output_sizes.size() == 2) return OutputLayout::kDarknet;
  if (output_sizes.size() != 3 || output_sizes[0] != 1) return std::nullopt;
  const int cells = CellCount(size);
  if (output_sizes[1] == cells) return OutputLayout::kYolox;
  if (output_sizes[1] == 3 * cells) return OutputLayout::kYolov5;
  if (output_sizes[2] == cells) return OutputLayout::kYolov8;
  return std::nullopt;
}

std::vector<RawBox> DecodeOutput(const cv::Mat& output, OutputLayout layout, const cv::Size& size,
                                 int categories, double min_score) {
  const cv::Mat rows = RowsOf(output, layout);
  const bool has_objectness = layout != OutputLayout::kYolov8;
  const int first = has_objectness ? 5 : 4;
  if (rows.cols != first + categories) {
    ThrowError("model", StrCat(rows.cols - first, " classes"),
               StrCat(categories, ", as many as names"));
  }
  std::vector<RawBox> boxes;
  for (int i = 0; i < rows.rows; ++i) {
    const float* row = rows.ptr<float>(i);
    const float* best = std::max_element(row + first, row + rows.cols);
    // Darknet's class scores already include objectness.
    const bool times_objectness = has_objectness && layout != OutputLayout::kDarknet;
    const double score = *best * (times_objectness ? static_cast<double>(row[4]) : 1.0);
    if (!(score >= min_score)) continue;
    const CenteredBox box = ToPixels({row[0], row[1], row[2], row[3]}, layout, i, size);
    boxes.push_back({{box.x - 0.5 * box.width, box.y - 0.5 * box.height, box.x + 0.5 * box.width,
                      box.y + 0.5 * box.height},
                     static_cast<int>(best - (row + first)),
                     score});
  }
  return boxes;
}

std::vector<RawBox> SuppressOverlaps(std::vector<RawBox> boxes, double max_overlap) {
  std::stable_sort(boxes.begin(), boxes.end(),
                   [](const RawBox& a, const RawBox& b) { return a.score > b.score; });
  std::vector<RawBox> kept;
  for (const RawBox& box : boxes) {
    const bool hidden = std::any_of(kept.begin(), kept.end(), [&](const RawBox& better) {
      return better.category == box.category &&
             IntersectionOverUnion(better.box, box.box) > max_overlap;
    });
    if (!hidden) kept.push_back(box);
  }
  return kept;
}

}  // namespace cvo
