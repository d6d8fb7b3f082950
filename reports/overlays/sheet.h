// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

namespace cvo::reports {

struct TitledImage {
  std::string title;
  cv::Mat image;
};

// Images of one size under their titles, in so many columns; 0: beside each other, or below each
// other where they are more than twice as wide as high. Throws Error for images of different sizes.
cv::Mat Panels(const std::vector<TitledImage>& images, int text_px, int columns = 0);

// Images of one size in rows, the first at the top left.
cv::Mat ContactSheet(const std::vector<cv::Mat>& images, int columns);

// At most `most` of `count` indices, evenly spaced from the first to the last.
std::vector<std::size_t> EvenlySpaced(std::size_t count, std::size_t most);

}  // namespace cvo::reports
