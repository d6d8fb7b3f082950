// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/prior_cost.h"

#include "core/estimation/pose_manifold.h"

namespace cvo {

PriorCost::PriorCost(const WindowPrior& prior) : prior_(&prior) {
  set_num_residuals(static_cast<int>(prior.r0.size()));
  mutable_parameter_block_sizes()->assign(prior.frames.size(), 7);
  mutable_parameter_block_sizes()->push_back(1);
}

bool PriorCost::Evaluate(double const* const* blocks, double* residuals, double** jacobians) const {
  const int frames = static_cast<int>(prior_->frames.size());
  Eigen::VectorXd dx(6 * frames + 1);
  for (int i = 0; i < frames; ++i) {
    dx.segment<6>(6 * i) = PoseFromBlock(blocks[i]).Minus(prior_->linearization_point[i]);
  }
  dx[6 * frames] = blocks[frames][0] - prior_->right_shift_point_px;
  const Eigen::Index rows = prior_->r0.size();
  Eigen::Map<Eigen::VectorXd> r(residuals, rows);
  r = prior_->r0 + prior_->J0 * dx;
  if (!jacobians) return true;
  for (int i = 0; i < frames; ++i) {
    if (!jacobians[i]) continue;
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, 7, Eigen::RowMajor>> J(jacobians[i], rows, 7);
    const auto J0 = prior_->J0.middleCols<6>(6 * i);
    J.leftCols<3>() = J0.leftCols<3>() * InverseRightJacobianSo3(dx.segment<3>(6 * i));
    J.middleCols<3>(3) = J0.rightCols<3>();
    J.col(6).setZero();
  }
  if (jacobians[frames]) {
    Eigen::Map<Eigen::VectorXd> J(jacobians[frames], rows);
    J = prior_->J0.col(6 * frames);
  }
  return true;
}

}  // namespace cvo
