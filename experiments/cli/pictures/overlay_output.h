// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "experiments/cli/pictures/run_images.h"
#include "reports/overlays/overlay_run.h"

namespace cvo {

// What is drawn: the same frames of one run, or of several beside each other.
struct OverlayJob {
  std::vector<reports::OverlayRun> runs;
  std::vector<std::string> titles;  // one per run; empty for one run
  bool boxes = true;                // of clusters, with their motion
  bool inset = true;                // bodies from above, where there are boxes
  reports::Corner inset_corner = reports::Corner::kTopLeft;
  bool panels = false;      // of the one run and frame, in place of its image
  std::vector<int> frames;  // counted in the folder of the sequence
  double scale = 1.0;
  std::string output;
  std::vector<std::filesystem::path> read;  // folders that the runs are in
  bool images = true;
  bool sheet = false;
  bool video = false;
  bool quiet = false;
};

// Draws, writes and prints what was written. 0, or 130 where it was stopped.
int WriteOverlays(const OverlayJob& job, const RunImages& images);

}  // namespace cvo
