// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/orb.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <tuple>

#include "core/base/error.h"
#include "core/features/brief.h"
#include "core/features/corner_score.h"
#include "core/features/corner_selection.h"
#include "core/features/pyramid.h"

namespace cvo {
namespace {

constexpr int kBorder_px = kOrbPatchRadius + 1;  // one more for the padding of rows of 32
constexpr int kBlurSide_px = 7;
constexpr double kBlurSigma_px = 2.0;

// Corners of a level: its share of a geometric series that falls by scale_factor from level to
// level (estimator.md 11), of what is left for it and the finer ones.
int LevelQuota(int left, int level, double scale_factor) {
  const double f = 1.0 / scale_factor;
  const double share = std::pow(f, level) * (1.0 - f) / (1.0 - std::pow(f, level + 1));
  return cvRound(left * share);
}

std::vector<Corner> DetectLevel(const cv::Mat& image, cv::Mat& scores, int quota,
                                const OrbOptions& options) {
  ComputeFastScores(image, scores);
  CornerSearch search;
  search.border_px = kBorder_px;
  search.cell_px = options.cell_px;
  search.threshold = options.fast_threshold;
  search.min_threshold = options.fast_threshold_min;
  return SelectEvenly(FindCorners(scores, search), quota);
}

OrbKeypoint Describe(const Corner& corner, const std::vector<cv::Mat>& pyramid, int level,
                     const cv::Mat& blurred, const BriefDescriber& describer) {
  const LevelCoordinates coordinates(pyramid, level);
  OrbKeypoint keypoint;
  keypoint.u_px = static_cast<float>(coordinates.FullU(corner.x));
  keypoint.v_px = static_cast<float>(coordinates.FullV(corner.y));
  keypoint.octave = level;
  keypoint.angle_rad = PatchAngle(pyramid[level], corner.x, corner.y);
  keypoint.response = static_cast<float>(corner.score);
  keypoint.descriptor = describer.Describe(blurred, corner.x, corner.y, keypoint.angle_rad);
  return keypoint;
}

}  // namespace

OrbImage ExtractOrb(const cv::Mat& image, const OrbOptions& options) {
  Require(image.type() == CV_8UC1 && !image.empty(), "ExtractOrb: needs a CV_8UC1 image");
  options.Check();
  OrbImage result;
  result.pyramid = BuildPyramid(image, options.levels, options.scale_factor, 2 * kBorder_px + 1);
  std::vector<cv::Mat> work = AllocateLike(result.pyramid);  // scores, then the blurred image
  const BriefDescriber describer(result.pyramid[0].step);
  // Coarse to fine: what a level cannot fill is left for the finer ones, which have more to offer.
  int left = options.features;
  for (int level = static_cast<int>(result.pyramid.size()) - 1; level >= 0; --level) {
    const cv::Mat& level_image = result.pyramid[level];
    const int quota = LevelQuota(left, level, options.scale_factor);
    const std::vector<Corner> corners = DetectLevel(level_image, work[level], quota, options);
    if (corners.empty()) continue;
    cv::GaussianBlur(level_image, work[level], cv::Size(kBlurSide_px, kBlurSide_px), kBlurSigma_px,
                     kBlurSigma_px, cv::BORDER_REFLECT_101 | cv::BORDER_ISOLATED);
    for (const Corner& corner : corners) {
      result.keypoints.push_back(Describe(corner, result.pyramid, level, work[level], describer));
    }
    left -= static_cast<int>(corners.size());
  }
  const auto key = [](const OrbKeypoint& k) { return std::tie(k.v_px, k.u_px, k.octave); };
  std::sort(result.keypoints.begin(), result.keypoints.end(),
            [&](const OrbKeypoint& a, const OrbKeypoint& b) { return key(a) < key(b); });
  return result;
}

}  // namespace cvo
