// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/orb/orb.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <tuple>

#include "core/base/error.h"
#include "core/features/orb/brief.h"
#include "core/features/orb/corner_score.h"
#include "core/features/orb/corner_selection.h"

namespace cvo {

namespace {

// Side of a detection cell; smaller spreads corners more evenly (METHOD.md 2.1).
constexpr int kCell_px = 30;

constexpr int kBorder_px = kOrbPatchRadius + 1;  // PatchAngle reads rows of 32 pixels
// In regions, corners may be nearer to the edge, as near as the patches of the stereo matcher
// allow. Otherwise, bodies that enter or leave the image have no corners for a long time,
// especially at the coarse levels.
constexpr int kRegionBorder_px = 8;
constexpr int kPadding_px = kBorder_px - kRegionBorder_px;  // mirrored pixels, for their patches
constexpr int kBlurSide_px = 7;
constexpr double kBlurSigma_px = 2.0;
constexpr int kScoreBlurSide_px = 3;
constexpr double kScoreBlurSigma_px = 0.8;

// Scratch memory that all levels reuse. The blurred image is padded like the levels of the pyramid.
struct Work {
  cv::Mat blurred;
  cv::Mat scores;
  BriefDescriber describer;
};

void Blur(const cv::Mat& image, cv::Mat& blurred, int side_px, double sigma_px) {
  cv::GaussianBlur(image, blurred, cv::Size(side_px, side_px), sigma_px, sigma_px,
                   cv::BORDER_REFLECT_101 | cv::BORDER_ISOLATED);
}

// Returns the number of corners of a level: its share of the `left` corners that remain for it and
// the finer levels. The shares form a geometric series that falls by scale_factor from level to
// level (METHOD.md 2.1).
int LevelQuota(int left, int level, double scale_factor) {
  const double f = 1.0 / scale_factor;
  const double share = std::pow(f, level) * (1.0 - f) / (1.0 - std::pow(f, level + 1));
  return cvRound(left * share);
}

// Computes the pixel scores of a level. A slight blur first makes noise less decisive for which
// corner is found, so that the same one is found in the other image (measured on KITTI: 8 % more
// stereo features, 15 % more of them seen again in the next frame).
void ScoreLevel(const cv::Mat& image, cv::Mat& blurred, cv::Mat& scores) {
  Blur(image, blurred, kScoreBlurSide_px, kScoreBlurSigma_px);
  ComputeFastScores(blurred, scores);
}

// Number of corners still to be selected: the regular ones (OrbOptions::features), those of the
// reserve, and those of each region.
struct Wanted {
  int first = 0;
  int reserve = 0;
  std::vector<CornerRegion> regions;
};

enum class Use : char {
  kFree,
  kForRegions,  // near the edge, or weak beside strong ones: only for regions
  kFirst,
  kReserve,
};

// The corners of a level, in reading order, and what each is used for.
struct LevelCorners {
  std::vector<Corner> corners;
  std::vector<Use> uses;

  std::vector<Corner> Select(auto&& is_asked) const {
    std::vector<Corner> selected;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (is_asked(i)) selected.push_back(corners[i]);
    }
    return selected;
  }

  // `used` is a subset of the corners, in reading order.
  void Mark(const std::vector<Corner>& used, Use use) {
    std::size_t at = 0;
    for (const Corner& corner : used) {
      while (InReadingOrder(corners[at], corner)) ++at;
      uses[at] = use;
    }
  }
};

LevelCorners FindLevelCorners(const cv::Mat& scores, const OrbOptions& options, bool for_regions) {
  LevelCorners level;
  level.corners =
      FindMaxima(scores, for_regions ? kRegionBorder_px : kBorder_px, options.fast_threshold_min);
  const CornerRule rule{kBorder_px, kCell_px, options.fast_threshold};
  for (const char follows : FollowRule(level.corners, scores.size(), rule)) {
    level.uses.push_back(follows != 0 ? Use::kFree : Use::kForRegions);
  }
  return level;
}

// Visits the index of each corner of a level that lies in `box`, a box in the full image.
void VisitInside(const LevelCoordinates& coordinates, const cv::Rect2d& box,
                 const std::vector<Corner>& corners, auto&& visit) {
  const auto row = [&](double v_px) {
    const auto is_above = [&](const Corner& c) { return coordinates.FullV(c.y) < v_px; };
    return std::partition_point(corners.begin(), corners.end(), is_above) - corners.begin();
  };
  const std::ptrdiff_t end = row(box.y + box.height);
  const double left = coordinates.LevelU(box.x);
  const double right = coordinates.LevelU(box.x + box.width);
  for (std::ptrdiff_t i = row(box.y); i < end; ++i) {
    const int x = corners[static_cast<std::size_t>(i)].x;
    if (x >= left && x < right) visit(static_cast<std::size_t>(i));
  }
}

// Selects those reserve corners of a level that a region lacks to reach its quota.
void SelectInRegion(const LevelCoordinates& coordinates, int quota, Wanted& wanted,
                    CornerRegion& region, LevelCorners& level) {
  int found = 0;
  std::vector<Corner> free;
  VisitInside(coordinates, region.box, level.corners, [&](std::size_t i) {
    if (level.uses[i] == Use::kFirst || level.uses[i] == Use::kReserve) {
      ++found;
    } else {
      free.push_back(level.corners[i]);
    }
  });
  const std::vector<Corner> selected = SelectEvenly(free, std::min(quota - found, wanted.reserve));
  const int count = static_cast<int>(selected.size());
  region.corners -= found + count;
  wanted.reserve -= count;
  level.Mark(selected, Use::kReserve);
}

// Selects the rest of the reserve of a level: as many corners as would lie in the regions if
// `quota` corners were spread over the image.
void SelectNear(const LevelCoordinates& coordinates, int quota, Wanted& wanted,
                LevelCorners& level) {
  if (quota <= 0 || wanted.regions.empty()) return;
  std::vector<char> is_near(level.corners.size());
  for (const CornerRegion& region : wanted.regions) {
    VisitInside(coordinates, region.box, level.corners,
                [&](std::size_t i) { is_near[i] = level.uses[i] == Use::kFree; });
  }
  const std::vector<Corner> near = level.Select([&](std::size_t i) { return is_near[i] != 0; });
  if (near.empty()) return;
  const auto free = std::count(level.uses.begin(), level.uses.end(), Use::kFree);
  wanted.reserve -= std::min(quota, static_cast<int>(free));
  const double share = static_cast<double>(near.size()) / static_cast<double>(free);
  level.Mark(SelectEvenly(near, cvRound(quota * share)), Use::kReserve);
}

// Selects the regular corners of the level, then its reserve: first what the regions lack, then
// corners spread evenly over the regions.
void SelectCorners(const LevelCoordinates& coordinates, int level, double scale_factor,
                   Wanted& wanted, LevelCorners& corners) {
  const std::vector<Corner> first =
      SelectEvenly(corners.Select([&](std::size_t i) { return corners.uses[i] == Use::kFree; }),
                   LevelQuota(wanted.first, level, scale_factor));
  corners.Mark(first, Use::kFirst);
  wanted.first -= static_cast<int>(first.size());
  const int evenly = LevelQuota(wanted.reserve, level, scale_factor);
  const int before = wanted.reserve;
  for (CornerRegion& region : wanted.regions) {
    const int quota = LevelQuota(region.corners, level, scale_factor);
    SelectInRegion(coordinates, quota, wanted, region, corners);
  }
  SelectNear(coordinates, evenly - (before - wanted.reserve), wanted, corners);
}

void ExtractLevel(const std::vector<cv::Mat>& pyramid, int level, const OrbOptions& options,
                  Wanted& wanted, Work& work, std::vector<OrbKeypoint>& keypoints) {
  const cv::Mat& image = pyramid[level];
  const cv::Rect whole({0, 0}, image.size());
  cv::Mat blurred = work.blurred(whole);
  cv::Mat scores = work.scores(whole);
  ScoreLevel(image, blurred, scores);
  LevelCorners corners = FindLevelCorners(scores, options, !wanted.regions.empty());
  const LevelCoordinates coordinates(pyramid, level);
  SelectCorners(coordinates, level, options.scale_factor, wanted, corners);
  Blur(image, blurred, kBlurSide_px, kBlurSigma_px);
  MirrorEdges(blurred, kPadding_px);
  const cv::Mat padded_image = Padded(image, kPadding_px);
  const cv::Mat padded_blurred = Padded(blurred, kPadding_px);
  for (std::size_t i = 0; i < corners.corners.size(); ++i) {
    const Use use = corners.uses[i];
    if (use != Use::kFirst && use != Use::kReserve) continue;
    const Corner& corner = corners.corners[i];
    const Eigen::Vector2d move = RefineCorner(scores, corner.x, corner.y);
    const int x = corner.x + kPadding_px;
    const int y = corner.y + kPadding_px;
    OrbKeypoint keypoint;
    keypoint.u_px = static_cast<float>(coordinates.FullU(corner.x + move.x()));
    keypoint.v_px = static_cast<float>(coordinates.FullV(corner.y + move.y()));
    keypoint.octave = level;
    keypoint.x = corner.x;
    keypoint.y = corner.y;
    keypoint.move_x = static_cast<float>(move.x());
    keypoint.move_y = static_cast<float>(move.y());
    keypoint.angle_rad = PatchAngle(padded_image, x, y);
    keypoint.response = static_cast<float>(corner.score);
    keypoint.is_reserve = use == Use::kReserve;
    keypoint.descriptor = work.describer.Describe(padded_blurred, x, y, keypoint.angle_rad);
    keypoints.push_back(keypoint);
  }
}

}  // namespace

OrbImage ExtractOrb(const cv::Mat& image, const OrbOptions& options,
                    std::span<const CornerRegion> regions) {
  Require(image.type() == CV_8UC1 && !image.empty(), "ExtractOrb: needs a CV_8UC1 image");
  options.Check();
  OrbImage result;
  result.pyramid =
      BuildPyramid(image, options.levels, options.scale_factor, 2 * kBorder_px + 1, kPadding_px);
  const std::size_t stride = result.pyramid[0].step;
  Work work{AllocatePadded(image.size(), stride, kPadding_px),
            AllocatePadded(image.size(), stride, 0), BriefDescriber(stride)};
  // Coarse to fine: what a level cannot fill is left to the finer ones, which have more corners.
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

FeaturePatch PatchAround(const OrbImage& image, const OrbKeypoint& keypoint) {
  const cv::Mat padded = Padded(image.pyramid[keypoint.octave], kPadding_px);
  FeaturePatch patch;
  patch.corner_u = keypoint.move_x;
  patch.corner_v = keypoint.move_y;
  const int column = keypoint.x + kPadding_px - FeaturePatch::kRadius_px;
  for (int y = 0; y < FeaturePatch::kSide_px; ++y) {
    const int row = keypoint.y + kPadding_px - FeaturePatch::kRadius_px + y;
    std::copy_n(padded.ptr<std::uint8_t>(row) + column, FeaturePatch::kSide_px,
                patch.pixels.begin() + y * FeaturePatch::kSide_px);
  }
  return patch;
}

}  // namespace cvo
