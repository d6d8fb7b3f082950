// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/cost_function.h>
#include <ceres/manifold.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace cvo::test {

using VectorFunction = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

// df/dx at x by central differences with one Richardson step: error of order step^4, so the step
// (in the units of x) may be large enough to keep rounding out.
Eigen::MatrixXd NumericJacobian(const VectorFunction& f, const Eigen::VectorXd& x,
                                double step = 1e-3);

// EXPECT_TRUE(JacobianMatches(f, x, J)): every entry within tolerance * (1 + |numeric|); otherwise
// the message names the worst entry.
testing::AssertionResult JacobianMatches(const VectorFunction& f, const Eigen::VectorXd& x,
                                         const Eigen::MatrixXd& analytic, double tolerance = 1e-6);

// One parameter block of a Ceres cost: its value and, where it has one, its manifold.
struct ParameterBlock {
  Eigen::VectorXd value;
  const ceres::Manifold* manifold = nullptr;
};

// The cost's Jacobians in the tangent space of each block against NumericJacobian along
// Manifold::Plus; also that residuals do not depend on which Jacobians are asked for.
testing::AssertionResult CostJacobiansMatch(const ceres::CostFunction& cost,
                                            const std::vector<ParameterBlock>& blocks,
                                            double tolerance = 1e-6);

}  // namespace cvo::test
