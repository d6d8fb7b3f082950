// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/association/matching.h"
#include "core/base/task_pool.h"
#include "core/clusters/cluster_map.h"
#include "core/estimation/camera_solver.h"
#include "core/estimation/cluster.h"
#include "core/estimation/double_track.h"
#include "core/solvers/schur_solver.h"

namespace cvo {

// Converts matches of a body's landmarks with features to measurements of the camera pose in the
// body's frame.
std::vector<PointMeasurement> MeasurementsOf(const FeatureNoise& noise,
                                             const std::vector<Landmark>& landmarks,
                                             std::span<const StereoFeature> features,
                                             const std::vector<Match>& matches);

// The optimisation problem of a cluster, and the states and landmarks that take part in it.
struct ClusterSelection {
  ClusterProblem problem;
  std::vector<int> states;     // indices into cluster.states, one per frame of the problem
  std::vector<int> landmarks;  // indices into cluster.landmarks, one per point
};
ClusterSelection SelectCluster(const FeatureNoise& noise, const Window& window,
                               const Cluster& cluster);

// Writes the solution back and removes observations whose squared whitened error exceeds `gate`.
void ApplyClusterSolution(double gate, const ClusterSelection& selection, Cluster& cluster);

// The steps of the optimisation in which variants differ.
struct EnergySteps {
  MotionPriorSteps (*prior)(const MotionPriorOptions&, const ClusterProblem&);
  double (*gate)(const NoiseOptions&);
  SolverSummary (*solve_window)(const NoiseOptions&, const SolverOptions&, WindowProblem&);
  SolverSummary (*solve_cluster)(const NoiseOptions&, const SolverOptions&, const MotionPriorSteps&,
                                 ClusterProblem&);
};

// Sliding-window estimation of every cluster observed in the newest frame, with the camera held
// fixed (section 3.3 of the paper, dynamic clusters). Clusters are independent and are solved in
// parallel; the result is the same for any pool. A hidden cluster keeps its last estimate: there is
// no new information on it, while the frames that constrain its last states leave the window.
// Outliers must therefore be removed in the frame in which they occur, by solving again without
// them: a body that leaves the image has its worst matches in its last frame. Returns how the
// solves ended.
SolverEndings OptimizeClusters(const Options& options, const EnergySteps& steps,
                               const Window& window, TaskPool& pool, ClusterMap& map);

}  // namespace cvo
