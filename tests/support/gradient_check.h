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

// Computes df/dx at x by central differences with one Richardson step. The error is of order
// step^4, so the step (in the units of x) can be large enough to make rounding errors negligible.
Eigen::MatrixXd NumericJacobian(const VectorFunction& f, const Eigen::VectorXd& x,
                                double step = 1e-3);

// Succeeds if every entry is within tolerance * (1 + |numeric|) of the numeric Jacobian; otherwise
// the message names the worst entry. Usage: EXPECT_TRUE(JacobianMatches(f, x, J)).
testing::AssertionResult JacobianMatches(const VectorFunction& f, const Eigen::VectorXd& x,
                                         const Eigen::MatrixXd& analytic, double tolerance = 1e-6);

// One parameter block of a Ceres cost: its value and its manifold, if it has one.
struct ParameterBlock {
  Eigen::VectorXd value;
  const ceres::Manifold* manifold = nullptr;
};

// Compares the cost's Jacobians, in the tangent space of each block, with NumericJacobian along
// Manifold::Plus. Also checks that the residuals do not depend on which Jacobians are requested.
testing::AssertionResult CostJacobiansMatch(const ceres::CostFunction& cost,
                                            const std::vector<ParameterBlock>& blocks,
                                            double tolerance = 1e-6);

}  // namespace cvo::test
