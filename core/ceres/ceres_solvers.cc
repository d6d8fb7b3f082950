// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/ceres/ceres_solvers.h"

#include <ceres/loss_function.h>
#include <ceres/ordered_groups.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <algorithm>
#include <deque>
#include <memory>

namespace cvo::ceres_costs {
namespace {

using PoseJacobian = Eigen::Matrix<double, 6, 7, Eigen::RowMajor>;
using VelocityJacobian = Eigen::Matrix<double, 6, 3, Eigen::RowMajor>;

void WriteByPose(double displacement, double* jacobian) {
  if (!jacobian) return;
  Eigen::Map<PoseJacobian> J(jacobian);
  J.setZero();
  J.block<3, 3>(0, 3).diagonal().setConstant(displacement);
}

void WriteByVelocity(double velocity, double change, double* jacobian) {
  if (!jacobian) return;
  Eigen::Map<VelocityJacobian> J(jacobian);
  J << velocity * Eigen::Matrix3d::Identity(), change * Eigen::Matrix3d::Identity();
}

}  // namespace

RigidTransform PoseFromBlock(const double* block) {
  return {Eigen::Quaterniond(Eigen::Map<const Eigen::Quaterniond>(block)),
          Eigen::Vector3d(Eigen::Map<const Eigen::Vector3d>(block + 4))};
}

bool PoseManifold::Plus(const double* x, const double* delta, double* x_plus_delta) const {
  const RigidTransform moved = PoseFromBlock(x).Plus(Eigen::Map<const Vector6d>(delta));
  std::copy_n(moved.data(), 7, x_plus_delta);
  return true;
}

bool PoseManifold::PlusJacobian(const double*, double* jacobian) const {
  Eigen::Map<Eigen::Matrix<double, 7, 6, Eigen::RowMajor>> J(jacobian);
  J.setZero();
  J.topRows<6>().setIdentity();
  return true;
}

bool PoseManifold::Minus(const double* y, const double* x, double* y_minus_x) const {
  Eigen::Map<Vector6d> tangent(y_minus_x);
  tangent = PoseFromBlock(y).Minus(PoseFromBlock(x));
  return true;
}

bool PoseManifold::MinusJacobian(const double*, double* jacobian) const {
  Eigen::Map<Eigen::Matrix<double, 6, 7, Eigen::RowMajor>> J(jacobian);
  J.setZero();
  J.leftCols<6>().setIdentity();
  return true;
}

bool ReprojectionCost::Evaluate(double const* const* blocks, double* residuals,
                                double** jacobians) const {
  const Eigen::Map<const Eigen::Quaterniond> q(blocks[0]);
  const Eigen::Map<const Eigen::Vector3d> position(blocks[0] + 4);
  const Eigen::Map<const Eigen::Vector3d> p_in_world(blocks[1]);
  StereoCamera camera = camera_;
  camera.right_field_px = Eigen::Map<const Vector6d>(blocks[2]);
  const ReprojectionResidual value = EvaluateReprojection(
      camera, z_px_, sqrt_information_,
      RigidTransform(Eigen::Quaterniond(q), Eigen::Vector3d(position)), p_in_world);
  Eigen::Map<Eigen::Vector3d> r(residuals);
  r = value.r;
  if (!jacobians) return true;
  if (jacobians[0]) {
    Eigen::Map<Eigen::Matrix<double, 3, 7, Eigen::RowMajor>> J(jacobians[0]);
    J << value.J_pose, Eigen::Vector3d::Zero();
  }
  if (jacobians[1]) {
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> J(jacobians[1]);
    J = value.J_point;
  }
  if (jacobians[2]) {
    Eigen::Map<Eigen::Matrix<double, 3, 6, Eigen::RowMajor>> J(jacobians[2]);
    J = value.J_field;
  }
  return true;
}

PriorCost::PriorCost(const WindowPrior& prior) : prior_(&prior) {
  set_num_residuals(static_cast<int>(prior.r0.size()));
  mutable_parameter_block_sizes()->assign(prior.frames.size(), 7);
  mutable_parameter_block_sizes()->push_back(6);
}

bool PriorCost::Evaluate(double const* const* blocks, double* residuals, double** jacobians) const {
  const int frames = static_cast<int>(prior_->frames.size());
  Eigen::VectorXd dx(6 * frames + 6);
  for (int i = 0; i < frames; ++i) {
    dx.segment<6>(6 * i) = PoseFromBlock(blocks[i]).Minus(prior_->linearization_point[i]);
  }
  dx.tail<6>() = Eigen::Map<const Vector6d>(blocks[frames]) - prior_->right_field_point_px;
  const Eigen::Index rows = prior_->r0.size();
  Eigen::Map<Eigen::VectorXd> r(residuals, rows);
  r = prior_->r0 + prior_->J0 * dx;
  if (!jacobians) return true;
  for (int i = 0; i < frames; ++i) {
    if (!jacobians[i]) continue;
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, 7, Eigen::RowMajor>> J(jacobians[i], rows, 7);
    const auto J0 = prior_->J0.middleCols<6>(6 * i);
    J.leftCols<3>() = J0.leftCols<3>() * InverseRightJacobianSo3(dx.segment<3>(6 * i));
    J.middleCols<3>(3) = J0.rightCols<3>();
    J.col(6).setZero();
  }
  if (jacobians[frames]) {
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor>> J(jacobians[frames], rows,
                                                                            6);
    J = prior_->J0.rightCols<6>();
  }
  return true;
}

ObjectReprojectionResidual EvaluateObjectReprojection(const StereoCamera& camera,
                                                      const Eigen::Vector3d& z_px,
                                                      const Eigen::Matrix3d& sqrt_information,
                                                      const RigidTransform& world_from_camera,
                                                      const RigidTransform& world_from_object,
                                                      const Eigen::Vector3d& p_in_object) {
  const Eigen::Matrix3d R = world_from_camera.RotationMatrix().transpose();
  const Eigen::Matrix3d R_object = world_from_object.RotationMatrix();
  const Eigen::Vector3d c = R * (R_object * p_in_object + (world_from_object.translation() -
                                                           world_from_camera.translation()));
  const ProjectionResidual projection = EvaluateProjection(camera, z_px, sqrt_information, c);
  ObjectReprojectionResidual result;
  result.r = projection.r;
  result.J_pose.rightCols<3>() = projection.J * R;
  result.J_point = result.J_pose.rightCols<3>() * R_object;
  result.J_pose.leftCols<3>() = -result.J_point * Skew(p_in_object);
  return result;
}

bool ObjectReprojectionCost::Evaluate(double const* const* blocks, double* residuals,
                                      double** jacobians) const {
  const Eigen::Map<const Eigen::Vector3d> p_in_object(blocks[1]);
  const ObjectReprojectionResidual value = EvaluateObjectReprojection(
      camera_, z_px_, sqrt_information_, world_from_camera_, PoseFromBlock(blocks[0]), p_in_object);
  Eigen::Map<Eigen::Vector3d> r(residuals);
  r = value.r;
  if (!jacobians) return true;
  if (jacobians[0]) {
    Eigen::Map<Eigen::Matrix<double, 3, 7, Eigen::RowMajor>> J(jacobians[0]);
    J << value.J_pose, Eigen::Vector3d::Zero();
  }
  if (jacobians[1]) {
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> J(jacobians[1]);
    J = value.J_point;
  }
  return true;
}

bool MotionPriorCost::Evaluate(double const* const* blocks, double* residuals,
                               double** jacobians) const {
  using Vector = Eigen::Map<const Eigen::Vector3d>;
  Eigen::Map<Vector6d> r(residuals);
  r = EvaluateMotionPrior(factors_, Vector(blocks[0] + 4), Vector(blocks[1]), Vector(blocks[2] + 4),
                          Vector(blocks[3]));
  if (!jacobians) return true;
  const Eigen::Matrix<double, 2, 4> J = MotionPriorAxisJacobian(factors_);
  WriteByPose(J(0, 0), jacobians[0]);
  WriteByVelocity(J(0, 1), J(1, 1), jacobians[1]);
  WriteByPose(J(0, 2), jacobians[2]);
  WriteByVelocity(J(0, 3), J(1, 3), jacobians[3]);
  return true;
}

bool TurnPriorCost::Evaluate(double const* const* blocks, double* residuals,
                             double** jacobians) const {
  std::array<Eigen::Quaterniond, 3> world_from_object;
  for (int i = 0; i < 3; ++i) {
    world_from_object[i] = Eigen::Map<const Eigen::Quaterniond>(blocks[i]);
  }
  const TurnPrior value = EvaluateTurnPrior(power_density_rad2_s3_, dt_s_, world_from_object);
  Eigen::Map<Eigen::Vector3d> r(residuals);
  r = value.r;
  if (!jacobians) return true;
  for (int i = 0; i < 3; ++i) {
    if (!jacobians[i]) continue;
    Eigen::Map<Eigen::Matrix<double, 3, 7, Eigen::RowMajor>> J(jacobians[i]);
    J.setZero();
    // value.J is with respect to rotations about world axes, the manifold's tangent about body
    // axes.
    J.leftCols<3>() = value.J[i] * world_from_object[i].toRotationMatrix();
  }
  return true;
}

}  // namespace cvo::ceres_costs

namespace cvo {

namespace {

using ceres_costs::MotionPriorCost;
using ceres_costs::ObjectReprojectionCost;
using ceres_costs::PointPriorCost;
using ceres_costs::PoseManifold;
using ceres_costs::PriorCost;
using ceres_costs::ReprojectionCost;
using ceres_costs::TurnPriorCost;

using Ordering = std::shared_ptr<ceres::ParameterBlockOrdering>;

ceres::Problem::Options NonOwningOptions() {
  ceres::Problem::Options options;
  options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.disable_all_safety_checks = true;
  return options;
}

SolverSummary RunCeres(const SolverOptions& options, const Ordering& ordering,
                       ceres::Problem& problem) {
  ceres::Solver::Options ceres_options;
  ceres_options.linear_solver_type = ceres::DENSE_SCHUR;
  ceres_options.max_num_iterations = options.iterations;
  ceres_options.function_tolerance = options.function_tolerance;
  ceres_options.num_threads = 1;
  ceres_options.logging_type = ceres::SILENT;
  ceres_options.linear_solver_ordering = ordering;
  ceres::Solver::Summary summary;
  ceres::Solve(ceres_options, &problem, &summary);
  const SolverEnding ending =
      summary.termination_type == ceres::CONVERGENCE
          ? SolverEnding::kConverged
          : (summary.termination_type == ceres::NO_CONVERGENCE ? SolverEnding::kIterationLimit
                                                               : SolverEnding::kNoUsableStep);
  return {ending, static_cast<int>(summary.iterations.size()) - 1, summary.initial_cost,
          summary.final_cost};
}

void AddPrior(WindowProblem& problem, PriorCost& cost, ceres::Problem& ceres_problem) {
  std::vector<double*> blocks;
  for (const FrameId id : problem.prior.frames) {
    blocks.push_back(problem.world_from_camera[FrameIndex(problem, id)].data());
  }
  blocks.push_back(problem.camera.right_field_px.data());
  ceres_problem.AddResidualBlock(&cost, nullptr, blocks);
}

// Within a group, Ceres orders blocks by their addresses, which differ from run to run. Each kind
// of variable, stored contiguously, therefore has a group of its own. Points are eliminated first.
enum OrderingGroup { kPoints, kPoses, kVelocities, kField };

Ordering OrderingOf(WindowProblem& problem) {
  auto ordering = std::make_shared<ceres::ParameterBlockOrdering>();
  for (Eigen::Vector3d& point : problem.points) ordering->AddElementToGroup(point.data(), kPoints);
  for (RigidTransform& pose : problem.world_from_camera) {
    ordering->AddElementToGroup(pose.data(), kPoses);
  }
  ordering->AddElementToGroup(problem.camera.right_field_px.data(), kField);
  return ordering;
}

// A cluster's problem in Ceres; owns the cost functions that the Ceres problem points to.
class CeresCluster {
 public:
  CeresCluster(const NoiseOptions& noise, const MotionPriorSteps& steps, ClusterProblem& problem)
      : problem_(problem), loss_(noise.huber), ceres_problem_(NonOwningOptions()) {
    AddPosesAndPoints();
    for (const ReprojectionFactor& factor : problem.factors) AddReprojection(factor);
    for (std::size_t i = 0; i < steps.power_densities.size(); ++i) {
      AddStep(steps.power_densities[i], i);
    }
    for (std::size_t i = 0; i < steps.turn_densities.size(); ++i) {
      AddTurn(steps.turn_densities[i], i);
    }
    if (steps.power_densities.empty()) return;
    for (Eigen::Vector3d& v : problem.velocity_m_s)
      ordering_->AddElementToGroup(v.data(), kVelocities);
  }

  SolverSummary Minimize(const SolverOptions& options) {
    return RunCeres(options, ordering_, ceres_problem_);
  }

 private:
  void AddPosesAndPoints() {
    for (RigidTransform& pose : problem_.world_from_object) {
      ceres_problem_.AddParameterBlock(pose.data(), 7, &manifold_);
      ordering_->AddElementToGroup(pose.data(), kPoses);
    }
    ceres_problem_.SetParameterBlockConstant(problem_.world_from_object[0].data());
    for (std::size_t i = 0; i < problem_.points.size(); ++i) {
      double* point = problem_.points[i].data();
      ceres_problem_.AddParameterBlock(point, 3);
      ordering_->AddElementToGroup(point, kPoints);
      if (problem_.point_priors[i].sqrt_information.isZero(0.0)) continue;
      points_.emplace_back(problem_.point_priors[i]);
      ceres_problem_.AddResidualBlock(&points_.back(), nullptr, point);
    }
  }

  void AddReprojection(const ReprojectionFactor& factor) {
    reprojections_.emplace_back(problem_.camera, problem_.world_from_camera[factor.pose],
                                factor.z_px, factor.sqrt_information);
    ceres_problem_.AddResidualBlock(&reprojections_.back(), &loss_,
                                    problem_.world_from_object[factor.pose].data(),
                                    problem_.points[factor.point].data());
  }

  double StepTime(std::size_t i) const { return problem_.time_s[i + 1] - problem_.time_s[i]; }

  void AddStep(double power_density, std::size_t i) {
    steps_.emplace_back(WhitenMotionPrior(power_density, StepTime(i)));
    ceres_problem_.AddResidualBlock(&steps_.back(), nullptr, problem_.world_from_object[i].data(),
                                    problem_.velocity_m_s[i].data(),
                                    problem_.world_from_object[i + 1].data(),
                                    problem_.velocity_m_s[i + 1].data());
  }

  void AddTurn(double power_density, std::size_t i) {
    turns_.emplace_back(power_density, std::array<double, 2>{StepTime(i), StepTime(i + 1)});
    ceres_problem_.AddResidualBlock(&turns_.back(), nullptr, problem_.world_from_object[i].data(),
                                    problem_.world_from_object[i + 1].data(),
                                    problem_.world_from_object[i + 2].data());
  }

  ClusterProblem& problem_;
  PoseManifold manifold_;
  ceres::HuberLoss loss_;
  std::deque<ObjectReprojectionCost> reprojections_;  // a deque never moves its elements
  std::deque<PointPriorCost> points_;
  std::deque<MotionPriorCost> steps_;
  std::deque<TurnPriorCost> turns_;
  Ordering ordering_ = std::make_shared<ceres::ParameterBlockOrdering>();
  ceres::Problem ceres_problem_;
};

}  // namespace

SolverSummary CeresSolver::Solve(const NoiseOptions& noise, const SolverOptions& options,
                                 WindowProblem& problem) {
  PoseManifold manifold;
  ceres::HuberLoss loss(noise.huber);
  std::deque<ReprojectionCost> costs;
  PriorCost prior_cost(problem.prior);
  ceres::Problem ceres_problem(NonOwningOptions());
  for (std::size_t i = 0; i < problem.frames.size(); ++i) {
    double* block = problem.world_from_camera[i].data();
    ceres_problem.AddParameterBlock(block, 7, &manifold);
    if (problem.is_fixed[i]) ceres_problem.SetParameterBlockConstant(block);
  }
  double* right_field = problem.camera.right_field_px.data();
  ceres_problem.AddParameterBlock(right_field, 6);
  if (problem.is_right_field_fixed) ceres_problem.SetParameterBlockConstant(right_field);
  for (Eigen::Vector3d& point : problem.points) ceres_problem.AddParameterBlock(point.data(), 3);
  for (const ReprojectionFactor& factor : problem.factors) {
    costs.emplace_back(problem.camera, factor.z_px, factor.sqrt_information);
    ceres_problem.AddResidualBlock(&costs.back(), &loss,
                                   problem.world_from_camera[factor.pose].data(),
                                   problem.points[factor.point].data(), right_field);
  }
  AddPrior(problem, prior_cost, ceres_problem);
  return RunCeres(options, OrderingOf(problem), ceres_problem);
}

SolverSummary CeresSolver::Solve(const NoiseOptions& noise, const SolverOptions& options,
                                 const MotionPriorSteps& steps, ClusterProblem& problem) {
  const SolverSummary summary = CeresCluster(noise, steps, problem).Minimize(options);
  if (steps.power_densities.empty()) DifferentiatePositions(problem);
  return summary;
}

}  // namespace cvo
