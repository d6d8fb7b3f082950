// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/solvers/schur_equations.h"

namespace cvo {

// Solves (H + D) dx = -g with D = diag(H) / radius (Levenberg-Marquardt; the diagonal has a lower
// bound) by eliminating the points. Owns its workspace, so that further solves of the same size
// allocate nothing.
class SchurSolver {
 public:
  explicit SchurSolver(const SchurEquations& equations);

  // Returns false if H + D is not positive definite or the step is not finite.
  bool Solve(const SchurEquations& equations, double radius, SchurStep& step);

  // Information of the shared variables with all others marginalised out, damped and linearised as
  // in the last Solve. The shared variables must be the last ones.
  Matrix6d SharedInformation() const;

 private:
  bool Eliminate(const SchurEquations& equations, std::size_t point, double radius);
  void AddPairs(const SchurEquations& equations, int begin, int end);
  void AddSharedColumns(const SchurEquations& equations, std::size_t point);
  void AssembleReduced(const SchurEquations& equations, double radius);
  void SubstitutePoints(const SchurEquations& equations, double radius, SchurStep& step) const;

  std::vector<Matrix6d> pairs_;  // sum of W V^-1 W^T, by row pose, then column pose up to it
  std::vector<Eigen::Matrix3d> point_root_;  // per point: L^-1 of H + D = L L^T
  std::vector<Matrix63d> E_;                 // W L^-T, per coupling of one point
  Eigen::VectorXd damping_;
  Eigen::VectorXd rhs_;
  Eigen::Matrix<double, Eigen::Dynamic, SchurEquations::kShared> shared_columns_;
  Eigen::MatrixXd S_;  // lower triangle
};

}  // namespace cvo
