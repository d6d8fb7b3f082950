// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/solvers/cluster_solver.h"

#include <array>

#include "core/solvers/motion_prior.h"
#include "core/solvers/schur_solver.h"

namespace cvo {

namespace {

struct ClusterVariables {
  std::vector<RigidTransform> world_from_object;
  std::vector<Eigen::Vector3d> velocity_m_s;
  std::vector<Eigen::Vector3d> points;
};

// The energy of a cluster as a model for MinimizeEnergy. The poses of frames 1, 2, ... are poses
// 0, 1, ... of the equations. With a motion prior, the velocities of all frames are the other
// variables.
class ClusterModel {
 public:
  ClusterModel(const NoiseOptions& noise, const MotionPriorSteps& steps,
               const ClusterProblem& problem)
      : problem_(&problem),
        huber_(noise.huber),
        turn_densities_(steps.turn_densities),
        state_{problem.world_from_object, problem.velocity_m_s, problem.points},
        tried_(state_) {
    for (std::size_t i = 0; i < steps.power_densities.size(); ++i) {
      steps_.push_back(WhitenMotionPrior(steps.power_densities[i], StepTime(i)));
    }
    for (std::size_t i = 0; i < problem.time_s.size(); ++i) {
      pose_of_frame_.push_back(static_cast<int>(i) - 1);
    }
  }

  const std::vector<int>& pose_of_frame() const { return pose_of_frame_; }
  const ClusterVariables& state() const { return state_; }
  int others() const { return steps_.empty() ? 0 : 3 * static_cast<int>(pose_of_frame_.size()); }

  double Linearize(SchurEquations& equations) const {
    equations.SetZero();
    for (std::size_t i = 0; i < steps_.size(); ++i) AddStep(i, equations);
    for (std::size_t i = 0; i < turn_densities_.size(); ++i) AddTurn(i, equations);
    AddPointPriors(equations);
    return PriorEnergy(state_) + LinearizeReprojections(problem_->camera, Views(state_),
                                                        state_.points, problem_->factors, huber_,
                                                        equations);
  }

  double TryStep(const SchurStep& step) {
    for (std::size_t i = 1; i < pose_of_frame_.size(); ++i) {
      tried_.world_from_object[i] =
          MovePose(state_.world_from_object[i], step.reduced.segment<6>(6 * pose_of_frame_[i]));
    }
    if (!steps_.empty()) {
      for (std::size_t i = 0; i < pose_of_frame_.size(); ++i) {
        tried_.velocity_m_s[i] =
            state_.velocity_m_s[i] + step.reduced.segment<3>(VelocityColumn(i));
      }
    }
    for (std::size_t p = 0; p < state_.points.size(); ++p) {
      tried_.points[p] = state_.points[p] + step.points[p];
    }
    return PriorEnergy(tried_) + ReprojectionEnergy(problem_->camera, Views(tried_), tried_.points,
                                                    problem_->factors, huber_);
  }

  void AcceptStep() { std::swap(state_, tried_); }

  double Norm() const {
    return std::sqrt(SquaredNorm(state_.world_from_object) + SquaredNorm(state_.velocity_m_s) +
                     SquaredNorm(state_.points));
  }

 private:
  Eigen::Index VelocityColumn(std::size_t frame) const {
    return 6 * (static_cast<Eigen::Index>(pose_of_frame_.size()) - 1) +
           3 * static_cast<Eigen::Index>(frame);
  }

  std::vector<ObjectView> Views(const ClusterVariables& state) const {
    std::vector<ObjectView> views;
    for (std::size_t i = 0; i < pose_of_frame_.size(); ++i) {
      views.emplace_back(pose_of_frame_[i], problem_->world_from_camera[i],
                         state.world_from_object[i]);
    }
    return views;
  }

  Vector6d StepResidual(const ClusterVariables& state, std::size_t i) const {
    return EvaluateMotionPrior(steps_[i], state.world_from_object[i].translation(),
                               state.velocity_m_s[i], state.world_from_object[i + 1].translation(),
                               state.velocity_m_s[i + 1]);
  }

  double StepTime(std::size_t i) const { return problem_->time_s[i + 1] - problem_->time_s[i]; }

  TurnPrior Turn(const ClusterVariables& state, std::size_t i) const {
    return EvaluateTurnPrior(
        turn_densities_[i], {StepTime(i), StepTime(i + 1)},
        {state.world_from_object[i].rotation(), state.world_from_object[i + 1].rotation(),
         state.world_from_object[i + 2].rotation()});
  }

  void AddTurn(std::size_t i, SchurEquations& equations) const {
    const TurnPrior turn = Turn(state_, i);
    for (int a = 0; a < 3; ++a) {
      const int row = pose_of_frame_[i + a];
      if (row < 0) continue;
      equations.g.segment<3>(6 * row) += turn.J[a].transpose() * turn.r;
      for (int b = 0; b <= a; ++b) {
        const int column = pose_of_frame_[i + b];
        if (column < 0) continue;
        equations.H.block<3, 3>(6 * row, 6 * column) += turn.J[a].transpose() * turn.J[b];
      }
    }
  }

  // Adds the motion prior from frame i to the next. All three axes have the same 2x4 Jacobian.
  void AddStep(std::size_t i, SchurEquations& equations) const {
    const Vector6d r = StepResidual(state_, i);
    const Eigen::Matrix<double, 2, 4> J = MotionPriorAxisJacobian(steps_[i]);
    const Eigen::Matrix4d H = J.transpose() * J;
    const Eigen::Index position = 6 * static_cast<Eigen::Index>(i) - 3;  // < 0: frame 0 is held
    const std::array<Eigen::Index, 4> columns = {position, VelocityColumn(i), position + 6,
                                                 VelocityColumn(i + 1)};
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const Eigen::Vector4d g = J.transpose() * Eigen::Vector2d(r[axis], r[3 + axis]);
      for (int a = 0; a < 4; ++a) {
        if (columns[a] < 0) continue;
        equations.g[columns[a] + axis] += g[a];
        for (int b = 0; b < 4; ++b) {
          if (columns[b] < 0 || columns[b] > columns[a]) continue;
          equations.H(columns[a] + axis, columns[b] + axis) += H(a, b);
        }
      }
    }
  }

  void AddPointPriors(SchurEquations& equations) const {
    for (std::size_t p = 0; p < state_.points.size(); ++p) {
      const PointPrior& prior = problem_->point_priors[p];
      const Eigen::Matrix3d H = prior.sqrt_information.transpose() * prior.sqrt_information;
      equations.points[p].H += H;
      equations.points[p].g += H * (state_.points[p] - prior.mean_in_object);
    }
  }

  double PriorEnergy(const ClusterVariables& state) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < steps_.size(); ++i) sum += StepResidual(state, i).squaredNorm();
    for (std::size_t i = 0; i < turn_densities_.size(); ++i) sum += Turn(state, i).r.squaredNorm();
    for (std::size_t p = 0; p < state.points.size(); ++p) {
      const PointPrior& prior = problem_->point_priors[p];
      sum += (prior.sqrt_information * (state.points[p] - prior.mean_in_object)).squaredNorm();
    }
    return 0.5 * sum;
  }

  const ClusterProblem* problem_;
  double huber_;
  std::vector<double> turn_densities_;
  std::vector<MotionPriorFactors> steps_;
  std::vector<int> pose_of_frame_;
  ClusterVariables state_;
  ClusterVariables tried_;
};

}  // namespace

void DifferentiatePositions(ClusterProblem& problem) {
  const std::size_t n = problem.time_s.size();
  for (std::size_t i = 1; i < n; ++i) {
    const double dt = problem.time_s[i] - problem.time_s[i - 1];
    problem.velocity_m_s[i] = (problem.world_from_object[i].translation() -
                               problem.world_from_object[i - 1].translation()) /
                              dt;
  }
  if (n > 1) problem.velocity_m_s[0] = problem.velocity_m_s[1];
}

SolverSummary SolveClusterSteps(const NoiseOptions& noise, const SolverOptions& options,
                                const MotionPriorSteps& steps, ClusterProblem& problem) {
  ClusterModel model(noise, steps, problem);
  SchurEquations equations(model.pose_of_frame(), model.others(), problem.points.size(),
                           problem.factors);
  const SolverSummary summary = MinimizeEnergy(options, equations, model);
  problem.world_from_object = model.state().world_from_object;
  problem.velocity_m_s = model.state().velocity_m_s;
  problem.points = model.state().points;
  if (steps.power_densities.empty()) DifferentiatePositions(problem);
  return summary;
}

}  // namespace cvo
