// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "core/features/descriptor.h"
#include "core/features/feature_patch.h"

namespace cvo {

// The disagreement of a corner that was not found in the right image: the column there says
// nothing.
inline constexpr float kNoDisparity_px = 1e3F;
constexpr bool HasNoDisparity(double disagreement_px) { return disagreement_px >= kNoDisparity_px; }

// A corner of the left image that was found in the right one: z of the paper's section 3. In boxes
// there are also those that were not: u_right is u_left until the body that they lie on is known.
struct StereoFeature {
  Eigen::Vector3d z_px = Eigen::Vector3d::Zero();  // (u_left, v, u_right), u_left > u_right
  int octave = 0;                                  // pyramid level, scale = scale_factor^octave
  float angle_rad = 0.0F;                          // orientation of the patch
  float response = 0.0F;                           // corner strength, comparable within an image
  // One of those beyond OrbOptions::features: for where much is wanted of a small part of the
  // image.
  bool is_reserve = false;
  // How far the quarters of the patch disagree on the disparity: RMS, px of the level.
  float disagreement_px = 0.0F;
  Descriptor descriptor{};  // of the left patch
  FeaturePatch patch;
  // z_px is where the landmark's reference was found, not where the corner is.
  bool is_aligned = false;
};

// Of a feature or an observation of one.
bool IsLeftOnly(const auto& seen) { return HasNoDisparity(seen.disagreement_px); }

}  // namespace cvo
