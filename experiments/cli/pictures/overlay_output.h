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

// What to draw: the same frames of one run, or of several runs side by side.
struct OverlayJob {
  std::vector<reports::OverlayRun> runs;
  std::vector<std::string> titles;  // one per run; not drawn for a single run
  bool boxes = true;                // draw the clusters' boxes and motion
  bool inset = true;                // draw a bird's-eye view; needs `boxes`
  reports::Corner inset_corner = reports::Corner::kTopLeft;
  bool panels = false;      // draw four views of the only run and frame
  std::vector<int> frames;  // as numbered in the sequence's folder
  double scale = 1.0;
  std::string output;
  std::vector<std::filesystem::path> read;  // folders of the runs
  bool images = true;
  bool sheet = false;
  bool video = false;
  bool quiet = false;
};

// Draws and writes the pictures and prints the names of the files. Returns 0, or 130 if it was
// stopped.
int WriteOverlays(const OverlayJob& job, const RunImages& images);

}  // namespace cvo
