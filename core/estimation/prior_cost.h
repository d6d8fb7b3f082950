// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/cost_function.h>

#include "core/estimation/window_prior.h"

namespace cvo {

// r = r0 + J0 dx of a WindowPrior; one 7-block per frame, in the prior's order, then
// right_shift_px. The tangent's rotation part is differentiated exactly (inverse right Jacobian).
// `prior` must outlive it.
class PriorCost final : public ceres::CostFunction {
 public:
  explicit PriorCost(const WindowPrior& prior);
  bool Evaluate(double const* const* blocks, double* residuals, double** jacobians) const override;

 private:
  const WindowPrior* prior_;
};

}  // namespace cvo
