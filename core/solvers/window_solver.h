// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/geometry/stereo_camera.h"
#include "core/solvers/measurement_noise.h"
#include "core/solvers/window_prior.h"

namespace cvo {

// One observation: point `point` seen in pose `pose` of a problem.
struct ReprojectionFactor {
  int pose = 0;
  int point = 0;
  Eigen::Vector3d z_px = Eigen::Vector3d::Zero();
  Eigen::Matrix3d sqrt_information = Eigen::Matrix3d::Identity();
};

// The static energy of the paper's section 3.3 over the frames and points of the window, as plain
// arrays. The prior's frames are all among `frames`.
struct WindowProblem {
  StereoCamera camera;  // its right_field_px is a variable
  bool is_right_field_fixed = false;
  std::vector<FrameId> frames;  // ascending
  std::vector<RigidTransform> world_from_camera;
  std::vector<char> is_fixed;               // by frame: held constant
  std::vector<Eigen::Vector3d> points;      // p_in_world
  std::vector<ReprojectionFactor> factors;  // by point, then by pose
  WindowPrior prior;
};

struct SolverOptions {
  int iterations = 4;
  int cluster_rounds = 3;
  double function_tolerance = 1e-2;
  int max_points = 4000;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("iterations", self.iterations,
                {"1", 1, 100, "Levenberg-Marquardt steps per frame", "METHOD.md 7.5"});
    visit.Field("cluster_rounds", self.cluster_rounds,
                {"1", 1, 100,
                 "maximum solves of a cluster per frame; outliers are removed after each, and it "
                 "is solved again while new ones are found",
                 "matches of a body that leaves the image are worst in its last frame"});
    visit.Field("function_tolerance", self.function_tolerance,
                {"1", 0, 1, "stop when a step lowers the energy by less than this fraction",
                 "measured: KITTI accuracy as at 1e-4 with 0.8 of the time, one step per frame"});
    visit.Field("max_points", self.max_points,
                {"1", 10, 100000,
                 "maximum landmarks optimised with the window, longest observed first; fewer take "
                 "less time but favour distant landmarks, which biases the scale",
                 "measured: KITTI fills 2700-3500; 600 double the one-frame error on odometry 06"});
  }
};

// How a minimisation ended.
enum class SolverEnding {
  kConverged,       // gradient, step or decrease of the energy below its tolerance
  kIterationLimit,  // iterations used up while the energy still fell
  kNoUsableStep,    // no step lowered the energy
};

// How many minimisations ended how.
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
  // Of the variables that the points share, all others summed out; zero where there are none, or
  // where the solver does not compute it (Ceres).
  Matrix6d shared_information = Matrix6d::Zero();
};

// Index of a frame of the problem; throws Error where it has no such frame.
int FrameIndex(const WindowProblem& problem, FrameId frame);

// Minimises the energy in place: Levenberg-Marquardt, points eliminated, one thread. Throws Error
// where factors are not in their order or name what is not there.
SolverSummary SolveWindow(const NoiseOptions& noise, const SolverOptions& options,
                          WindowProblem& problem);

}  // namespace cvo
