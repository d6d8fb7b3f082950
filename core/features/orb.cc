// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/orb.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <opencv2/imgproc.hpp>
#include <tuple>

#include "core/base/error.h"
#include "core/features/brief.h"
#include "core/features/corner_refinement.h"
#include "core/features/corner_score.h"
#include "core/features/corner_selection.h"
#include "core/features/pyramid.h"

namespace cvo {
namespace {

constexpr int kBorder_px = kOrbPatchRadius + 1;  // one more for the padding of rows of 32
constexpr int kBlurSide_px = 7;
constexpr double kBlurSigma_px = 2.0;
constexpr int kScoreBlurSide_px = 3;
constexpr double kScoreBlurSigma_px = 0.8;

// Scratch images by level.
struct Work {
  std::vector<cv::Mat> blurred;
  std::vector<cv::Mat> scores;
  BriefDescriber describer;
};

void Blur(const cv::Mat& image, cv::Mat& blurred, int side_px, double sigma_px) {
  cv::GaussianBlur(image, blurred, cv::Size(side_px, side_px), sigma_px, sigma_px,
                   cv::BORDER_REFLECT_101 | cv::BORDER_ISOLATED);
}

// Corners of a level: its share of a geometric series that falls by scale_factor from level to
// level (METHOD.md 2.1), of what is left for it and the finer ones.
int LevelQuota(int left, int level, double scale_factor) {
  const double f = 1.0 / scale_factor;
  const double share = std::pow(f, level) * (1.0 - f) / (1.0 - std::pow(f, level + 1));
  return cvRound(left * share);
}

// Pixel scores of a level. A slight blur first: noise decides less over which corner is found, so
// the same one is found in the other image (measured on KITTI: 8 % more stereo features, 15 % more
// of them seen again in the next frame).
void ScoreLevel(const cv::Mat& image, cv::Mat& blurred, cv::Mat& scores) {
  Blur(image, blurred, kScoreBlurSide_px, kScoreBlurSigma_px);
  ComputeFastScores(blurred, scores);
}

// Those that are not among the selected ones; both are in reading order.
std::vector<Corner> Others(const std::vector<Corner>& corners,
                           const std::vector<Corner>& selected) {
  std::vector<Corner> others;
  std::set_difference(corners.begin(), corners.end(), selected.begin(), selected.end(),
                      std::back_inserter(others), InReadingOrder);
  return others;
}

// How many corners and how many of the reserve are still wanted, or were found.
struct Counts {
  int first = 0;
  int reserve = 0;
};

Counts ExtractLevel(const std::vector<cv::Mat>& pyramid, int level, const Counts& quota,
                    const OrbOptions& options, Work& work, std::vector<OrbKeypoint>& keypoints) {
  const cv::Mat& image = pyramid[level];
  cv::Mat& blurred = work.blurred[level];
  cv::Mat& scores = work.scores[level];
  ScoreLevel(image, blurred, scores);
  CornerSearch search;
  search.border_px = kBorder_px;
  search.cell_px = options.cell_px;
  search.threshold = options.fast_threshold;
  search.min_threshold = options.fast_threshold_min;
  const std::vector<Corner> corners = FindCorners(scores, search);
  const std::vector<Corner> first = SelectEvenly(corners, quota.first);
  const std::vector<Corner> reserve = SelectEvenly(Others(corners, first), quota.reserve);
  Blur(image, blurred, kBlurSide_px, kBlurSigma_px);
  const LevelCoordinates coordinates(pyramid, level);
  const auto add = [&](const Corner& corner, bool is_reserve) {
    const Eigen::Vector2d move = RefineCorner(scores, corner.x, corner.y);
    OrbKeypoint keypoint;
    keypoint.u_px = static_cast<float>(coordinates.FullU(corner.x + move.x()));
    keypoint.v_px = static_cast<float>(coordinates.FullV(corner.y + move.y()));
    keypoint.octave = level;
    keypoint.angle_rad = PatchAngle(image, corner.x, corner.y);
    keypoint.response = static_cast<float>(corner.score);
    keypoint.is_reserve = is_reserve;
    keypoint.descriptor = work.describer.Describe(blurred, corner.x, corner.y, keypoint.angle_rad);
    keypoints.push_back(keypoint);
  };
  for (const Corner& corner : first) add(corner, false);
  for (const Corner& corner : reserve) add(corner, true);
  return {static_cast<int>(first.size()), static_cast<int>(reserve.size())};
}

}  // namespace

OrbImage ExtractOrb(const cv::Mat& image, const OrbOptions& options) {
  Require(image.type() == CV_8UC1 && !image.empty(), "ExtractOrb: needs a CV_8UC1 image");
  options.Check();
  OrbImage result;
  result.pyramid = BuildPyramid(image, options.levels, options.scale_factor, 2 * kBorder_px + 1);
  Work work{AllocateLike(result.pyramid), AllocateLike(result.pyramid),
            BriefDescriber(result.pyramid[0].step)};
  // Coarse to fine: what a level cannot fill is left for the finer ones, which have more to offer.
  Counts left{options.features, cvRound(options.features * options.reserve)};
  for (int level = static_cast<int>(result.pyramid.size()) - 1; level >= 0; --level) {
    const Counts quota{LevelQuota(left.first, level, options.scale_factor),
                       LevelQuota(left.reserve, level, options.scale_factor)};
    const Counts found =
        ExtractLevel(result.pyramid, level, quota, options, work, result.keypoints);
    left.first -= found.first;
    left.reserve -= found.reserve;
  }
  const auto key = [](const OrbKeypoint& k) { return std::tie(k.v_px, k.u_px, k.octave); };
  std::sort(result.keypoints.begin(), result.keypoints.end(),
            [&](const OrbKeypoint& a, const OrbKeypoint& b) { return key(a) < key(b); });
  return result;
}

}  // namespace cvo
