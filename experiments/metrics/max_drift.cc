// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/max_drift.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "experiments/metrics/object_scores.h"

namespace cvo {
namespace {

constexpr std::size_t kFirstFrames = 25;

// About x, y and z, applied in this order.
Eigen::Vector3d RollPitchYaw(const Eigen::Matrix3d& r) {
  return {std::atan2(r(2, 1), r(2, 2)), std::atan2(-r(2, 0), std::hypot(r(2, 1), r(2, 2))),
          std::atan2(r(1, 0), r(0, 0))};
}

// Of all motions since the first frame: what a point of it has as coordinates in each frame.
std::vector<RigidTransform> Motions(const std::vector<RigidTransform>& poses) {
  std::vector<RigidTransform> motions;
  for (const RigidTransform& pose : poses) motions.push_back(pose.Inverse() * poses.front());
  return motions;
}

// The difference of a motion of the truth, seen from the estimate's frame, and that of the
// estimate.
Vector6d Residual(const RigidTransform& estimate_from_truth, const RigidTransform& truth,
                  const RigidTransform& estimate) {
  const RigidTransform difference =
      estimate_from_truth * truth * estimate_from_truth.Inverse() * estimate.Inverse();
  Vector6d residual;
  residual << LogSo3(difference.rotation()), difference.translation();
  return residual;
}

// Gauss-Newton from the identity: the motions of a body that hardly turns leave the translation
// undetermined, so steps are damped.
RigidTransform AlignMotions(const std::vector<RigidTransform>& truth,
                            const std::vector<RigidTransform>& estimate, std::size_t frames,
                            RigidTransform start) {
  constexpr int kSteps = 30;
  constexpr double kDelta = 1e-6;
  constexpr double kDamping = 1e-9;
  constexpr double kDone = 1e-9;
  RigidTransform x = start;
  for (int step = 0; step < kSteps; ++step) {
    Matrix6d normal = kDamping * Matrix6d::Identity();
    Vector6d gradient = Vector6d::Zero();
    for (std::size_t i = 1; i < frames; ++i) {
      Matrix6d jacobian;
      for (int k = 0; k < 6; ++k) {
        const Vector6d tangent = kDelta * Vector6d::Unit(k);
        jacobian.col(k) = (Residual(x.Plus(tangent), truth[i], estimate[i]) -
                           Residual(x.Plus(-tangent), truth[i], estimate[i])) /
                          (2.0 * kDelta);
      }
      normal += jacobian.transpose() * jacobian;
      gradient += jacobian.transpose() * Residual(x, truth[i], estimate[i]);
    }
    const Vector6d tangent = -normal.ldlt().solve(gradient);
    x = x.Plus(tangent);
    if (tangent.norm() < kDone) break;
  }
  return x;
}

MaxDrift DriftOfPoses(const CommonPoses& poses) {
  const RigidTransform estimate_from_truth = AlignObject(poses);
  MaxDrift drift;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const RigidTransform error = poses.truth[i].Inverse() * poses.estimate[i] * estimate_from_truth;
    drift.translation_m = std::max(drift.translation_m, error.translation().norm());
    drift.roll_pitch_yaw_rad =
        drift.roll_pitch_yaw_rad.cwiseMax(RollPitchYaw(error.RotationMatrix()).cwiseAbs());
  }
  return drift;
}

MaxDrift DriftOfMotions(const CommonPoses& poses, std::size_t frames) {
  const std::vector<RigidTransform> truth = Motions(poses.truth);
  const std::vector<RigidTransform> estimate = Motions(poses.estimate);
  const RigidTransform estimate_from_truth =
      AlignMotions(truth, estimate, std::min(frames, poses.size()), AlignObject(poses));
  MaxDrift drift;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const RigidTransform error =
        estimate_from_truth.Inverse() * estimate[i] * estimate_from_truth * truth[i].Inverse();
    drift.translation_m = std::max(drift.translation_m, error.translation().norm());
    const Eigen::Vector3d angles = RollPitchYaw(error.RotationMatrix());
    if (angles.norm() > drift.roll_pitch_yaw_rad.norm()) {
      drift.roll_pitch_yaw_rad = angles.cwiseAbs();
    }
  }
  return drift;
}

}  // namespace

CommonPoses FromFirst(const CommonPoses& poses) {
  CommonPoses moved = poses;
  const RigidTransform truth = poses.truth.front().Inverse();
  const RigidTransform estimate = poses.estimate.front().Inverse();
  for (RigidTransform& pose : moved.truth) pose = truth * pose;
  for (RigidTransform& pose : moved.estimate) pose = estimate * pose;
  return moved;
}

std::optional<MaxDrift> MeasureMaxDrift(const CommonPoses& poses, DriftProtocol protocol) {
  if (poses.size() < 2) return std::nullopt;
  if (protocol == DriftProtocol::kAllPoses) return DriftOfPoses(poses);
  return DriftOfMotions(poses,
                        protocol == DriftProtocol::kFirstMotions ? kFirstFrames : poses.size());
}

}  // namespace cvo
