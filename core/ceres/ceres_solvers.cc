// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/ceres/ceres_solvers.h"

#include <ceres/cost_function.h>
#include <ceres/loss_function.h>
#include <ceres/manifold.h>
#include <ceres/ordered_groups.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <algorithm>
#include <array>
#include <deque>
#include <functional>
#include <memory>
#include <utility>

#include "core/solvers/motion_prior.h"
#include "core/solvers/reprojection_cost.h"

namespace cvo {

namespace {

using Blocks = double const* const*;

RigidTransform PoseOf(const double* block) {  // [qx qy qz qw tx ty tz]
  return {Eigen::Quaterniond(Eigen::Map<const Eigen::Quaterniond>(block)),
          Eigen::Vector3d(Eigen::Map<const Eigen::Vector3d>(block + 4))};
}

Eigen::Map<const Eigen::Vector3d> PointOf(const double* block) {
  return Eigen::Map<const Eigen::Vector3d>(block);
}

// RigidTransform::Plus and Minus as a Ceres manifold. The costs write their Jacobians with respect
// to the tangent into the first six of a pose's seven columns, so PlusJacobian is [I6; 0]
// (METHOD.md 7.5).
class PoseManifold final : public ceres::Manifold {
 public:
  int AmbientSize() const override { return 7; }
  int TangentSize() const override { return 6; }
  bool Plus(const double* x, const double* delta, double* x_plus_delta) const override {
    const RigidTransform moved = PoseOf(x).Plus(Eigen::Map<const Vector6d>(delta));
    std::copy_n(moved.data(), 7, x_plus_delta);
    return true;
  }
  bool PlusJacobian(const double*, double* jacobian) const override {
    Eigen::Map<Eigen::Matrix<double, 7, 6, Eigen::RowMajor>>(jacobian).setIdentity();
    return true;
  }
  bool Minus(const double* y, const double* x, double* y_minus_x) const override {
    Eigen::Map<Vector6d>(y_minus_x, 6) = PoseOf(y).Minus(PoseOf(x));
    return true;
  }
  bool MinusJacobian(const double*, double* jacobian) const override {
    Eigen::Map<Eigen::Matrix<double, 6, 7, Eigen::RowMajor>>(jacobian).setIdentity();
    return true;
  }
};

// A residual, and its Jacobians with respect to each block: of a pose, with respect to its tangent.
// Products are formed in the layout of Ceres, which decides Eigen's order of summation.
struct Linearized {
  Eigen::VectorXd r;
  std::vector<Eigen::MatrixXd> J;
};

class Cost final : public ceres::CostFunction {
 public:
  using Function = std::function<Linearized(Blocks)>;

  Cost(int residuals, std::vector<int> sizes, Function function) : function_(std::move(function)) {
    set_num_residuals(residuals);
    *mutable_parameter_block_sizes() = std::move(sizes);
  }

  bool Evaluate(Blocks blocks, double* residuals, double** jacobians) const override {
    const Linearized value = function_(blocks);
    std::copy_n(value.r.data(), num_residuals(), residuals);
    for (std::size_t i = 0; jacobians != nullptr && i < value.J.size(); ++i) {
      if (jacobians[i] == nullptr) continue;
      using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
      Eigen::Map<RowMajor> J(jacobians[i], num_residuals(), parameter_block_sizes()[i]);
      J.setZero();
      J.leftCols(value.J[i].cols()) = value.J[i];
    }
    return true;
  }

 private:
  Function function_;
};

// Within a group, Ceres orders blocks by their addresses, which differ from run to run. Each kind
// of variable, stored contiguously, therefore has a group of its own. Points are eliminated first.
enum Group { kPoints, kPoses, kVelocities, kField };

// A problem in Ceres; owns what it points to, except for the variables.
class CeresProblem {
 public:
  explicit CeresProblem(double huber) : loss_(huber), problem_(NonOwning()) {}

  void AddPose(RigidTransform& pose, bool is_fixed) {
    problem_.AddParameterBlock(pose.data(), 7, &manifold_);
    if (is_fixed) problem_.SetParameterBlockConstant(pose.data());
    SetGroup(pose.data(), kPoses);
  }
  void AddPoint(Eigen::Vector3d& point) {
    problem_.AddParameterBlock(point.data(), 3);
    SetGroup(point.data(), kPoints);
  }
  void AddField(Vector6d& field, bool is_fixed) {
    problem_.AddParameterBlock(field.data(), 6);
    if (is_fixed) problem_.SetParameterBlockConstant(field.data());
    SetGroup(field.data(), kField);
  }
  void SetGroup(double* block, Group group) { ordering_->AddElementToGroup(block, group); }

  void Add(int residuals, std::vector<int> sizes, const std::vector<double*>& blocks,
           Cost::Function function, bool is_robust = false) {
    costs_.emplace_back(residuals, std::move(sizes), std::move(function));
    problem_.AddResidualBlock(&costs_.back(), is_robust ? &loss_ : nullptr, blocks);
  }

  SolverSummary Minimize(const SolverOptions& options) {
    ceres::Solver::Options ceres_options;
    ceres_options.linear_solver_type = ceres::DENSE_SCHUR;
    ceres_options.max_num_iterations = options.iterations;
    ceres_options.function_tolerance = options.function_tolerance;
    ceres_options.num_threads = 1;
    ceres_options.logging_type = ceres::SILENT;
    ceres_options.linear_solver_ordering = ordering_;
    ceres::Solver::Summary summary;
    ceres::Solve(ceres_options, &problem_, &summary);
    SolverEnding ending = SolverEnding::kNoUsableStep;
    if (summary.termination_type == ceres::CONVERGENCE) ending = SolverEnding::kConverged;
    if (summary.termination_type == ceres::NO_CONVERGENCE) ending = SolverEnding::kIterationLimit;
    return {ending, static_cast<int>(summary.iterations.size()) - 1, summary.initial_cost,
            summary.final_cost};
  }

 private:
  static ceres::Problem::Options NonOwning() {
    ceres::Problem::Options options;
    options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    options.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    options.disable_all_safety_checks = true;
    return options;
  }

  PoseManifold manifold_;
  ceres::HuberLoss loss_;
  std::deque<Cost> costs_;  // a deque never moves its elements
  std::shared_ptr<ceres::ParameterBlockOrdering> ordering_ =
      std::make_shared<ceres::ParameterBlockOrdering>();
  ceres::Problem problem_;
};

// A WindowPrior over its frames, then right_field_px. The rotational part of the tangent is
// differentiated exactly (inverse right Jacobian).
Linearized LinearizePrior(const WindowPrior& prior, Blocks blocks) {
  const int frames = static_cast<int>(prior.frames.size());
  Linearized value;
  Eigen::VectorXd dx(6 * frames + 6);
  for (int i = 0; i < frames; ++i) {
    dx.segment<6>(6 * i) = PoseOf(blocks[i]).Minus(prior.linearization_point[i]);
    value.J.emplace_back(prior.J0.middleCols<6>(6 * i));
    const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> by_rotation =
        prior.J0.middleCols<3>(6 * i) * InverseRightJacobianSo3(dx.segment<3>(6 * i));
    value.J[i].leftCols<3>() = by_rotation;
  }
  dx.tail<6>() = Eigen::Map<const Vector6d>(blocks[frames]) - prior.right_field_point_px;
  value.J.emplace_back(prior.J0.rightCols<6>());
  value.r = prior.r0 + prior.J0 * dx;
  return value;
}

// W (pi(camera_from_world world_from_object p_in_object) - z) with the camera held fixed, over
// world_from_object and p_in_object: the reprojection term of the paper's energy of a cluster,
// corrected (METHOD.md 9).
Linearized LinearizeObjectReprojection(const ClusterProblem& problem,
                                       const ReprojectionFactor& factor, Blocks blocks) {
  const RigidTransform& world_from_camera = problem.world_from_camera[factor.pose];
  const RigidTransform world_from_object = PoseOf(blocks[0]);
  const Eigen::Vector3d p_in_object = PointOf(blocks[1]);
  const Eigen::Matrix3d R = world_from_camera.RotationMatrix().transpose();
  const Eigen::Matrix3d R_object = world_from_object.RotationMatrix();
  const Eigen::Vector3d c = R * (R_object * p_in_object + (world_from_object.translation() -
                                                           world_from_camera.translation()));
  const ProjectionResidual projection =
      EvaluateProjection(problem.camera, factor.z_px, factor.sqrt_information, c);
  Eigen::Matrix<double, 3, 6> J_pose;
  J_pose.rightCols<3>() = projection.J * R;
  const Eigen::Matrix3d J_point = J_pose.rightCols<3>() * R_object;
  J_pose.leftCols<3>() = -J_point * Skew(p_in_object);
  return {projection.r, {J_pose, J_point}};
}

// A step of the motion prior (Eq. 12), over pose and velocity of a state, then of the next one.
Linearized LinearizeStep(const MotionPriorFactors& factors, Blocks blocks) {
  const Eigen::Matrix<double, 2, 4> J = MotionPriorAxisJacobian(factors);
  Linearized value;
  value.r = EvaluateMotionPrior(factors, PointOf(blocks[0] + 4), PointOf(blocks[1]),
                                PointOf(blocks[2] + 4), PointOf(blocks[3]));
  for (int i = 0; i < 4; ++i) {
    Eigen::MatrixXd by_block = Eigen::MatrixXd::Zero(6, i % 2 == 0 ? 6 : 3);
    by_block.block<3, 3>(0, by_block.cols() - 3).diagonal().setConstant(J(0, i));
    by_block.block<3, 3>(3, by_block.cols() - 3).diagonal().setConstant(J(1, i));
    value.J.push_back(by_block);
  }
  return value;
}

Linearized LinearizeTurn(double power_density, const std::array<double, 2>& dt_s, Blocks blocks) {
  std::array<Eigen::Quaterniond, 3> world_from_object;
  for (int i = 0; i < 3; ++i) {
    world_from_object[i] = Eigen::Map<const Eigen::Quaterniond>(blocks[i]);
  }
  const TurnPrior turn = EvaluateTurnPrior(power_density, dt_s, world_from_object);
  Linearized value{turn.r, {}};
  for (int i = 0; i < 3; ++i) {
    // turn.J is with respect to rotations about world axes, the manifold's tangent about body axes.
    std::array<double, 21> about_body;
    Eigen::Map<Eigen::Matrix<double, 3, 7, Eigen::RowMajor>> J(about_body.data());
    J.leftCols<3>() = turn.J[i] * world_from_object[i].toRotationMatrix();
    value.J.emplace_back(J.leftCols<3>());
  }
  return value;
}

}  // namespace

SolverSummary CeresSolver::Solve(const NoiseOptions& noise, const SolverOptions& options,
                                 WindowProblem& problem) {
  CeresProblem ceres_problem(noise.huber);
  for (std::size_t i = 0; i < problem.frames.size(); ++i) {
    ceres_problem.AddPose(problem.world_from_camera[i], problem.is_fixed[i] != 0);
  }
  double* field = problem.camera.right_field_px.data();
  ceres_problem.AddField(problem.camera.right_field_px, problem.is_right_field_fixed);
  for (Eigen::Vector3d& point : problem.points) ceres_problem.AddPoint(point);
  for (const ReprojectionFactor& factor : problem.factors) {
    ceres_problem.Add(
        3, {7, 3, 6},
        {problem.world_from_camera[factor.pose].data(), problem.points[factor.point].data(), field},
        [&](Blocks blocks) -> Linearized {
          StereoCamera camera = problem.camera;
          camera.right_field_px = Eigen::Map<const Vector6d>(blocks[2]);
          const ReprojectionResidual value = EvaluateReprojection(
              camera, factor.z_px, factor.sqrt_information, PoseOf(blocks[0]), PointOf(blocks[1]));
          return {value.r, {value.J_pose, value.J_point, value.J_field}};
        },
        true);
  }
  std::vector<int> sizes(problem.prior.frames.size(), 7);
  std::vector<double*> blocks;
  for (const FrameId id : problem.prior.frames) {
    blocks.push_back(problem.world_from_camera[FrameIndex(problem, id)].data());
  }
  sizes.push_back(6);
  blocks.push_back(field);
  ceres_problem.Add(static_cast<int>(problem.prior.r0.size()), sizes, blocks,
                    [&](Blocks values) { return LinearizePrior(problem.prior, values); });
  return ceres_problem.Minimize(options);
}

SolverSummary CeresSolver::Solve(const NoiseOptions& noise, const SolverOptions& options,
                                 const MotionPriorSteps& steps, ClusterProblem& problem) {
  CeresProblem ceres_problem(noise.huber);
  std::vector<RigidTransform>& poses = problem.world_from_object;
  for (RigidTransform& pose : poses) ceres_problem.AddPose(pose, &pose == &poses.front());
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    ceres_problem.AddPoint(problem.points[i]);
    const PointPrior& prior = problem.point_priors[i];
    if (prior.sqrt_information.isZero(0.0)) continue;
    ceres_problem.Add(3, {3}, {problem.points[i].data()}, [&](Blocks blocks) -> Linearized {
      std::array<double, 3> data;
      Eigen::Map<Eigen::Vector3d> r(data.data());
      r = prior.sqrt_information * (PointOf(blocks[0]) - prior.mean_in_object);
      return {r, {prior.sqrt_information}};
    });
  }
  for (const ReprojectionFactor& factor : problem.factors) {
    ceres_problem.Add(
        3, {7, 3}, {poses[factor.pose].data(), problem.points[factor.point].data()},
        [&](Blocks blocks) { return LinearizeObjectReprojection(problem, factor, blocks); }, true);
  }
  const auto dt_s = [&](std::size_t i) { return problem.time_s[i + 1] - problem.time_s[i]; };
  for (std::size_t i = 0; i < steps.power_densities.size(); ++i) {
    const MotionPriorFactors factors = WhitenMotionPrior(steps.power_densities[i], dt_s(i));
    ceres_problem.Add(6, {7, 3, 7, 3},
                      {poses[i].data(), problem.velocity_m_s[i].data(), poses[i + 1].data(),
                       problem.velocity_m_s[i + 1].data()},
                      [factors](Blocks blocks) { return LinearizeStep(factors, blocks); });
  }
  for (std::size_t i = 0; i < steps.turn_densities.size(); ++i) {
    ceres_problem.Add(3, {7, 7, 7}, {poses[i].data(), poses[i + 1].data(), poses[i + 2].data()},
                      [q = steps.turn_densities[i], dt = std::array{dt_s(i), dt_s(i + 1)}](
                          Blocks blocks) { return LinearizeTurn(q, dt, blocks); });
  }
  if (!steps.power_densities.empty()) {
    for (Eigen::Vector3d& v : problem.velocity_m_s) ceres_problem.SetGroup(v.data(), kVelocities);
  }
  const SolverSummary summary = ceres_problem.Minimize(options);
  if (steps.power_densities.empty()) DifferentiatePositions(problem);
  return summary;
}

}  // namespace cvo
