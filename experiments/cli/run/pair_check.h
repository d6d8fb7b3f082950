// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "experiments/datasets/sequence.h"

namespace cvo {

// What one stereo pair reveals about its calibration: corners matched by their appearance alone, at
// any position in the images, so that a wrong rectification and swapped sides become visible.
struct PairCheck {
  struct Match {
    Eigen::Vector2d left_px;
    Eigen::Vector2d right_px;
  };

  int frame = 0;  // as numbered in the sequence's folder
  cv::Mat left;   // grey
  cv::Mat right;
  std::vector<Match> matches;  // from top to bottom
  // Medians over the matches: of |v_left - v_right| and of u_left - u_right.
  double row_error_px = 0.0;
  double disparity_px = 0.0;

  // Why this is not a stereo pair: both images are the same, or the sides are swapped. Empty if it
  // is one.
  std::string Problem() const;
  // Both images side by side, with some of the matches, and with the rows of their left corners
  // drawn through both images.
  cv::Mat Picture() const;
};

// Checks the middle frame of the sequence. Empty if it cannot be decoded or has too few matches.
std::optional<PairCheck> CheckMiddlePair(const Sequence& sequence);

}  // namespace cvo
