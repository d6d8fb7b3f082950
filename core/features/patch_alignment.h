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
  int patch_radius = 0;
  int search_radius = 0;
};

struct PatchMatch {
  double u_right = 0.0;
  double cost = 0.0;  // mean squared difference after the mean brightness is removed
};

// The column at which the right image looks most like the patch of the left one, along the row.
// Empty where a patch leaves its image or the best column lies at the end of the search.
[[nodiscard]] std::optional<PatchMatch> AlignPatch(const cv::Mat& left, const cv::Mat& right,
                                                   const PatchQuery& query);

}  // namespace cvo
