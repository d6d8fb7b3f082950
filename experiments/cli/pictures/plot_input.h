// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

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

}  // namespace cvo
