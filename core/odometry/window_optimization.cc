// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/odometry/window_optimization.h"

#include <algorithm>
#include <cmath>

#include "core/estimation/camera_solver.h"

namespace cvo {
namespace {

void CopyFrames(const WindowProblem& problem, Window& window) {
  std::size_t i = 0;
  for (std::vector<WindowFrame>* track : {&window.spatial, &window.temporal}) {
    for (WindowFrame& frame : *track) frame.world_from_camera = problem.world_from_camera[i++];
  }
}

}  // namespace

double ApplySolution(double gate, const WindowProblem& problem, const std::vector<int>& landmarks,
                     Window& window) {
  window.camera = problem.camera;
  CopyFrames(problem, window);
  std::vector<RigidTransform> camera_from_world;
  for (const RigidTransform& pose : problem.world_from_camera) {
    camera_from_world.push_back(pose.Inverse());
  }
  double sum = 0.0;
  int count = 0;
  std::size_t next = 0;  // factors are in the order of the landmarks and their observations
  for (std::size_t k = 0; k < landmarks.size(); ++k) {
    Landmark& landmark = window.landmarks[landmarks[k]];
    landmark.p_in_object = problem.points[k];
    std::vector<Observation> kept;
    for (const Observation& observation : landmark.observations) {
      const ReprojectionFactor& factor = problem.factors[next++];
      const auto error = WhitenedError(problem.camera,
                                       {landmark.p_in_object, factor.z_px, factor.sqrt_information},
                                       camera_from_world[factor.pose]);
      if (!error || error->squaredNorm() > gate) continue;
      kept.push_back(observation);
      sum += error->squaredNorm();
      ++count;
    }
    landmark.observations = std::move(kept);
  }
  window.RemoveUnobserved();
  return count > 0 ? std::sqrt(sum / count) : 0.0;
}

}  // namespace cvo
