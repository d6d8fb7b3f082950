// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/options.h"

namespace cvo {

struct OrbOptions {
  static constexpr int kMaxFeatures = 100000;

  int features = 1500;         // corners per image
  double reserve = 1.7;        // density of the reserve, relative to that of `features`
  int box_features = 100;      // corners up to which the reserve fills each box
  int levels = 4;              // pyramid levels
  double scale_factor = 1.2;   // between levels
  int fast_threshold = 20;     // FAST threshold, grey levels
  int fast_threshold_min = 7;  // the same in cells without a corner above fast_threshold

  // Throws Error naming an invalid field.
  void Check() const {
    CheckRanges(*this);
    if (fast_threshold_min > fast_threshold) {
      ThrowError("option fast_threshold_min", StrCat(fast_threshold_min),
                 StrCat("at most fast_threshold (", fast_threshold, ")"));
    }
  }

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field(
        "features", self.features,
        {"1", 10, kMaxFeatures,
         "corners kept per image; more corners take more time in every stage", "METHOD.md 2.1"});
    visit.Field("reserve", self.reserve,
                {"1", 0.0, 10.0,
                 "additional corners in and near detections, because bodies are small; density as "
                 "if reserve * orb.features corners were spread over the whole image",
                 "METHOD.md 2.1"});
    visit.Field("box_features", self.box_features,
                {"1", 0, kMaxFeatures,
                 "target number of corners in each detection, taken from the reserve first; an "
                 "even spread gives small bodies too few",
                 "METHOD.md 2.1"});
    visit.Field("levels", self.levels,
                {"1", 1, 16, "pyramid levels; fewer reduce scale invariance", "METHOD.md 2.1"});
    visit.Field("scale_factor", self.scale_factor,
                {"1", 1.01, 2.0, "scale between pyramid levels", "METHOD.md 2.1"});
    visit.Field("fast_threshold", self.fast_threshold,
                {"grey levels", 1, 255, "FAST threshold", "METHOD.md 2.1"});
    visit.Field(
        "fast_threshold_min", self.fast_threshold_min,
        {"grey levels", 1, 255, "FAST threshold in cells without a corner", "METHOD.md 2.1"});
  }
};

struct StereoMatchOptions {
  double right_features = 1.5;         // right corners per left corner
  int max_hamming = 90;                // maximum descriptor distance, of 256 bits
  double uniqueness = 0.9;             // maximum best / second-best distance
  int min_margin_bits = 16;            // minimum second-best - best distance
  double max_row_correction_px = 2.0;  // maximum row shift of the compared patches
  double min_depth_baselines = 3.0;    // depth of the nearest point
  double max_sigma_medians = 2.1;      // maximum sigma of a disparity, in medians of all

  // Throws Error naming an invalid field.
  void Check() const { CheckRanges(*this); }

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("right_features", self.right_features,
                {"1", 1.0, 5.0,
                 "corners extracted in the right image, relative to orb.features; more give more "
                 "stereo matches",
                 "measured on KITTI: 1.5 gives 7 % more features than 1, no more outliers"});
    visit.Field("max_hamming", self.max_hamming,
                {"bits", 1, 256, "maximum descriptor distance of a stereo match",
                 "measured on KITTI: 6 % more features than 75, no more outliers"});
    visit.Field(
        "uniqueness", self.uniqueness,
        {"1", 0.1, 1.0, "maximum ratio of the best to the second best distance", "METHOD.md 2.2"});
    visit.Field("min_margin_bits", self.min_margin_bits,
                {"bits", 0, 256,
                 "minimum difference between the second best and the best distance: on repetitive "
                 "texture, noise alone can pass the ratio test",
                 "measured on KITTI: 16 costs 2 % of the features"});
    visit.Field("max_row_correction_px", self.max_row_correction_px,
                {"px", 0.0, 10.0,
                 "maximum row shift of patches to compensate a rectification error; 0: none",
                 "measured on KITTI, where one corner needs 1.6"});
    visit.Field(
        "min_depth_baselines", self.min_depth_baselines,
        {"baselines", 0.5, 100.0, "minimum depth of a point; larger leaves fewer match candidates",
         "METHOD.md 2.2"});
    visit.Field("max_sigma_medians", self.max_sigma_medians,
                {"1", 1.0, 1000.0,
                 "maximum standard deviation of a disparity (in pixels of its level), relative to "
                 "the median of all",
                 "METHOD.md 2.2: 1.5 * 1.4, there of the SAD"});
  }
};

}  // namespace cvo
