// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/metrics/trajectory.h"
#include "reports/runs/run_detail.h"

namespace cvo {

// A trajectory file, or the camera trajectory of a run.
struct PlotInput {
  std::string path;
  std::string name;                         // stem of the file's name, or variant of the run
  std::string sequence;                     // runs only
  Trajectory poses;                         // row i of a KITTI file is at time i s
  bool timed = true;                        // false for a KITTI file
  bool camera_axes = false;                 // y is known to point down: runs and KITTI files
  Trajectory truth;                         // runs only, in the world of the run; may be empty
  std::vector<reports::BodyDetail> bodies;  // runs only
};

// Reads a trajectory. A folder is a run; a file with commas is in EuRoC's format, one with 8
// columns in TUM's and one with 12 in KITTI's. Throws Error naming the file, the line and what was
// expected.
PlotInput ReadPlotInput(const std::string& path);

// Makes the names unique and the times comparable: if one of the inputs is a KITTI file, all poses
// are matched by their position in the file, and Error is thrown if the numbers of poses differ.
void MakeComparable(std::vector<PlotInput>& inputs);

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
  bool z_up = false;  // of the world; otherwise y points down
  std::int64_t tolerance_ns = 0;
};

// A trajectory as it is drawn and, if it was compared to a reference, its errors.
struct PlotTrack {
  std::string name;
  Trajectory poses = {};             // aligned with the reference
  std::size_t matched = 0;           // number of matched poses; 0: not compared
  std::vector<double> times_s = {};  // of the matched poses
  std::vector<double> errors_m = {};
  std::vector<double> errors_deg = {};
  double scale = 1.0;
};

// Aligns a trajectory with the reference and computes its errors. Throws Error if fewer than two
// poses match.
PlotTrack MatchTrack(const PlotReference& reference, const PlotInput& input,
                     const PlotMatching& matching);

double Seconds(std::int64_t time_ns);

}  // namespace cvo
