// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/statistics/common_frames.h"

#include <cmath>

namespace cvo::reports {

std::optional<std::pair<double, double>> CommonRootMeanSquares(const FrameErrors& a,
                                                               const FrameErrors& b) {
  double sum_a = 0.0;
  double sum_b = 0.0;
  int n = 0;
  for (std::size_t i = 0, j = 0; i < a.frames.size() && j < b.frames.size();) {
    if (a.frames[i] < b.frames[j]) {
      ++i;
    } else if (b.frames[j] < a.frames[i]) {
      ++j;
    } else {
      sum_a += a.position_m[i] * a.position_m[i];
      sum_b += b.position_m[j] * b.position_m[j];
      ++n, ++i, ++j;
    }
  }
  if (n == 0) return std::nullopt;
  return std::pair{std::sqrt(sum_a / n), std::sqrt(sum_b / n)};
}

}  // namespace cvo::reports
