// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/orb/orb.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <opencv2/imgproc.hpp>
#include <tuple>

#include "core/base/error.h"
#include "core/features/orb/brief.h"
#include "core/features/orb/corner_refinement.h"
#include "core/features/orb/corner_score.h"
#include "core/features/orb/corner_selection.h"
#include "core/features/orb/pyramid.h"

namespace cvo {
namespace {

constexpr int kBorder_px = kOrbPatchRadius + 1;  // one more for the padding of rows of 32
// In regions corners may be nearer to the edge, as near as the stereo matcher's patches: otherwise
// bodies that enter or leave the image have none for long, above all at the coarse levels.
constexpr int kRegionBorder_px = 8;
constexpr int kPadding_px = kBorder_px - kRegionBorder_px;  // mirrored pixels, for their patches
constexpr int kBlurSide_px = 7;
constexpr double kBlurSigma_px = 2.0;
constexpr int kScoreBlurSide_px = 3;
constexpr double kScoreBlurSigma_px = 0.8;

// Scratch images by level. Blurred ones and copies are padded and have one row stride.
struct Work {
  std::vector<cv::Mat> blurred;
  std::vector<cv::Mat> copies;
  std::vector<cv::Mat> scores;
  BriefDescriber describer;
};

std::vector<cv::Mat> AllocatePadded(const std::vector<cv::Mat>& pyramid) {
  std::vector<cv::Mat> padded;
  const int columns = pyramid[0].cols + 2 * kPadding_px;
  for (const cv::Mat& level : pyramid) {
    const cv::Mat storage(level.rows + 2 * kPadding_px, columns, CV_8UC1);
    padded.push_back(storage.colRange(0, level.cols + 2 * kPadding_px));
  }
  return padded;
}

cv::Mat WithoutPadding(const cv::Mat& padded) {
  return padded(cv::Rect(kPadding_px, kPadding_px, padded.cols - 2 * kPadding_px,
                         padded.rows - 2 * kPadding_px));
}

void MirrorEdges(cv::Mat& padded) {
  cv::copyMakeBorder(WithoutPadding(padded), padded, kPadding_px, kPadding_px, kPadding_px,
                     kPadding_px, cv::BORDER_REFLECT_101 | cv::BORDER_ISOLATED);
}

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

std::vector<Corner> Union(const std::vector<Corner>& a, const std::vector<Corner>& b) {
  std::vector<Corner> both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both), InReadingOrder);
  return both;
}

// Corners of a level, in reading order.
struct LevelCorners {
  std::vector<Corner> all;     // far enough from the edge
  std::vector<Corner> others;  // for regions alone: nearer to it, or weak beside strong ones
  std::vector<Corner> first;   // of all, chosen evenly
};

// The level's part of the reserve: what the regions lack, then evenly.
std::vector<Corner> SelectReserve(const LevelCorners& corners, const LevelCoordinates& coordinates,
                                  int level, double scale_factor, Wanted& wanted) {
  std::vector<Corner> rest = Without(corners.all, corners.first);
  std::vector<Corner> reserve;
  int left = wanted.reserve;
  const auto take = [&](const std::vector<Corner>& selected) {
    rest = Without(rest, selected);
    reserve = Union(reserve, selected);
    left -= static_cast<int>(selected.size());
  };
  const int evenly = LevelQuota(wanted.reserve, level, scale_factor);
  for (CornerRegion& region : wanted.regions) {
    const std::vector<Corner> taken = Union(corners.first, reserve);
    const int found = static_cast<int>(Within(region.box, coordinates, taken).size());
    const int quota = LevelQuota(region.corners, level, scale_factor);
    const std::vector<Corner> free = Union(rest, Without(corners.others, reserve));
    const std::vector<Corner> selected =
        SelectEvenly(Within(region.box, coordinates, free), std::min(quota - found, left));
    region.corners -= found + static_cast<int>(selected.size());
    take(selected);
  }
  take(SelectEvenly(rest, evenly - static_cast<int>(reserve.size())));
  wanted.reserve = left;
  return reserve;
}

LevelCorners FindLevelCorners(const cv::Mat& scores, int level, const OrbOptions& options,
                              Wanted& wanted) {
  CornerSearch search;
  search.border_px = kBorder_px;
  search.cell_px = options.cell_px;
  search.threshold = options.fast_threshold;
  search.min_threshold = options.fast_threshold_min;
  LevelCorners corners;
  corners.all = FindCorners(scores, search);
  corners.first = SelectEvenly(corners.all, LevelQuota(wanted.first, level, options.scale_factor));
  wanted.first -= static_cast<int>(corners.first.size());
  if (wanted.regions.empty()) return corners;
  search.border_px = kRegionBorder_px;
  search.threshold = search.min_threshold;
  corners.others = Without(FindCorners(scores, search), corners.all);
  return corners;
}

FeaturePatch PatchAround(const cv::Mat& padded, const Corner& corner, const Eigen::Vector2d& move) {
  FeaturePatch patch;
  patch.corner_u = static_cast<float>(move.x());
  patch.corner_v = static_cast<float>(move.y());
  const int column = corner.x + kPadding_px - FeaturePatch::kRadius_px;
  for (int y = 0; y < FeaturePatch::kSide_px; ++y) {
    const int row = corner.y + kPadding_px - FeaturePatch::kRadius_px + y;
    std::copy_n(padded.ptr<std::uint8_t>(row) + column, FeaturePatch::kSide_px,
                patch.pixels.begin() + y * FeaturePatch::kSide_px);
  }
  return patch;
}

void ExtractLevel(const std::vector<cv::Mat>& pyramid, int level, const OrbOptions& options,
                  Wanted& wanted, Work& work, std::vector<OrbKeypoint>& keypoints) {
  const cv::Mat& image = pyramid[level];
  cv::Mat& blurred = work.blurred[level];
  cv::Mat inner = WithoutPadding(blurred);
  cv::Mat& scores = work.scores[level];
  ScoreLevel(image, inner, scores);
  const LevelCorners corners = FindLevelCorners(scores, level, options, wanted);
  const LevelCoordinates coordinates(pyramid, level);
  const std::vector<Corner> reserve =
      SelectReserve(corners, coordinates, level, options.scale_factor, wanted);
  Blur(image, inner, kBlurSide_px, kBlurSigma_px);
  MirrorEdges(blurred);
  cv::Mat& copy = work.copies[level];
  image.copyTo(WithoutPadding(copy));
  MirrorEdges(copy);
  const auto add = [&](const Corner& corner, bool is_reserve) {
    const Eigen::Vector2d move = RefineCorner(scores, corner.x, corner.y);
    OrbKeypoint keypoint;
    keypoint.u_px = static_cast<float>(coordinates.FullU(corner.x + move.x()));
    keypoint.v_px = static_cast<float>(coordinates.FullV(corner.y + move.y()));
    keypoint.octave = level;
    keypoint.angle_rad = PatchAngle(copy, corner.x + kPadding_px, corner.y + kPadding_px);
    keypoint.response = static_cast<float>(corner.score);
    keypoint.is_reserve = is_reserve;
    keypoint.descriptor = work.describer.Describe(blurred, corner.x + kPadding_px,
                                                  corner.y + kPadding_px, keypoint.angle_rad);
    keypoint.patch = PatchAround(copy, corner, move);
    keypoints.push_back(keypoint);
  };
  for (const Corner& corner : corners.first) add(corner, false);
  for (const Corner& corner : reserve) add(corner, true);
}

}  // namespace

OrbImage ExtractOrb(const cv::Mat& image, const OrbOptions& options,
                    std::span<const CornerRegion> regions) {
  Require(image.type() == CV_8UC1 && !image.empty(), "ExtractOrb: needs a CV_8UC1 image");
  options.Check();
  OrbImage result;
  result.pyramid = BuildPyramid(image, options.levels, options.scale_factor, 2 * kBorder_px + 1);
  std::vector<cv::Mat> blurred = AllocatePadded(result.pyramid);
  const std::size_t stride = blurred[0].step;
  Work work{std::move(blurred), AllocatePadded(result.pyramid), AllocateLike(result.pyramid),
            BriefDescriber(stride)};
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
