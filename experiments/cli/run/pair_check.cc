// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/run/pair_check.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/lists.h"
#include "core/features/orb/orb.h"
#include "experiments/datasets/images.h"

namespace cvo {
namespace {

// Returns the keypoint that looks most like this one; nullptr if none is similar enough or another
// is about as similar.
const OrbKeypoint* MostAlike(const OrbKeypoint& keypoint, const std::vector<OrbKeypoint>& others) {
  constexpr int kFarthest = 64;        // of 256 bits
  constexpr double kUniqueness = 0.8;  // best / second-best distance
  int best = 257;
  int second = 257;
  const OrbKeypoint* alike = nullptr;
  for (const OrbKeypoint& other : others) {
    const int distance = HammingDistance(keypoint.descriptor, other.descriptor);
    if (distance < best) {
      second = best;
      best = distance;
      alike = &other;
    } else {
      second = std::min(second, distance);
    }
  }
  return best <= kFarthest && best < kUniqueness * second ? alike : nullptr;
}

std::vector<PairCheck::Match> MatchAnywhere(const cv::Mat& left, const cv::Mat& right) {
  const OrbOptions options = {.features = 1000};
  const std::vector<OrbKeypoint> of_left = ExtractOrb(left, options).keypoints;
  const std::vector<OrbKeypoint> of_right = ExtractOrb(right, options).keypoints;
  std::vector<PairCheck::Match> matches;
  for (const OrbKeypoint& keypoint : of_left) {
    const OrbKeypoint* partner = MostAlike(keypoint, of_right);
    if (partner == nullptr || MostAlike(*partner, of_left) != &keypoint) continue;
    matches.push_back({{keypoint.u_px, keypoint.v_px}, {partner->u_px, partner->v_px}});
  }
  return matches;
}

double MedianOf(const std::vector<PairCheck::Match>& matches,
                double (*value)(const Eigen::Vector2d&)) {
  std::vector<double> values;
  for (const PairCheck::Match& match : matches)
    values.push_back(value(match.left_px - match.right_px));
  return Median(std::move(values));
}

}  // namespace

std::string PairCheck::Problem() const {
  if (cv::norm(left, right, cv::NORM_INF) == 0.0) return "the left and right images are the same";
  if (disparity_px < 0.0) {
    return "left and right seem to be swapped: points are farther right in the right image than in "
           "the left";
  }
  return "";
}

cv::Mat PairCheck::Picture() const {
  constexpr std::size_t kShown = 24;
  cv::Mat picture;
  cv::hconcat(left, right, picture);
  cv::cvtColor(picture, picture, cv::COLOR_GRAY2BGR);
  constexpr int kShift = 3;  // fractional bits of OpenCV's coordinates
  const auto at = [&](double u_px, double v_px) {
    return cv::Point(static_cast<int>(std::lround(u_px * (1 << kShift))),
                     static_cast<int>(std::lround(v_px * (1 << kShift))));
  };
  const std::vector<cv::Scalar> colors = {
      {0, 200, 255}, {80, 220, 80}, {255, 160, 60}, {200, 100, 255}};
  const std::size_t shown = std::min(kShown, matches.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const Match& match = matches[i * matches.size() / shown];
    const cv::Scalar& color = colors[i % colors.size()];
    const double v_px = match.left_px.y();
    cv::line(picture, at(0.0, v_px), at(picture.cols - 1.0, v_px), color, 1, cv::LINE_AA, kShift);
    for (const cv::Point& corner :
         {at(match.left_px.x(), v_px), at(left.cols + match.right_px.x(), match.right_px.y())}) {
      cv::circle(picture, corner, 5 << kShift, color, 2, cv::LINE_AA, kShift);
    }
  }
  return picture;
}

std::optional<PairCheck> CheckMiddlePair(const Sequence& sequence) {
  constexpr std::size_t kFewest = 20;
  const std::size_t middle = sequence.images.size() / 2;
  PairCheck pair;
  pair.frame = sequence.first_frame + static_cast<int>(middle);
  pair.left = LoadFrameImage(sequence, middle, 0).grey;
  pair.right = LoadFrameImage(sequence, middle, 1).grey;
  if (pair.left.empty() || pair.right.empty()) return std::nullopt;
  pair.matches = MatchAnywhere(pair.left, pair.right);
  if (pair.matches.size() < kFewest) return std::nullopt;
  pair.row_error_px =
      MedianOf(pair.matches, [](const Eigen::Vector2d& apart) { return std::abs(apart.y()); });
  pair.disparity_px =
      MedianOf(pair.matches, [](const Eigen::Vector2d& apart) { return apart.x(); });
  return pair;
}

}  // namespace cvo
