// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/sheet.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "reports/overlays/drawing/draw_overlay.h"
#include "reports/overlays/drawing/text_plate.h"

namespace cvo::reports {
namespace {

constexpr int kGap_px = 4;
constexpr Rgb kGapColor{255, 255, 255};
constexpr Rgb kEmptyColor{24, 24, 28};  // as in the bars below the pictures

// Arranges images of one size in rows. Throws Error if their sizes differ.
cv::Mat Grid(const std::vector<cv::Mat>& images, int columns) {
  const cv::Size size = images.front().size();
  const int count = static_cast<int>(images.size());
  const int rows = (count + columns - 1) / columns;
  cv::Mat grid(rows * (size.height + kGap_px) - kGap_px, columns * (size.width + kGap_px) - kGap_px,
               CV_8UC3, Bgr(kGapColor));
  const auto place = [&](int i) {
    return cv::Rect({i % columns * (size.width + kGap_px), i / columns * (size.height + kGap_px)},
                    size);
  };
  for (int i = count; i < rows * columns; ++i) grid(place(i)).setTo(Bgr(kEmptyColor));
  for (int i = 0; i < count; ++i) {
    const cv::Mat& image = images[static_cast<std::size_t>(i)];
    if (image.size() != size) {
      ThrowError("images side by side", StrCat(image.cols, "x", image.rows, " pixels"),
                 StrCat(size.width, "x", size.height, ", as the first has"));
    }
    image.copyTo(grid(place(i)));
  }
  return grid;
}

}  // namespace

cv::Mat Panels(const std::vector<TitledImage>& images, int text_px, int columns) {
  Require(!images.empty(), "Panels: at least one image");
  std::vector<cv::Mat> panels;
  for (const TitledImage& image : images) {
    cv::Mat bar(BarHeight(text_px, 1), image.image.cols, CV_8UC3);
    DrawBar({image.title}, text_px, bar);
    panels.emplace_back();
    cv::vconcat(bar, image.image, panels.back());
  }
  const bool wide = images.front().image.cols > 2 * images.front().image.rows;
  if (columns > 0) return Grid(panels, columns);
  return Grid(panels, wide ? 1 : static_cast<int>(panels.size()));
}

cv::Mat ContactSheet(const std::vector<cv::Mat>& images, int columns) {
  Require(!images.empty() && columns > 0, "ContactSheet: at least one image and one column");
  return Grid(images, std::min(columns, static_cast<int>(images.size())));
}

std::vector<std::size_t> EvenlySpaced(std::size_t count, std::size_t most) {
  std::vector<std::size_t> indices;
  const std::size_t chosen = std::min(count, most);
  for (std::size_t i = 0; i < chosen; ++i) {
    indices.push_back(chosen == 1 ? 0 : i * (count - 1) / (chosen - 1));
  }
  return indices;
}

}  // namespace cvo::reports
