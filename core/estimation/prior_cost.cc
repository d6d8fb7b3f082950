// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/prior_cost.h"

#include "core/estimation/pose_manifold.h"

namespace cvo {

PriorCost::PriorCost(const PosePrior& prior) : prior_(&prior) {
  set_num_residuals(static_cast<int>(prior.r0.size()));
  mutable_parameter_block_sizes()->assign(prior.frames.size(), 7);
}

bool PriorCost::Evaluate(double const* const* blocks, double* residuals, double** jacobians) const {
  const int frames = static_cast<int>(prior_->frames.size());
  Eigen::VectorXd dx(6 * frames);
  for (int i = 0; i < frames; ++i) {
    dx.segment<6>(6 * i) = PoseFromBlock(blocks[i]).Minus(prior_->linearization_point[i]);
  }
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
  return true;
}

}  // namespace cvo
