// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/pose_errors.h"

#include <cmath>

#include "core/base/error.h"

namespace cvo {
namespace {

double Square(double x) { return x * x; }

Eigen::Matrix3Xd Positions(const std::vector<RigidTransform>& poses) {
  Eigen::Matrix3Xd positions(3, static_cast<Eigen::Index>(poses.size()));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    positions.col(static_cast<Eigen::Index>(i)) = poses[i].translation();
  }
  return positions;
}

std::optional<RelativeErrors> RootMeanSquares(double rotation_sum, double translation_sum,
                                              std::int64_t pairs) {
  if (pairs == 0) return std::nullopt;
  const auto n = static_cast<double>(pairs);
  return RelativeErrors{std::sqrt(rotation_sum / n), std::sqrt(translation_sum / n), pairs};
}

void CheckFinite(const char* name, std::size_t frame, const RigidTransform& pose) {
  if (pose.Matrix().allFinite()) return;
  ThrowError(StrCat(name, " of frame ", frame), "a pose that is not finite", "finite numbers");
}

}  // namespace

CommonPoses FindCommonPoses(const OptionalPoses& truth, const OptionalPoses& estimate) {
  if (truth.size() != estimate.size()) {
    ThrowError("trajectory comparison", StrCat(estimate.size(), " estimated frames"),
               StrCat(truth.size(), ", as many as true ones"));
  }
  CommonPoses common;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i]) CheckFinite("truth", i, *truth[i]);
    if (estimate[i]) CheckFinite("estimate", i, *estimate[i]);
    if (!truth[i] || !estimate[i]) continue;
    common.frames.push_back(static_cast<int>(i));
    common.truth.push_back(*truth[i]);
    common.estimate.push_back(*estimate[i]);
  }
  return common;
}

std::vector<double> AlignedPositionErrors(const CommonPoses& poses) {
  if (poses.size() == 0) return {};
  const Eigen::Matrix3Xd truth = Positions(poses.truth);
  const Eigen::Matrix3Xd estimate = Positions(poses.estimate);
  const RigidTransform truth_from_estimate = AlignPoints(estimate, truth);
  std::vector<double> errors;
  for (Eigen::Index i = 0; i < truth.cols(); ++i) {
    errors.push_back((truth_from_estimate * estimate.col(i) - truth.col(i)).norm());
  }
  return errors;
}

// With Q_i = R(P_i) R(G_i)^-1: |trans E_ij| = |(p_j - p_i) - Q_i (g_j - g_i)|, and the angle of
// E_ij is that of Q_j^-1 Q_i, which is the same for E_ji.
std::optional<RelativeErrors> AllPairsErrors(const CommonPoses& poses) {
  const std::size_t n = poses.size();
  const Eigen::Matrix3Xd g = Positions(poses.truth);
  const Eigen::Matrix3Xd p = Positions(poses.estimate);
  std::vector<Eigen::Quaterniond> Q;
  for (std::size_t i = 0; i < n; ++i) {
    Q.emplace_back(poses.estimate[i].rotation() * poses.truth[i].rotation().conjugate());
  }
  double rotation_sum = 0.0;
  double translation_sum = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    const Eigen::Matrix3d R = Q[i].toRotationMatrix();
    const Eigen::Vector3d offset = R * g.col(column) - p.col(column);
    // The term j = i is zero.
    translation_sum += ((p - R * g).colwise() + offset).squaredNorm();
    for (std::size_t j = 0; j < i; ++j) {
      rotation_sum += 2.0 * Square(RotationAngle(Q[j].conjugate() * Q[i]));
    }
  }
  const auto count = static_cast<std::int64_t>(n);
  return RootMeanSquares(rotation_sum, translation_sum, count * (count - 1));
}

std::optional<RelativeErrors> OneFrameErrors(const CommonPoses& poses) {
  double rotation_sum = 0.0;
  double translation_sum = 0.0;
  std::int64_t pairs = 0;
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    if (poses.frames[i + 1] != poses.frames[i] + 1) continue;
    const RigidTransform G = poses.truth[i].Inverse() * poses.truth[i + 1];
    const RigidTransform P = poses.estimate[i].Inverse() * poses.estimate[i + 1];
    const RigidTransform E = G.Inverse() * P;
    rotation_sum += Square(RotationAngle(E.rotation()));
    translation_sum += E.translation().squaredNorm();
    ++pairs;
  }
  return RootMeanSquares(rotation_sum, translation_sum, pairs);
}

}  // namespace cvo
