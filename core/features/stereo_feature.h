// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <limits>

#include "core/features/descriptor.h"
#include "core/features/feature_patch.h"

namespace cvo {

// Disagreement of a corner that was not found in the right image, so that its right column carries
// no information.
inline constexpr float kNoDisparity_px = 1e3F;
constexpr bool HasNoDisparity(double disagreement_px) { return disagreement_px >= kNoDisparity_px; }

// Row offset of a feature without a right corner, or whose right corner is not known.
inline constexpr float kUnknownRowOffset_px = std::numeric_limits<float>::quiet_NaN();

// A corner of the left image that was matched in the right one: z in section 3 of the paper.
// Unmatched corners are kept in boxes only; their u_right equals u_left until it is known which
// body they lie on.
struct StereoFeature {
  Eigen::Vector3d z_px = Eigen::Vector3d::Zero();  // (u_left, v, u_right), u_left >= u_right
  int octave = 0;                                  // pyramid level, scale = scale_factor^octave
  float angle_rad = 0.0F;                          // orientation of the patch
  float response = 0.0F;                           // corner strength, comparable within an image
  // Whether it was kept in addition to OrbOptions::features, to have more corners in small parts of
  // the image.
  bool is_reserve = false;
  // RMS disagreement of the quarters of the patch on the disparity, px of the level.
  float disagreement_px = 0.0F;
  float row_offset_px = kUnknownRowOffset_px;  // v_right - v_left of the two corners
  Descriptor descriptor{};                     // of the left patch
  FeaturePatch patch;
  // Whether z_px is where the reference patch of the landmark was found, instead of the corner.
  bool is_aligned = false;
};

// Whether a feature, or an observation of one, has no match in the right image.
bool IsLeftOnly(const auto& seen) { return HasNoDisparity(seen.disagreement_px); }

}  // namespace cvo
