// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/solvers/schur_equations.h"

namespace cvo {

// Solves (H + D) dx = -g, D = diag(H) / radius (Levenberg-Marquardt), by eliminating the points.
// Holds the memory that this takes, so that solving again for the same sizes allocates nothing.
class SchurSolver {
 public:
  explicit SchurSolver(const SchurEquations& equations);

  // False where H + D is not positive definite.
  bool Solve(const SchurEquations& equations, double radius, SchurStep& step);

  // Of the shared variables, where they are the last ones, all others summed out: as damped and
  // linearised at the last Solve.
  Matrix6d SharedInformation() const;

 private:
  bool Eliminate(const SchurEquations& equations, std::size_t point, double radius);
  void AddPairs(const SchurEquations& equations, int begin, int end);
  void AddSharedColumns(const SchurEquations& equations, std::size_t point);
  void AssembleReduced(const SchurEquations& equations, double radius);
  void SubstitutePoints(const SchurEquations& equations, double radius, SchurStep& step) const;

  std::vector<Matrix6d> pairs_;              // by row pose, then column pose up to it: W V^-1 W^T
  std::vector<Eigen::Matrix3d> point_root_;  // by point: L^-1 of H + D = L L^T
  std::vector<Matrix63d> E_;                 // of one point, by coupling: W L^-T
  Eigen::VectorXd damping_;
  Eigen::VectorXd rhs_;
  Eigen::Matrix<double, Eigen::Dynamic, SchurEquations::kShared> shared_columns_;
  Eigen::MatrixXd S_;  // lower triangle
};

}  // namespace cvo
