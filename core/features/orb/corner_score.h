// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace cvo {

// FAST-9 score of every pixel (Rosten and Drummond 2006): the largest t for which 9 contiguous
// pixels of the 16 around it are all brighter, or all darker, by at least t. 0 on the 3 px border.
// `scores` has the image's size. Uses AVX2 where there is one.
void ComputeFastScores(const cv::Mat& image, cv::Mat& scores);

// The same without it: what the fast path is tested against.
void ComputeFastScoresPlain(const cv::Mat& image, cv::Mat& scores);

struct Corner {
  int x = 0;  // pixels of the level
  int y = 0;
  int score = 0;
};

inline bool InReadingOrder(const Corner& a, const Corner& b) {
  return a.y != b.y ? a.y < b.y : a.x < b.x;
}

struct CornerSearch {
  int border_px = 0;  // no corner nearer to the edge, >= 4
  int cell_px = 0;
  int threshold = 0;      // corners score more than this ...
  int min_threshold = 0;  // ... or than this in cells without such a corner
};

// Maxima of the scores among their 8 neighbours (of equal ones, the first in reading order), in
// reading order.
std::vector<Corner> FindCorners(const cv::Mat& scores, const CornerSearch& search);

}  // namespace cvo
