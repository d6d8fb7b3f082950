// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/task_pool.h"
#include "core/clusters/cluster_map.h"
#include "core/estimation/window_policies.h"
#include "core/solvers/solver_policy.h"

namespace cvo {

// A cluster's problem and which of its parts are in it.
struct ClusterSelection {
  ClusterProblem problem;
  std::vector<int> states;     // indices of cluster.states, by frame of the problem
  std::vector<int> landmarks;  // indices of cluster.landmarks, by point
};
ClusterSelection SelectCluster(const FeatureNoise& noise, const Window& window,
                               const Cluster& cluster);

// Writes a solved problem back and removes observations whose squared whitened error is above
// `gate`; how many.
int ApplyClusterSolution(double gate, const ClusterSelection& selection, Cluster& cluster);

// What the windows of the clusters are solved with.
struct ClusterSolverOptions {
  FeatureNoise noise;
  SolverOptions solver;
  MotionPriorOptions motion_prior;
};

// Sliding-window estimation of every cluster in sight, the camera held (section 3.3 of the paper,
// dynamic clusters). They are independent: in parallel, with the same result for any pool. One that
// is hidden keeps what it was last seen with: nothing new is known of it, while what held its last
// states leaves the window. So its outliers are found here and now: a body that leaves the image
// has its worst matches in its last frame. Returns how the solves ended.
template <MotionPriorPolicy MotionPrior, OutlierPolicy Outliers, SolverPolicy Solver>
SolverEndings OptimizeClusters(const ClusterSolverOptions& options, const Window& window,
                               TaskPool& pool, ClusterMap& map) {
  SolverEndings total;
  if (window.temporal.empty()) return total;
  const FrameId newest = window.temporal.back().id;
  std::vector<SolverEndings> endings(map.live.size());
  pool.ParallelFor(static_cast<int>(map.live.size()), [&](int q) {
    if (map.live[q].last_observed != newest) return;
    for (int round = 0; round < options.solver.cluster_rounds; ++round) {
      ClusterSelection selection = SelectCluster(options.noise, window, map.live[q]);
      if (selection.landmarks.empty()) return;
      endings[q].Count(SolveCluster<MotionPrior, Solver>(options.noise.options, options.solver,
                                                         options.motion_prior, selection.problem)
                           .ending);
      const double gate = Outliers::Gate(options.noise.options);
      if (ApplyClusterSolution(gate, selection, map.live[q]) == 0) return;
    }
  });
  for (const SolverEndings& of_cluster : endings) total += of_cluster;
  return total;
}

}  // namespace cvo
