// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <span>
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

// Maxima of the scores among their 8 neighbours (of equal ones, the first in reading order) that
// score more than `threshold`, in reading order. None is nearer to the edge than `border_px` >= 4.
std::vector<Corner> FindMaxima(const cv::Mat& scores, int border_px, int threshold);

struct CornerRule {
  int border_px = 0;  // distance from the edge
  int cell_px = 0;    // side of the cells, which begin at the border
  int threshold = 0;
};

// Which corners of an image of this size follow the rule: not nearer to the edge than the border,
// and with a score above the threshold unless none in their cell has one.
std::vector<bool> FollowRule(std::span<const Corner> corners, const cv::Size& size,
                             const CornerRule& rule);

}  // namespace cvo
