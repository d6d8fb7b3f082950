// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/metrics/trajectory.h"
#include "reports/runs/run_detail.h"

namespace cvo {

// A trajectory file, or the camera of a run.
struct PlotInput {
  std::string path;
  std::string name;                         // of the file, or the variant of the run
  std::string sequence;                     // of a run
  Trajectory poses;                         // row i of a KITTI file: at i s
  bool timed = true;                        // false: a KITTI file
  bool camera_axes = false;                 // known to have y down: runs and KITTI files
  Trajectory truth;                         // of a run, in its world; may be empty
  std::vector<reports::BodyDetail> bodies;  // of a run
};

// The kind follows from what is there: a folder is a run, rows with commas are EuRoC's, 8 columns
// TUM's and 12 KITTI's. Throws Error naming the file, the line and what was expected.
PlotInput ReadPlotInput(const std::string& path);

// Names that tell them apart, and times that can be compared: where one is a KITTI file, all are
// counted. Throws Error where lengths differ then.
void MakeComparable(std::vector<PlotInput>& inputs);

}  // namespace cvo
