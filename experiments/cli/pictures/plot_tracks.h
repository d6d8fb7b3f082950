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

// What trajectories are aligned with and held against.
struct PlotReference {
  std::string name;
  Trajectory poses;
  bool is_truth = true;  // else the first trajectory
  bool of_run = false;   // in whose world it is
};

// The truth of the first run that has one, else the first trajectory of several; empty where there
// is none of these.
std::optional<PlotReference> ReferenceAmong(const std::vector<PlotInput>& inputs);

struct PlotMatching {
  TrajectoryAlignment alignment = TrajectoryAlignment::kSe3;
  reports::Vertical vertical = reports::Vertical::kYDown;
  std::int64_t tolerance_ns = 0;
};

// A trajectory and, held against a reference, its errors.
struct MatchedTrack {
  reports::PlottedTrack track;
  std::size_t matched = 0;  // poses; 0: not held against anything
  double scale = 1.0;
  double rms_m = 0.0;
  double mean_m = 0.0;
  double most_m = 0.0;
  double rms_deg = 0.0;
};

// As it is.
MatchedTrack TrackOf(const std::string& name, const Trajectory& poses);
// Aligned. Throws Error where less than two poses match.
MatchedTrack MatchTrack(const PlotReference& reference, const PlotInput& input,
                        const PlotMatching& matching);

// The moving bodies of a run, each from the first frame in which it is visible to the last, in the
// world of the run.
std::vector<reports::PlottedBody> MovingBodies(const PlotInput& run);

}  // namespace cvo
