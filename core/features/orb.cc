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
std::vector<Corner> Without(const std::vector<Corner>& corners,
                            const std::vector<Corner>& selected) {
  std::vector<Corner> others;
  std::set_difference(corners.begin(), corners.end(), selected.begin(), selected.end(),
                      std::back_inserter(others), InReadingOrder);
  return others;
}

std::vector<Corner> Within(const cv::Rect2d& region, const LevelCoordinates& coordinates,
                           const std::vector<Corner>& corners) {
  std::vector<Corner> inside;
  std::copy_if(corners.begin(), corners.end(), std::back_inserter(inside), [&](const Corner& c) {
    return region.contains({coordinates.FullU(c.x), coordinates.FullV(c.y)});
  });
  return inside;
}

// How many corners are still wanted: first ones, of the reserve, and in each region.
struct Wanted {
  int first = 0;
  int reserve = 0;
  std::vector<CornerRegion> regions;
};

// The level's part of the reserve: what the regions lack, then evenly.
std::vector<Corner> SelectReserve(const std::vector<Corner>& corners,
                                  const std::vector<Corner>& first,
                                  const LevelCoordinates& coordinates, int level,
                                  double scale_factor, Wanted& wanted) {
  std::vector<Corner> rest = Without(corners, first);
  std::vector<Corner> reserve;
  int left = wanted.reserve;
  const auto take = [&](const std::vector<Corner>& selected) {
    std::vector<Corner> both;
    std::set_union(reserve.begin(), reserve.end(), selected.begin(), selected.end(),
                   std::back_inserter(both), InReadingOrder);
    rest = Without(rest, selected);
    reserve = std::move(both);
    left -= static_cast<int>(selected.size());
  };
  const int evenly = LevelQuota(wanted.reserve, level, scale_factor);
  for (CornerRegion& region : wanted.regions) {
    const int found =
        static_cast<int>(Within(region.box, coordinates, Without(corners, rest)).size());
    const int quota = LevelQuota(region.corners, level, scale_factor);
    const std::vector<Corner> selected =
        SelectEvenly(Within(region.box, coordinates, rest), std::min(quota - found, left));
    region.corners -= found + static_cast<int>(selected.size());
    take(selected);
  }
  take(SelectEvenly(rest, evenly - static_cast<int>(reserve.size())));
  wanted.reserve = left;
  return reserve;
}

void ExtractLevel(const std::vector<cv::Mat>& pyramid, int level, const OrbOptions& options,
                  Wanted& wanted, Work& work, std::vector<OrbKeypoint>& keypoints) {
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
  const LevelCoordinates coordinates(pyramid, level);
  const std::vector<Corner> first =
      SelectEvenly(corners, LevelQuota(wanted.first, level, options.scale_factor));
  wanted.first -= static_cast<int>(first.size());
  const std::vector<Corner> reserve =
      SelectReserve(corners, first, coordinates, level, options.scale_factor, wanted);
  Blur(image, blurred, kBlurSide_px, kBlurSigma_px);
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
}

}  // namespace

OrbImage ExtractOrb(const cv::Mat& image, const OrbOptions& options,
                    std::span<const CornerRegion> regions) {
  Require(image.type() == CV_8UC1 && !image.empty(), "ExtractOrb: needs a CV_8UC1 image");
  options.Check();
  OrbImage result;
  result.pyramid = BuildPyramid(image, options.levels, options.scale_factor, 2 * kBorder_px + 1);
  Work work{AllocateLike(result.pyramid), AllocateLike(result.pyramid),
            BriefDescriber(result.pyramid[0].step)};
  // Coarse to fine: what a level cannot fill is left for the finer ones, which have more to offer.
  Wanted wanted{options.features,
                cvRound(options.features * options.reserve),
                {regions.begin(), regions.end()}};
  for (int level = static_cast<int>(result.pyramid.size()) - 1; level >= 0; --level) {
    ExtractLevel(result.pyramid, level, options, wanted, work, result.keypoints);
  }
  const auto key = [](const OrbKeypoint& k) { return std::tie(k.v_px, k.u_px, k.octave); };
  std::sort(result.keypoints.begin(), result.keypoints.end(),
            [&](const OrbKeypoint& a, const OrbKeypoint& b) { return key(a) < key(b); });
  return result;
}

}  // namespace cvo
