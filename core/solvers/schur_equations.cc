// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/solvers/schur_equations.h"

#include <algorithm>

#include "core/base/error.h"

namespace cvo {

SchurEquations::SchurEquations(const std::vector<int>& pose_of_frame, int others,
                               std::size_t point_count,
                               const std::vector<ReprojectionFactor>& factors)
    : points(point_count), couplings_begin(point_count + 1, 0) {
  const int poses =
      pose_of_frame.empty() ? 0 : 1 + *std::max_element(pose_of_frame.begin(), pose_of_frame.end());
  pose_H.resize(poses);
  H.resize(6 * poses + others, 6 * poses + others);
  g.resize(6 * poses + others);
  int last_point = 0;
  int last_pose = -1;
  int count = 0;
  for (const ReprojectionFactor& factor : factors) {
    Require(factor.point >= last_point && factor.point < static_cast<int>(point_count) &&
                factor.pose >= 0 && factor.pose < static_cast<int>(pose_of_frame.size()) &&
                (factor.point > last_point || factor.pose > last_pose),
            "solver: factors must be by point, then by ascending pose, of points and poses that "
            "are there");
    last_point = factor.point;
    last_pose = factor.pose;
    if (pose_of_frame[factor.pose] >= 0) couplings_begin[factor.point + 1] = ++count;
  }
  // A point without couplings has an empty range.
  for (std::size_t p = 1; p <= point_count; ++p) {
    couplings_begin[p] = std::max(couplings_begin[p], couplings_begin[p - 1]);
  }
  couplings.resize(count);
}

void SchurEquations::SetZero() {
  for (Matrix6d& block : pose_H) block.setZero();
  H.setZero();
  g.setZero();
  points.assign(points.size(), PointEquations());
}

double SchurEquations::LargestGradient() const {
  double largest = g.size() > 0 ? g.cwiseAbs().maxCoeff() : 0.0;
  for (const PointEquations& point : points) {
    largest = std::max(largest, point.g.cwiseAbs().maxCoeff());
  }
  return largest;
}

}  // namespace cvo
