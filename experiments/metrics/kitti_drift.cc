// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/kitti_drift.h"

#include <array>
#include <numbers>

#include "core/base/error.h"

namespace cvo {
namespace {

constexpr std::array<double, 8> kLengths_m = {100, 200, 300, 400, 500, 600, 700, 800};
constexpr std::size_t kStep = 10;

// Length of the true path up to each frame; a frame without truth has that of the preceding frame.
std::vector<double> PathLengths(const OptionalPoses& truth) {
  std::vector<double> lengths(truth.size());
  std::optional<Eigen::Vector3d> last;
  double length = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i]) {
      if (last) length += (truth[i]->translation() - *last).norm();
      last = truth[i]->translation();
    }
    lengths[i] = length;
  }
  return lengths;
}

// Finds the first frame whose distance from frame `first` along the path exceeds `length_m`.
std::optional<std::size_t> FindEnd(const std::vector<double>& path, std::size_t first,
                                   double length_m) {
  for (std::size_t i = first; i < path.size(); ++i) {
    if (path[i] > path[first] + length_m) return i;
  }
  return std::nullopt;
}

}  // namespace

std::optional<KittiDrift> ComputeKittiDrift(const OptionalPoses& truth,
                                            const OptionalPoses& estimate) {
  Require(truth.size() == estimate.size(), "ComputeKittiDrift: needs frames in pairs");
  const std::vector<double> path = PathLengths(truth);
  KittiDrift drift;
  double translation_sum = 0.0;  // m per m
  double rotation_sum = 0.0;     // rad per m
  for (std::size_t first = 0; first < truth.size(); first += kStep) {
    if (!truth[first]) continue;
    for (const double length_m : kLengths_m) {
      const std::optional<std::size_t> last = FindEnd(path, first, length_m);
      if (!last) break;
      if (!estimate[first] || !estimate[*last]) {
        ++drift.segments_without_estimate;
        continue;
      }
      const RigidTransform G = truth[first]->Inverse() * *truth[*last];
      const RigidTransform P = estimate[first]->Inverse() * *estimate[*last];
      const RigidTransform E = P.Inverse() * G;
      translation_sum += E.translation().norm() / length_m;
      rotation_sum += RotationAngle(E.rotation()) / length_m;
      ++drift.segments;
    }
  }
  if (drift.segments == 0) return std::nullopt;
  const auto n = static_cast<double>(drift.segments);
  drift.translation_percent = 100.0 * translation_sum / n;
  drift.rotation_deg_per_100m = 100.0 * 180.0 / std::numbers::pi * rotation_sum / n;
  return drift;
}

}  // namespace cvo
