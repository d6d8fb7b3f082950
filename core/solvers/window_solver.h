// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/ids.h"
#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"
#include "core/solvers/reprojection_cost.h"

namespace cvo {

// Prior knowledge of the window, apart from its observations: what marginalised variables said of
// the frames they were connected to, and how far the calibration is trusted. Its energy is
// 1/2 ||r0 + J0 dx||^2, where dx stacks world_from_camera [-] linearization_point of all frames,
// then right_field_px - right_field_point_px (the last term of Eq. 10 of the paper, as one joint
// term: METHOD.md 7.3).
struct WindowPrior {
  std::vector<FrameId> frames;  // ascending
  std::vector<RigidTransform> linearization_point;
  Vector6d right_field_point_px = Vector6d::Zero();
  Eigen::MatrixXd J0;  // rows x (6 frames + 6)
  Eigen::VectorXd r0;
};

// Makes a prior on the calibration alone:
// right_field_px ~ N(camera.right_field_px, diag(deviation_px)^2).
WindowPrior CalibrationPrior(const StereoCamera& camera, const Vector6d& deviation_px);

// Observation of point `point` from pose `pose` of a problem.
struct ReprojectionFactor {
  int pose = 0;
  int point = 0;
  Eigen::Vector3d z_px = Eigen::Vector3d::Zero();
  Eigen::Matrix3d sqrt_information = Eigen::Matrix3d::Identity();
};

// The static energy (Eq. 10 of the paper) over the frames and points of the window, as plain
// arrays. `frames` must contain all frames of the prior.
struct WindowProblem {
  StereoCamera camera;  // its right_field_px is a variable
  bool is_right_field_fixed = false;
  std::vector<FrameId> frames;  // ascending
  std::vector<RigidTransform> world_from_camera;
  std::vector<char> is_fixed;               // per frame: pose held constant
  std::vector<Eigen::Vector3d> points;      // p_in_world
  std::vector<ReprojectionFactor> factors;  // sorted by point, then by pose
  WindowPrior prior;
};

struct SolverOptions {
  int iterations = 4;
  double function_tolerance = 1e-2;
  // Most landmarks that are optimised with the window. KITTI fills 2700 to 3500; fewer favour
  // distant landmarks, which biases the scale: 600 double the one-frame error on odometry 06.
  static constexpr int kMaxPoints = 4000;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("iterations", self.iterations,
                {"1", 1, 100, "Levenberg-Marquardt steps per frame", "METHOD.md 7.5"});
    visit.Field("function_tolerance", self.function_tolerance,
                {"1", 0, 1, "stop when a step lowers the energy by less than this fraction",
                 "measured: KITTI accuracy as at 1e-4 with 0.8 of the time, one step per frame"});
  }
};

// How a minimisation ended.
enum class SolverEnding {
  kConverged,       // gradient, step or change of the energy below its tolerance
  kIterationLimit,  // no iterations left, but the energy was still decreasing
  kNoUsableStep,    // no step lowered the energy
};

// Number of minimisations per ending.
struct SolverEndings {
  int converged = 0;
  int iteration_limit = 0;
  int no_usable_step = 0;

  void Count(SolverEnding ending);
  SolverEndings& operator+=(const SolverEndings& other);
};

struct SolverSummary {
  SolverEnding ending = SolverEnding::kNoUsableStep;
  int iterations = 0;
  double initial_cost = 0.0;
  double final_cost = 0.0;
  // Information of the variables shared by the points, with all others marginalised out. Zero if
  // there are none, or if the solver does not compute it (Ceres).
  Matrix6d shared_information = Matrix6d::Zero();
};

// Returns the index of a frame; throws Error if the problem does not contain it.
int FrameIndex(const WindowProblem& problem, FrameId frame);

// Minimises the energy in place: Levenberg-Marquardt with the points eliminated, on one thread.
// Throws Error if the factors are not sorted or refer to a point or pose that does not exist.
SolverSummary SolveWindow(const NoiseOptions& noise, const SolverOptions& options,
                          WindowProblem& problem);

}  // namespace cvo
