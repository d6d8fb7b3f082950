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

// What one stereo pair says of its calibration: corners that look alike in both images, wherever
// they are, so that a wrong rectification or swapped sides show.
struct PairCheck {
  struct Match {
    Eigen::Vector2d left_px;
    Eigen::Vector2d right_px;
  };

  int frame = 0;  // counted in the folder
  cv::Mat left;   // grey
  cv::Mat right;
  std::vector<Match> matches;  // from top to bottom
  // Medians over the matches: of how far rows are apart, and of u_left - u_right.
  double row_error_px = 0.0;
  double disparity_px = 0.0;

  // Why this is no stereo pair: both images are the same, or sides are swapped. Empty: it is one.
  std::string Problem() const;
  // Side by side, with some of the matches and the rows of their left corners through both images.
  cv::Mat Picture() const;
};

// Of the sequence's middle frame; empty where it cannot be decoded or has too few matches to tell.
std::optional<PairCheck> CheckMiddlePair(const Sequence& sequence);

}  // namespace cvo
