// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/max_drift.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "experiments/metrics/alignment.h"

namespace cvo {
namespace {

using reports::MaxDrift;

constexpr std::size_t kFirstFrames = 25;

// Absolute values of the angles about x, y and z, in this order.
Eigen::Vector3d RollPitchYaw(const RigidTransform& pose) {
  const Eigen::Matrix3d r = pose.RotationMatrix();
  return Eigen::Vector3d(std::atan2(r(2, 1), r(2, 2)),
                         std::atan2(-r(2, 0), std::hypot(r(2, 1), r(2, 2))),
                         std::atan2(r(1, 0), r(0, 0)))
      .cwiseAbs();
}

MaxDrift DriftOf(double translation_m, const Eigen::Vector3d& roll_pitch_yaw) {
  return {translation_m, roll_pitch_yaw.x(), roll_pitch_yaw.y(), roll_pitch_yaw.z()};
}

// Transforms from the body frame at the first pose to the body frame at each pose.
std::vector<RigidTransform> Motions(const std::vector<RigidTransform>& poses) {
  std::vector<RigidTransform> motions;
  for (const RigidTransform& pose : poses) motions.push_back(pose.Inverse() * poses.front());
  return motions;
}

// Motions since the first frame, and their error for a given alignment.
struct MotionPairs {
  std::vector<RigidTransform> truth;
  std::vector<RigidTransform> estimate;

  RigidTransform Error(std::size_t i, const RigidTransform& object_from_gtobject) const {
    return object_from_gtobject.Inverse() * estimate[i] * object_from_gtobject * truth[i].Inverse();
  }
};

struct NormalEquations {
  Matrix6d normal = Matrix6d::Zero();
  Vector6d gradient = Vector6d::Zero();
  double cost = 0.0;
};

// Linearises the errors in d for X Exp(d), in the frame of the true body, where they do not depend
// on the body frame of the estimate. The Jacobian of the rotation omits J_r^-1, which does not
// change the gradient.
NormalEquations Linearise(const MotionPairs& motions, std::size_t frames, const RigidTransform& X) {
  NormalEquations equations;
  for (std::size_t i = 1; i < frames; ++i) {
    const RigidTransform error = motions.Error(i, X);
    const Eigen::Matrix3d R = error.RotationMatrix();
    const Eigen::Matrix3d R_gt = motions.truth[i].RotationMatrix();
    Vector6d residual;
    residual << LogSo3(error.rotation()), error.translation();
    Matrix6d J = Matrix6d::Zero();
    J.topLeftCorner<3, 3>() = R_gt - R.transpose();
    J.bottomLeftCorner<3, 3>() =
        Skew(error.translation()) + R * Skew(motions.truth[i].translation()) * R_gt;
    J.bottomRightCorner<3, 3>() = R * R_gt - Eigen::Matrix3d::Identity();
    equations.normal += J.transpose() * J;
    equations.gradient += J.transpose() * residual;
    equations.cost += residual.squaredNorm();
  }
  return equations;
}

}  // namespace

// Levenberg-Marquardt, started from the closed-form alignment of the poses. A body that hardly
// turns leaves the translation undetermined; because of the damping, it stays at its start value.
RigidTransform AlignByMotions(const CommonPoses& poses, std::size_t frames) {
  constexpr int kSteps = 100;
  constexpr double kLeastDamping = 1e-9;
  constexpr double kDone = 1e-12;
  constexpr double kRounding = 1.0 + 1e-9;
  const MotionPairs motions = {Motions(poses.truth), Motions(poses.estimate)};
  CommonPoses first = poses;
  first.frames.resize(frames);
  RigidTransform X = AlignObject(first);
  RigidTransform best = X;
  NormalEquations at_best = Linearise(motions, frames, X);
  double damping = kLeastDamping;
  for (int step = 0; step < kSteps; ++step) {
    Matrix6d normal = at_best.normal;
    normal.diagonal().array() += damping * static_cast<double>(frames);
    const Vector6d tangent = -normal.ldlt().solve(at_best.gradient);
    if (!(tangent.norm() > kDone)) break;
    X = best * RigidTransform(ExpSo3(tangent.head<3>()), Eigen::Vector3d(tangent.tail<3>()));
    const NormalEquations equations = Linearise(motions, frames, X);
    const bool is_better = equations.cost <= kRounding * at_best.cost;
    damping = is_better ? std::max(0.1 * damping, kLeastDamping) : 10.0 * damping;
    if (!is_better) continue;
    best = X;
    at_best = equations;
  }
  return best;
}

namespace {

MaxDrift DriftOfPoses(const CommonPoses& poses) {
  const RigidTransform object_from_gtobject = AlignObject(poses);
  double translation_m = 0.0;
  Eigen::Vector3d angles = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const RigidTransform error =
        poses.truth[i].Inverse() * poses.estimate[i] * object_from_gtobject;
    translation_m = std::max(translation_m, error.translation().norm());
    angles = angles.cwiseMax(RollPitchYaw(error));
  }
  return DriftOf(translation_m, angles);
}

// Largest errors over all frames, after an alignment by the motions of the first `frames` poses.
MaxDrift DriftOfMotions(const CommonPoses& poses, std::size_t frames) {
  const MotionPairs motions = {Motions(poses.truth), Motions(poses.estimate)};
  const RigidTransform object_from_gtobject = AlignByMotions(poses, frames);
  double translation_m = 0.0;
  Eigen::Vector3d angles = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const RigidTransform error = motions.Error(i, object_from_gtobject);
    translation_m = std::max(translation_m, error.translation().norm());
    const Eigen::Vector3d here = RollPitchYaw(error);
    if (here.norm() > angles.norm()) angles = here;
  }
  return DriftOf(translation_m, angles);
}

}  // namespace

RigidTransform AlignAtFirst(const CommonPoses& poses) {
  if (poses.size() == 0) return {};
  return poses.truth.front() * poses.estimate.front().Inverse();
}

std::optional<reports::MaxDrifts> MeasureMaxDrift(const CommonPoses& poses,
                                                  const RigidTransform& truth_from_estimate) {
  if (poses.size() < 2) return std::nullopt;
  CommonPoses moved = poses;
  for (RigidTransform& pose : moved.estimate) pose = truth_from_estimate * pose;
  return reports::MaxDrifts{DriftOfPoses(moved), DriftOfMotions(moved, poses.size()),
                            DriftOfMotions(moved, std::min(kFirstFrames, poses.size()))};
}

}  // namespace cvo
