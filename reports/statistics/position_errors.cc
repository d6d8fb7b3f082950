// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/statistics/position_errors.h"

#include <cmath>

#include "core/base/error.h"
#include "core/geometry/rigid_transform.h"

namespace cvo::reports {

std::optional<std::pair<double, double>> CommonRootMeanSquares(const FrameErrors& a,
                                                               const FrameErrors& b) {
  double sum_a = 0.0;
  double sum_b = 0.0;
  int n = 0;
  ForCommonFrames(a.frames, 0, b.frames, 0, [&](std::size_t i, std::size_t j) {
    sum_a += a.position_m[i] * a.position_m[i];
    sum_b += b.position_m[j] * b.position_m[j];
    ++n;
  });
  if (n == 0) return std::nullopt;
  return std::pair{std::sqrt(sum_a / n), std::sqrt(sum_b / n)};
}

std::vector<double> AlignedErrors(const std::vector<std::array<double, 3>>& estimate,
                                  const std::vector<std::array<double, 3>>& truth) {
  Require(estimate.size() == truth.size(), "AlignedErrors: as many estimated as true positions");
  if (estimate.empty()) return {};
  const auto count = static_cast<Eigen::Index>(estimate.size());
  const Eigen::Map<const Eigen::Matrix3Xd> from(estimate.front().data(), 3, count);
  const Eigen::Map<const Eigen::Matrix3Xd> to(truth.front().data(), 3, count);
  const RigidTransform to_from_from = AlignPoints(from, to);
  std::vector<double> errors_m;
  for (Eigen::Index i = 0; i < count; ++i) {
    errors_m.push_back((to_from_from * from.col(i) - to.col(i)).norm());
  }
  return errors_m;
}

}  // namespace cvo::reports
