// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/solvers/schur_equations.h"

#include <algorithm>

#include "core/base/error.h"

namespace cvo {

namespace {

// Jacobian of the prior's tangent of a frame with respect to that of the equations (rotation about
// world axes).
Matrix6d TangentJacobian(const Vector6d& difference, const RigidTransform& world_from_camera) {
  Matrix6d D = Matrix6d::Identity();
  D.topLeftCorner<3, 3>() = InverseRightJacobianSo3(difference.head<3>()) *
                            world_from_camera.RotationMatrix().transpose();
  return D;
}

}  // namespace

SchurPrior::SchurPrior(const WindowPrior& prior, std::vector<int> frame_index)
    : prior_(&prior), frame_index_(std::move(frame_index)) {
  H0_.setZero(prior.J0.cols(), prior.J0.cols());
  H0_.selfadjointView<Eigen::Lower>().rankUpdate(prior.J0.transpose());
}

Eigen::VectorXd SchurPrior::Difference(const std::vector<RigidTransform>& world_from_camera,
                                       const Vector6d& right_field_px) const {
  const int frames = static_cast<int>(frame_index_.size());
  Eigen::VectorXd dx(6 * frames + 6);
  for (int i = 0; i < frames; ++i) {
    dx.segment<6>(6 * i) = world_from_camera[frame_index_[i]].Minus(prior_->linearization_point[i]);
  }
  dx.tail<6>() = right_field_px - prior_->right_field_point_px;
  return dx;
}

double SchurPrior::Energy(const std::vector<RigidTransform>& world_from_camera,
                          const Vector6d& right_field_px) const {
  if (prior_->r0.size() == 0) return 0.0;
  const Eigen::VectorXd dx = Difference(world_from_camera, right_field_px);
  return 0.5 * (prior_->r0 + prior_->J0 * dx).squaredNorm();
}

void SchurPrior::AddTo(const std::vector<RigidTransform>& world_from_camera,
                       const Vector6d& right_field_px, bool is_right_field_fixed,
                       const std::vector<int>& pose_of_frame, SchurEquations& equations) const {
  if (prior_->r0.size() == 0) return;
  const Eigen::VectorXd dx = Difference(world_from_camera, right_field_px);
  const Eigen::VectorXd g = prior_->J0.transpose() * (prior_->r0 + prior_->J0 * dx);
  const int frames = static_cast<int>(frame_index_.size());
  std::vector<Matrix6d> D(frames);
  for (int i = 0; i < frames; ++i) {
    const int pose = pose_of_frame[frame_index_[i]];
    if (pose < 0) continue;
    D[i] = TangentJacobian(dx.segment<6>(6 * i), world_from_camera[frame_index_[i]]);
    equations.g.segment<6>(6 * pose).noalias() += D[i].transpose() * g.segment<6>(6 * i);
    for (int k = 0; k <= i; ++k) {
      const int other = pose_of_frame[frame_index_[k]];
      if (other < 0) continue;
      Matrix6d H0 = H0_.block<6, 6>(6 * i, 6 * k);
      if (i == k) H0 = H0.selfadjointView<Eigen::Lower>();
      equations.H.block<6, 6>(6 * pose, 6 * other) += D[i].transpose() * H0 * D[k];
    }
  }
  if (is_right_field_fixed) return;
  const int field = equations.others_begin();
  equations.g.segment<6>(field) += g.tail<6>();
  equations.H.block<6, 6>(field, field) += H0_.block<6, 6>(6 * frames, 6 * frames);
  for (int i = 0; i < frames; ++i) {
    const int pose = pose_of_frame[frame_index_[i]];
    if (pose < 0) continue;
    equations.H.block<6, 6>(field, 6 * pose) += H0_.block<6, 6>(6 * frames, 6 * i) * D[i];
  }
}

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
