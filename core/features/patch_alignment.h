// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>

namespace cvo {

// A corner of the left image and the position at which to search for it in the right one, in pixels
// of one pyramid level.
struct PatchQuery {
  double u_left = 0.0;
  double v_left = 0.0;
  double u_right = 0.0;
  double v_right = 0.0;
  int patch_radius = 0;   // <= kMaxPatchRadius_px
  int search_radius = 0;  // <= kMaxSearchRadius_px
};

inline constexpr int kMaxPatchRadius_px = 15;
inline constexpr int kMaxSearchRadius_px = 20;

struct PatchMatch {
  double u_right = 0.0;
  double sigma = 0.0;  // of u_right, from the residuals and the image gradients
  // Weighted RMS of the additional shifts that the four quarters of the patch would each make on
  // their own. It shows noise and depth discontinuities within the patch.
  double disagreement = 0.0;
};

// Finds the column at which the right image matches the patch of the left one: a search over whole
// columns, then Gauss-Newton steps over the disparity, its change from row to row (as on the
// ground) and the brightness. Empty if a patch leaves its image, the best column is at the end of
// the search range, or the steps lead too far away from it.
[[nodiscard]] std::optional<PatchMatch> AlignPatch(const cv::Mat& left, const cv::Mat& right,
                                                   const PatchQuery& query);

}  // namespace cvo
