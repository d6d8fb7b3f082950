// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/point_ransac.h"

#include <array>
#include <vector>

namespace cvo {
namespace {

std::vector<Eigen::Index> Inliers(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to,
                                  const RigidTransform& to_from_from, double max_distance_m) {
  std::vector<Eigen::Index> inliers;
  for (Eigen::Index i = 0; i < from.cols(); ++i) {
    const Eigen::Vector3d p = to_from_from * from.col(i);
    if ((p - to.col(i)).norm() <= max_distance_m) inliers.push_back(i);
  }
  return inliers;
}

}  // namespace

std::optional<RigidTransform> AlignPointsRansac(const Eigen::Matrix3Xd& from,
                                                const Eigen::Matrix3Xd& to, double max_distance_m,
                                                int min_inliers, int iterations, Rng& rng) {
  const auto n = static_cast<std::uint64_t>(from.cols());
  if (from.cols() < std::max(3, min_inliers)) return std::nullopt;
  std::vector<Eigen::Index> best;
  for (int iteration = 0; iteration < iterations; ++iteration) {
    std::array<Eigen::Index, 3> sample{};
    for (Eigen::Index& index : sample) index = static_cast<Eigen::Index>(rng.UniformInt(n));
    if (sample[0] == sample[1] || sample[0] == sample[2] || sample[1] == sample[2]) continue;
    std::vector<Eigen::Index> inliers = Inliers(
        from, to, AlignPoints(from(Eigen::all, sample), to(Eigen::all, sample)), max_distance_m);
    if (inliers.size() > best.size()) best = std::move(inliers);
  }
  if (static_cast<int>(best.size()) < min_inliers) return std::nullopt;
  return AlignPoints(from(Eigen::all, best), to(Eigen::all, best));
}

}  // namespace cvo
