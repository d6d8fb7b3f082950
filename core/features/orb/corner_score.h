// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

namespace cvo {

// Computes the FAST-9 score of every pixel (Rosten and Drummond 2006): the largest t for which 9
// contiguous pixels of the 16 around it are all brighter, or all darker, by at least t. The score
// is 0 on the 3 px border. `scores` must have the size of the image.
void ComputeFastScores(const cv::Mat& image, cv::Mat& scores);

struct Corner {
  int x = 0;  // pixels of the level
  int y = 0;
  int score = 0;
};

inline bool InReadingOrder(const Corner& a, const Corner& b) {
  return a.y != b.y ? a.y < b.y : a.x < b.x;
}

// Returns, in reading order, the pixels whose score exceeds `threshold` and is the maximum among
// their 8 neighbours. Of equal neighbours, the first in reading order is the maximum. None is
// nearer to the edge than `border_px` >= 4.
std::vector<Corner> FindMaxima(const cv::Mat& scores, int border_px, int threshold);

struct CornerRule {
  int border_px = 0;  // minimum distance from the image edge
  int cell_px = 0;    // side of a cell; the grid of cells starts at the border
  int threshold = 0;
};

// Returns, for each corner of an image of this size, whether it satisfies the rule: it is not
// nearer to the edge than the border, and its score exceeds the threshold, unless no corner in its
// cell exceeds it.
std::vector<char> FollowRule(std::span<const Corner> corners, const cv::Size& size,
                             const CornerRule& rule);

}  // namespace cvo
