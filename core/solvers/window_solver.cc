// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/solvers/window_solver.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/solvers/schur_solver.h"

namespace cvo {

WindowPrior CalibrationPrior(const StereoCamera& camera, const Vector6d& deviation_px) {
  WindowPrior prior;
  prior.right_field_point_px = camera.right_field_px;
  prior.J0 = deviation_px.cwiseInverse().asDiagonal();
  prior.r0 = Eigen::VectorXd::Zero(deviation_px.size());
  return prior;
}

namespace {

// Jacobian of the prior's tangent of a frame with respect to that of the equations (rotation about
// world axes).
Matrix6d TangentJacobian(const Vector6d& difference, const RigidTransform& world_from_camera) {
  Matrix6d D = Matrix6d::Identity();
  D.topLeftCorner<3, 3>() = InverseRightJacobianSo3(difference.head<3>()) *
                            world_from_camera.RotationMatrix().transpose();
  return D;
}

// Adds the energy 1/2 ||r0 + J0 dx||^2 of a WindowPrior (Eq. 10 and 11) to SchurEquations whose
// first six other variables are right_field_px. `prior` must outlive this object. `frame_index`
// holds the window index of each frame of the prior.
class SchurPrior {
 public:
  SchurPrior(const WindowPrior& prior, std::vector<int> frame_index)
      : prior_(&prior), frame_index_(std::move(frame_index)) {
    H0_.setZero(prior.J0.cols(), prior.J0.cols());
    H0_.selfadjointView<Eigen::Lower>().rankUpdate(prior.J0.transpose());
  }

  double Energy(const std::vector<RigidTransform>& world_from_camera,
                const Vector6d& right_field_px) const {
    if (prior_->r0.size() == 0) return 0.0;
    const Eigen::VectorXd dx = Difference(world_from_camera, right_field_px);
    return 0.5 * (prior_->r0 + prior_->J0 * dx).squaredNorm();
  }

  // `pose_of_frame` holds, per frame of the window, the index of its pose in the equations; -1 if
  // the pose is held fixed.
  void AddTo(const std::vector<RigidTransform>& world_from_camera, const Vector6d& right_field_px,
             bool is_right_field_fixed, const std::vector<int>& pose_of_frame,
             SchurEquations& equations) const {
    if (prior_->r0.size() == 0) return;
    const Eigen::VectorXd dx = Difference(world_from_camera, right_field_px);
    const Eigen::VectorXd g = prior_->J0.transpose() * (prior_->r0 + prior_->J0 * dx);
    const int frames = static_cast<int>(frame_index_.size());
    std::vector<Matrix6d> D(frames);
    for (int i = 0; i < frames; ++i) {
      const int pose = pose_of_frame[frame_index_[i]];
      if (pose < 0) continue;
      D[i] = TangentJacobian(dx.segment<6>(6 * i), world_from_camera[frame_index_[i]]);
      equations.g.segment<6>(6 * pose).noalias() += D[i].transpose() * g.segment<6>(6 * i);
      for (int k = 0; k <= i; ++k) {
        const int other = pose_of_frame[frame_index_[k]];
        if (other < 0) continue;
        Matrix6d H0 = H0_.block<6, 6>(6 * i, 6 * k);
        if (i == k) H0 = H0.selfadjointView<Eigen::Lower>();
        equations.H.block<6, 6>(6 * pose, 6 * other) += D[i].transpose() * H0 * D[k];
      }
    }
    if (is_right_field_fixed) return;
    const int field = equations.others_begin();
    equations.g.segment<6>(field) += g.tail<6>();
    equations.H.block<6, 6>(field, field) += H0_.block<6, 6>(6 * frames, 6 * frames);
    for (int i = 0; i < frames; ++i) {
      const int pose = pose_of_frame[frame_index_[i]];
      if (pose < 0) continue;
      equations.H.block<6, 6>(field, 6 * pose) += H0_.block<6, 6>(6 * frames, 6 * i) * D[i];
    }
  }

 private:
  Eigen::VectorXd Difference(const std::vector<RigidTransform>& world_from_camera,
                             const Vector6d& right_field_px) const {
    const int frames = static_cast<int>(frame_index_.size());
    Eigen::VectorXd dx(6 * frames + 6);
    for (int i = 0; i < frames; ++i) {
      dx.segment<6>(6 * i) =
          world_from_camera[frame_index_[i]].Minus(prior_->linearization_point[i]);
    }
    dx.tail<6>() = right_field_px - prior_->right_field_point_px;
    return dx;
  }

  const WindowPrior* prior_;
  std::vector<int> frame_index_;
  Eigen::MatrixXd H0_;  // J0^T J0
};

struct WindowVariables {
  std::vector<RigidTransform> world_from_camera;
  std::vector<Eigen::Vector3d> points;
  Vector6d right_field_px = Vector6d::Zero();
};

std::vector<int> PriorFrames(const WindowProblem& problem) {
  std::vector<int> indices;
  for (const FrameId id : problem.prior.frames) indices.push_back(FrameIndex(problem, id));
  return indices;
}

// Indices of the free poses in the equations, in the order of the frames; -1 for fixed ones.
std::vector<int> PoseColumns(const std::vector<char>& is_fixed) {
  std::vector<int> columns;
  int next = 0;
  for (const char fixed : is_fixed) columns.push_back(fixed ? -1 : next++);
  return columns;
}

// The static energy as a model for MinimizeEnergy.
class WindowModel {
 public:
  WindowModel(const NoiseOptions& noise, const WindowProblem& problem)
      : problem_(&problem),
        huber_(noise.huber),
        pose_of_frame_(PoseColumns(problem.is_fixed)),
        prior_(problem.prior, PriorFrames(problem)),
        state_{problem.world_from_camera, problem.points, problem.camera.right_field_px},
        tried_(state_) {}

  const std::vector<int>& pose_of_frame() const { return pose_of_frame_; }
  const WindowVariables& state() const { return state_; }

  double Linearize(SchurEquations& equations) const {
    equations.SetZero();
    prior_.AddTo(state_.world_from_camera, state_.right_field_px, problem_->is_right_field_fixed,
                 pose_of_frame_, equations);
    return prior_.Energy(state_.world_from_camera, state_.right_field_px) +
           LinearizeReprojections(Camera(state_), Views(state_), state_.points, problem_->factors,
                                  huber_, equations);
  }

  double TryStep(const SchurStep& step) {
    for (std::size_t i = 0; i < pose_of_frame_.size(); ++i) {
      if (pose_of_frame_[i] < 0) continue;
      tried_.world_from_camera[i] =
          MovePose(state_.world_from_camera[i], step.reduced.segment<6>(6 * pose_of_frame_[i]));
    }
    for (std::size_t p = 0; p < state_.points.size(); ++p) {
      tried_.points[p] = state_.points[p] + step.points[p];
    }
    if (!problem_->is_right_field_fixed) {
      tried_.right_field_px = state_.right_field_px + step.reduced.tail<6>();
    }
    return prior_.Energy(tried_.world_from_camera, tried_.right_field_px) +
           ReprojectionEnergy(Camera(tried_), Views(tried_), tried_.points, problem_->factors,
                              huber_);
  }

  void AcceptStep() { std::swap(state_, tried_); }

  double Norm() const {
    return std::sqrt(SquaredNorm(state_.world_from_camera) + SquaredNorm(state_.points) +
                     state_.right_field_px.squaredNorm());
  }

 private:
  StereoCamera Camera(const WindowVariables& state) const {
    StereoCamera camera = problem_->camera;
    camera.right_field_px = state.right_field_px;
    return camera;
  }

  std::vector<CameraView> Views(const WindowVariables& state) const {
    std::vector<CameraView> views;
    for (std::size_t i = 0; i < pose_of_frame_.size(); ++i) {
      views.emplace_back(pose_of_frame_[i], state.world_from_camera[i]);
    }
    return views;
  }

  const WindowProblem* problem_;
  double huber_;
  std::vector<int> pose_of_frame_;
  SchurPrior prior_;
  WindowVariables state_;
  WindowVariables tried_;
};

}  // namespace

int FrameIndex(const WindowProblem& problem, FrameId frame) {
  const auto it = std::lower_bound(problem.frames.begin(), problem.frames.end(), frame);
  Require(it != problem.frames.end() && *it == frame, "WindowProblem: no such frame");
  return static_cast<int>(it - problem.frames.begin());
}

void SolverEndings::Count(SolverEnding ending) {
  converged += ending == SolverEnding::kConverged;
  iteration_limit += ending == SolverEnding::kIterationLimit;
  no_usable_step += ending == SolverEnding::kNoUsableStep;
}

SolverEndings& SolverEndings::operator+=(const SolverEndings& other) {
  converged += other.converged;
  iteration_limit += other.iteration_limit;
  no_usable_step += other.no_usable_step;
  return *this;
}

SolverSummary SolveWindow(const NoiseOptions& noise, const SolverOptions& options,
                          WindowProblem& problem) {
  WindowModel model(noise, problem);
  SchurEquations equations(model.pose_of_frame(), problem.is_right_field_fixed ? 0 : 6,
                           problem.points.size(), problem.factors);
  equations.points_see_shared = !problem.is_right_field_fixed;
  const SolverSummary summary = MinimizeEnergy(options, equations, model);
  problem.world_from_camera = model.state().world_from_camera;
  problem.points = model.state().points;
  problem.camera.right_field_px = model.state().right_field_px;
  return summary;
}

}  // namespace cvo
