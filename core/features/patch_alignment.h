// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>

namespace cvo {

// A corner and where to look for it in the other image, pixels of one pyramid level.
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
  double sigma = 0.0;  // of u_right, from how much the patches differ and from their slopes
  // RMS of the further shifts that the patch's quarters would take each for itself: what a step of
  // depth within the patch, or noise, leaves.
  double disagreement = 0.0;
};

// The column at which the right image looks like the patch of the left one: whole columns first,
// then Gauss-Newton steps over the disparity, its change from row to row (the ground) and the
// brightness. Empty where a patch leaves its image, the best column lies at the end of the search,
// or the steps lead away from it. Uses AVX2 where there is.
[[nodiscard]] std::optional<PatchMatch> AlignPatch(const cv::Mat& left, const cv::Mat& right,
                                                   const PatchQuery& query);

// The same without AVX2: what the fast path is tested against.
[[nodiscard]] std::optional<PatchMatch> AlignPatchPlain(const cv::Mat& left, const cv::Mat& right,
                                                        const PatchQuery& query);

}  // namespace cvo
