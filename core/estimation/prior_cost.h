// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/cost_function.h>

#include "core/estimation/pose_prior.h"

namespace cvo {

// r = r0 + J0 dx of a PosePrior; one 7-block per frame, in the prior's order. The tangent's
// rotation part is differentiated exactly (inverse right Jacobian). `prior` must outlive it.
class PriorCost final : public ceres::CostFunction {
 public:
  explicit PriorCost(const PosePrior& prior);
  bool Evaluate(double const* const* blocks, double* residuals, double** jacobians) const override;

 private:
  const PosePrior* prior_;
};

}  // namespace cvo
