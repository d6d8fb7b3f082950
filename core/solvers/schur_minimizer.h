// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "core/solvers/schur_solver.h"
#include "core/solvers/window_solver.h"

namespace cvo {

// The constants of Levenberg-Marquardt's method as Ceres sets them.
struct TrustRegion {
  static constexpr double kSmallestRadius = 1e-32;
  static constexpr double kLargestRadius = 1e16;
  static constexpr double kSmallestGain = 1e-3;  // of the energy against the model's expectation
  static constexpr double kSmallGradient = 1e-10;
  static constexpr double kSmallStep = 1e-8;  // relative to the variables

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

// A pose moved by a step of the equations: rotation in world axes from the left, then translation.
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

// Minimises an energy by Levenberg-Marquardt's method. The model:
//   double Linearize(SchurEquations&): the energy at the state, equations filled;
//   double TryStep(const SchurStep&): the energy at the state moved by a step;
//   void AcceptStep(): the state becomes the one last tried; double Norm(): of the variables.
// It stops as Ceres does, but keeps the step that turns out to be the last one.
template <typename Model>
SolverSummary MinimizeEnergy(const SolverOptions& options, SchurEquations& equations,
                             Model& model) {
  SolverSummary summary;
  SchurSolver solver(equations);
  SchurStep step;
  TrustRegion trust;
  bool converged = false;
  bool descended = false;
  double energy = summary.initial_cost = model.Linearize(equations);
  while (summary.iterations < options.iterations && trust.radius > TrustRegion::kSmallestRadius) {
    converged = equations.LargestGradient() <= TrustRegion::kSmallGradient;
    if (converged) break;
    ++summary.iterations;
    if (!solver.Solve(equations, trust.radius, step)) {
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
  if (equations.points_see_shared && summary.iterations > 0) {
    summary.shared_information = solver.SharedInformation();
  }
  summary.ending = converged   ? SolverEnding::kConverged
                   : descended ? SolverEnding::kIterationLimit
                               : SolverEnding::kNoUsableStep;
  return summary;
}

}  // namespace cvo
