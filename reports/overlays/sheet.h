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

// Arranges images of one size, each below its title, in `columns` columns. 0 places them side by
// side, or one below the other if they are more than twice as wide as high. Throws Error for images
// of different sizes.
cv::Mat Panels(const std::vector<TitledImage>& images, int text_px, int columns = 0);

// Arranges images of one size in rows, starting at the top left. Throws Error for images of
// different sizes.
cv::Mat ContactSheet(const std::vector<cv::Mat>& images, int columns);

// Returns at most `most` of `count` indices, evenly spaced from the first to the last.
std::vector<std::size_t> EvenlySpaced(std::size_t count, std::size_t most);

}  // namespace cvo::reports
