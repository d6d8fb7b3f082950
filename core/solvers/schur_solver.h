// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/solvers/cluster_solver.h"
#include "core/solvers/reprojection_cost.h"
#include "core/solvers/window_solver.h"

namespace cvo {

using Matrix63d = Eigen::Matrix<double, 6, 3>;
using Matrix36d = Eigen::Matrix<double, 3, 6>;

// Coupling of a point to a free pose by an observation: d^2 E / (d pose d point) = G^T M with
// G = [[lever]_x, -I], where `lever` is the vector from the pose's origin to the point, in world
// axes.
struct PoseCoupling {
  int pose = 0;
  Eigen::Vector3d lever = Eigen::Vector3d::Zero();
  Eigen::Matrix3d M = Eigen::Matrix3d::Zero();
};

// Returns G^T A for the G of PoseCoupling.
inline Matrix63d LeverTransposeTimes(const Eigen::Vector3d& lever, const Eigen::Matrix3d& A) {
  Matrix63d product;
  for (int k = 0; k < 3; ++k) {
    product(0, k) = A(1, k) * lever.z() - A(2, k) * lever.y();
    product(1, k) = A(2, k) * lever.x() - A(0, k) * lever.z();
    product(2, k) = A(0, k) * lever.y() - A(1, k) * lever.x();
    product(3, k) = -A(0, k);
    product(4, k) = -A(1, k);
    product(5, k) = -A(2, k);
  }
  return product;
}

struct PointEquations {
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  Eigen::Vector3d g = Eigen::Vector3d::Zero();
  Matrix36d by_shared = Matrix36d::Zero();  // d^2 E / (d point d shared variables)
};

// Normal equations H dx = -g of an energy over poses (tangent: rotation about world axes applied
// from the left, then translation), a few other variables, and many points. A point is coupled only
// to poses and, if `points_see_shared`, to the first kShared of the other variables.
struct SchurEquations {
  static constexpr int kShared = 6;

  // Observations must be sorted by point, then by ascending pose. `pose_of_frame` is -1 for a pose
  // that is held fixed.
  SchurEquations(const std::vector<int>& pose_of_frame, int others, std::size_t point_count,
                 const std::vector<ReprojectionFactor>& factors);
  void SetZero();
  double LargestGradient() const;
  int others_begin() const { return 6 * static_cast<int>(pose_H.size()); }

  std::vector<Matrix6d> pose_H;  // per pose: block from the observations
  Eigen::MatrixXd H;             // all other terms in poses and others; lower triangle
  Eigen::VectorXd g;
  std::vector<PointEquations> points;
  std::vector<PoseCoupling> couplings;  // sorted by point, then by ascending pose
  std::vector<int> couplings_begin;     // per point, plus the end of the last
  bool points_see_shared = false;
};

struct SchurStep {
  Eigen::VectorXd reduced;  // poses, then others
  std::vector<Eigen::Vector3d> points;
  double expected_decrease = 0.0;  // of the energy, by the undamped quadratic model
  double norm = 0.0;
};

// A frame of the static window in the form that the inner loops need. Points are in the world and
// move against the camera. With B = d r / d (point in world axes),
// J_pose = kSign B [[lever]_x, -I].
struct CameraView {
  static constexpr double kSign = 1.0;
  int pose = -1;  // index in the equations; -1: held fixed
  Eigen::Matrix3d camera_from_world;
  Eigen::Vector3d position;

  CameraView(int pose_column, const RigidTransform& world_from_camera)
      : pose(pose_column),
        camera_from_world(world_from_camera.RotationMatrix().transpose()),
        position(world_from_camera.translation()) {}
  Eigen::Vector3d Lever(const Eigen::Vector3d& p_in_world) const { return p_in_world - position; }
  Eigen::Vector3d InCamera(const Eigen::Vector3d& lever) const { return camera_from_world * lever; }
  const Eigen::Matrix3d& TimesPointAxes(const Eigen::Matrix3d& N) const { return N; }
  const Eigen::Matrix3d& PointAxesTimes(const Eigen::Matrix3d& N) const { return N; }
  const Eigen::Vector3d& PointAxesTimes(const Eigen::Vector3d& g) const { return g; }
};

// A frame of a cluster: points are in the body frame and move with the body; the camera is held
// fixed.
struct ObjectView {
  static constexpr double kSign = -1.0;
  int pose = -1;
  Eigen::Matrix3d camera_from_world;
  Eigen::Matrix3d world_from_object;
  Eigen::Vector3d offset;  // from the camera to the body's origin, in world

  ObjectView(int pose_column, const RigidTransform& world_from_camera, const RigidTransform& object)
      : pose(pose_column),
        camera_from_world(world_from_camera.RotationMatrix().transpose()),
        world_from_object(object.RotationMatrix()),
        offset(object.translation() - world_from_camera.translation()) {}
  Eigen::Vector3d Lever(const Eigen::Vector3d& p_in_object) const {
    return world_from_object * p_in_object;
  }
  Eigen::Vector3d InCamera(const Eigen::Vector3d& lever) const {
    return camera_from_world * (lever + offset);
  }
  Eigen::Matrix3d TimesPointAxes(const Eigen::Matrix3d& N) const { return N * world_from_object; }
  Eigen::Matrix3d PointAxesTimes(const Eigen::Matrix3d& N) const {
    return world_from_object.transpose() * N;
  }
  Eigen::Vector3d PointAxesTimes(const Eigen::Vector3d& g) const {
    return world_from_object.transpose() * g;
  }
};

// Returns 1/2 sum rho(||W (pi(p_in_camera) - z)||^2) over the factors; `views` holds one per frame.
template <typename View>
double ReprojectionEnergy(const StereoCamera& camera, const std::vector<View>& views,
                          const std::vector<Eigen::Vector3d>& points,
                          const std::vector<ReprojectionFactor>& factors, double huber) {
  double energy = 0.0;
  for (const ReprojectionFactor& factor : factors) {
    const View& view = views[factor.pose];
    const Eigen::Vector3d c = view.InCamera(view.Lever(points[factor.point]));
    const Eigen::Vector3d r = EvaluateResidual(camera, factor.z_px, factor.sqrt_information, c);
    energy += HuberLoss(r.squaredNorm(), huber);
  }
  return 0.5 * energy;
}

// One factor after the robust loss: N = B^T B and g = B^T r, in world axes. The Jacobian with
// respect to the shared variables is W e_3 basis^T, and u = B^T W e_3.
struct WeightedFactor {
  Eigen::Vector3d lever;
  Eigen::Matrix3d N;
  Eigen::Vector3d g;
  Eigen::Vector3d u;
  Vector6d basis;
};

inline void AddToPose(int pose, double sign, const WeightedFactor& factor,
                      SchurEquations& equations) {
  const Eigen::Vector3d& lever = factor.lever;
  const Matrix63d E = LeverTransposeTimes(lever, factor.N);
  Matrix6d& H = equations.pose_H[pose];
  H.col(0) += E.col(1) * lever.z() - E.col(2) * lever.y();
  H.col(1) += E.col(2) * lever.x() - E.col(0) * lever.z();
  H.col(2) += E.col(0) * lever.y() - E.col(1) * lever.x();
  H.bottomRightCorner<3, 3>() += factor.N;
  equations.g.segment<3>(6 * pose) += sign * factor.g.cross(lever);
  equations.g.segment<3>(6 * pose + 3) -= sign * factor.g;
  if (!equations.points_see_shared) return;
  Vector6d by_pose;
  by_pose << sign * factor.u.cross(lever), -sign * factor.u;
  equations.H.block<6, 6>(equations.others_begin(), 6 * pose).noalias() +=
      factor.basis * by_pose.transpose();
}

// Adds a factor's terms in the shared variables, right_field_px.
inline void AddToShared(const Eigen::Vector3d& J_shift, double weight, const Eigen::Vector3d& r,
                        const Vector6d& basis, SchurEquations& equations) {
  const int shared = equations.others_begin();
  equations.H.block<6, 6>(shared, shared).noalias() +=
      (weight * J_shift.squaredNorm()) * basis * basis.transpose();
  equations.g.segment<6>(shared) += weight * J_shift.dot(r) * basis;
}

// Adds the factors to the equations and sets the couplings; returns ReprojectionEnergy.
template <typename View>
double LinearizeReprojections(const StereoCamera& camera, const std::vector<View>& views,
                              const std::vector<Eigen::Vector3d>& points,
                              const std::vector<ReprojectionFactor>& factors, double huber,
                              SchurEquations& equations) {
  double energy = 0.0;
  std::size_t next = 0;  // index of the next coupling
  WeightedFactor weighted;
  for (const ReprojectionFactor& factor : factors) {
    const View& view = views[factor.pose];
    weighted.lever = view.Lever(points[factor.point]);
    const auto [r, J, zeta_px] = EvaluateProjection(camera, factor.z_px, factor.sqrt_information,
                                                    view.InCamera(weighted.lever));
    const double squared_norm = r.squaredNorm();
    energy += HuberLoss(squared_norm, huber);
    const double weight = HuberWeight(squared_norm, huber);
    const Eigen::Matrix3d B = J * view.camera_from_world;
    const Eigen::Matrix3d B_weighted = weight * B;
    weighted.N.noalias() = B_weighted.transpose() * B;
    weighted.g.noalias() = B_weighted.transpose() * r;
    const Eigen::Matrix3d coupling = view.TimesPointAxes(weighted.N);
    PointEquations& point = equations.points[factor.point];
    point.H += view.PointAxesTimes(coupling);
    point.g += view.PointAxesTimes(weighted.g);
    if (equations.points_see_shared) {
      const Eigen::Vector3d J_shift = factor.sqrt_information.col(2);
      weighted.u.noalias() = B_weighted.transpose() * J_shift;
      weighted.basis = camera.BasisAt(zeta_px[0], zeta_px[1]).value;
      point.by_shared.noalias() += view.PointAxesTimes(weighted.u) * weighted.basis.transpose();
      AddToShared(J_shift, weight, r, weighted.basis, equations);
    }
    if (view.pose < 0) continue;
    AddToPose(view.pose, View::kSign, weighted, equations);
    equations.couplings[next++] = {view.pose, weighted.lever, View::kSign * coupling};
  }
  return 0.5 * energy;
}

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

// Policy that minimises the energies of windows in place: our own Schur complement solver
// (METHOD.md 7.5).
struct OwnSchur {
  static SolverSummary Solve(const NoiseOptions& noise, const SolverOptions& options,
                             WindowProblem& problem) {
    return SolveWindow(noise, options, problem);
  }
  static SolverSummary Solve(const NoiseOptions& noise, const SolverOptions& options,
                             const MotionPriorSteps& steps, ClusterProblem& problem) {
    return SolveClusterSteps(noise, options, steps, problem);
  }
};

}  // namespace cvo
