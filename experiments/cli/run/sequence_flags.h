// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "experiments/datasets/sequence.h"

namespace cvo {

// The flags that say which sequence to read, and which part of it.
struct SequenceFlags {
  std::string folder;
  std::string type;
  std::string dataset;
  std::string pair;
  std::string groundtruth = "devkit";
  std::string frames;
  std::string labels;
  std::string detections;
  int labels_camera = -1;
  int detections_camera = -1;
  double min_score = -1e300;
  std::optional<double> right_shift_px;

  void AddTo(CLI::App& app);
  // Those alone that say which part is read and what is true of it; the folder and --groundtruth
  // are left to the caller.
  void AddTruthTo(CLI::App& app);
  // Throws Error for a range of frames that is none.
  SequenceRequest Request() const;
};

void AddRightShift(CLI::App& app, std::optional<double>& right_shift_px);

}  // namespace cvo
