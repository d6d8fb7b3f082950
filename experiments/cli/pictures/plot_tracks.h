// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cli/pictures/plot_input.h"
#include "experiments/metrics/alignment.h"
#include "reports/figures/trajectory_plot.h"

namespace cvo {

// The trajectory that others are aligned with and compared to.
struct PlotReference {
  std::string name;
  Trajectory poses;
  bool is_truth = true;  // false: it is the first trajectory
  bool of_run = false;   // it is the truth of a run, in the world of that run
};

// Returns the truth of the first run that has one, otherwise the first of several trajectories,
// otherwise nothing.
std::optional<PlotReference> ReferenceAmong(const std::vector<PlotInput>& inputs);

struct PlotMatching {
  TrajectoryAlignment alignment = TrajectoryAlignment::kSe3;
  reports::Vertical vertical = reports::Vertical::kYDown;
  std::int64_t tolerance_ns = 0;
};

// A trajectory and, if it was compared to a reference, its errors.
struct MatchedTrack {
  reports::PlottedTrack track;
  std::size_t matched = 0;  // number of matched poses; 0: not compared
  double scale = 1.0;
  double rms_m = 0.0;
  double mean_m = 0.0;
  double most_m = 0.0;
  double rms_deg = 0.0;
};

// Returns a trajectory as it is, without alignment and errors.
MatchedTrack TrackOf(const std::string& name, const Trajectory& poses);
// Aligns a trajectory with the reference and computes its errors. Throws Error if fewer than two
// poses match.
MatchedTrack MatchTrack(const PlotReference& reference, const PlotInput& input,
                        const PlotMatching& matching);

// Returns the moving bodies of a run, each from the first to the last frame in which it is visible,
// in the world of the run.
std::vector<reports::PlottedBody> MovingBodies(const PlotInput& run);

}  // namespace cvo
