// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/sized_cost_function.h>

#include "core/estimation/cluster_problem.h"

namespace cvo {

// r = sqrt_information (p - mean) of a PointPrior; block: p_in_object (3). `prior` must outlive it.
class PointPriorCost final : public ceres::SizedCostFunction<3, 3> {
 public:
  explicit PointPriorCost(const PointPrior& prior) : prior_(&prior) {}

  bool Evaluate(double const* const* blocks, double* residuals, double** jacobians) const override {
    const Eigen::Map<const Eigen::Vector3d> p_in_object(blocks[0]);
    Eigen::Map<Eigen::Vector3d> r(residuals);
    r = prior_->sqrt_information * (p_in_object - prior_->mean_in_object);
    if (jacobians && jacobians[0]) {
      Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> J(jacobians[0]);
      J = prior_->sqrt_information;
    }
    return true;
  }

 private:
  const PointPrior* prior_;
};

}  // namespace cvo
