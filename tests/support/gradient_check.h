// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>

namespace cvo::test {

// Returns df/dx at x by central differences.
template <typename Function>
Eigen::MatrixXd CentralDifferences(const Function& f, const Eigen::VectorXd& x, double step) {
  Eigen::MatrixXd J(f(x).size(), x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const Eigen::VectorXd dx = step * Eigen::VectorXd::Unit(x.size(), i);
    J.col(i) = (f(x + dx) - f(x - dx)) / (2.0 * step);
  }
  return J;
}

// Succeeds if every entry is within tolerance * (1 + |numeric|) of the numeric Jacobian. Usage:
// EXPECT_TRUE(JacobianMatches(f, x, J)). A Richardson step makes the error of differences of order
// step^4, so that a large step makes rounding errors negligible.
template <typename Function>
testing::AssertionResult JacobianMatches(const Function& f, const Eigen::VectorXd& x,
                                         const Eigen::MatrixXd& analytic, double tolerance = 1e-6) {
  const Eigen::MatrixXd numeric =
      (4.0 * CentralDifferences(f, x, 5e-4) - CentralDifferences(f, x, 1e-3)) / 3.0;
  const bool has_size = analytic.rows() == numeric.rows() && analytic.cols() == numeric.cols();
  if (has_size &&
      ((analytic - numeric).array().abs() <= tolerance * (1.0 + numeric.array().abs())).all()) {
    return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << "analytic\n" << analytic << "\nnumeric\n" << numeric;
}

}  // namespace cvo::test
