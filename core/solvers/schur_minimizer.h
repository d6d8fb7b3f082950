// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "core/solvers/schur_solver.h"
#include "core/solvers/window_solver.h"

namespace cvo {

// Trust region of Levenberg-Marquardt, with the constants and update rules of Ceres.
struct TrustRegion {
  static constexpr double kSmallestRadius = 1e-32;
  static constexpr double kLargestRadius = 1e16;
  static constexpr double kSmallestGain = 1e-3;  // actual over expected decrease
  static constexpr double kSmallGradient = 1e-10;
  static constexpr double kSmallStep = 1e-8;  // relative to the norm of the variables

  double radius = 1e4;
  double shrink = 2.0;

  void Accept(double gain) {
    const double bent = 2.0 * gain - 1.0;
    radius = std::min(kLargestRadius, radius / std::max(1.0 / 3.0, 1.0 - bent * bent * bent));
    shrink = 2.0;
  }
  void Reject() {
    radius /= shrink;
    shrink *= 2.0;
  }
};

// Moves a pose by a step of the equations: rotation about world axes from the left, then
// translation.
inline RigidTransform MovePose(const RigidTransform& pose, const Vector6d& step) {
  Vector6d tangent = step;
  tangent.head<3>() = pose.rotation().conjugate() * Eigen::Vector3d(step.head<3>());
  return pose.Plus(tangent);
}

inline double SquaredNorm(const std::vector<RigidTransform>& poses) {
  double sum = 0.0;
  for (const RigidTransform& pose : poses) sum += 1.0 + pose.translation().squaredNorm();
  return sum;
}

inline double SquaredNorm(const std::vector<Eigen::Vector3d>& vectors) {
  double sum = 0.0;
  for (const Eigen::Vector3d& v : vectors) sum += v.squaredNorm();
  return sum;
}

// Minimises an energy by Levenberg-Marquardt. The model provides
//   double Linearize(SchurEquations&): fills the equations, returns the energy at the state;
//   double TryStep(const SchurStep&): returns the energy at the state moved by the step;
//   void AcceptStep(): makes the state tried last the current one;
//   double Norm(): returns the norm of the variables.
// The stopping criteria are those of Ceres, but a successful step that meets the function tolerance
// is kept.
template <typename Model>
SolverSummary MinimizeEnergy(const SolverOptions& options, SchurEquations& equations,
                             Model& model) {
  SolverSummary summary;
  SchurSolver solver(equations);
  SchurStep step;
  TrustRegion trust;
  bool solved = false;  // the last equations; otherwise they are only partly factored
  bool converged = false;
  bool descended = false;
  double energy = summary.initial_cost = model.Linearize(equations);
  while (summary.iterations < options.iterations && trust.radius > TrustRegion::kSmallestRadius) {
    converged = equations.LargestGradient() <= TrustRegion::kSmallGradient;
    if (converged) break;
    ++summary.iterations;
    solved = solver.Solve(equations, trust.radius, step);
    if (!solved) {
      trust.Reject();
      continue;
    }
    converged = step.norm <= TrustRegion::kSmallStep * (model.Norm() + TrustRegion::kSmallStep);
    if (converged) break;
    const double tried = model.TryStep(step);
    const double decrease = energy - tried;
    const double gain = decrease / step.expected_decrease;
    converged = std::abs(decrease) <= options.function_tolerance * energy;
    const bool accepted = gain > TrustRegion::kSmallestGain;
    if (accepted) {
      model.AcceptStep();
      energy = tried;
      descended = true;
      trust.Accept(gain);
    } else {
      trust.Reject();
    }
    if (converged || summary.iterations == options.iterations) break;
    if (accepted) model.Linearize(equations);
  }
  summary.final_cost = energy;
  if (equations.points_see_shared && solved) {
    summary.shared_information = solver.SharedInformation();
  }
  summary.ending = converged   ? SolverEnding::kConverged
                   : descended ? SolverEnding::kIterationLimit
                               : SolverEnding::kNoUsableStep;
  return summary;
}

}  // namespace cvo
