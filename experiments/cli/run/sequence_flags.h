// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/datasets/import/import_stereo.h"
#include "experiments/datasets/sequence.h"

namespace cvo {

inline constexpr const char* kSequenceMissing =
    "no sequence: give a folder, or --left, --right and --calib";

// Flags that select the sequence to read, and the part of it.
struct SequenceFlags {
  std::string folder;
  std::string type;
  std::string dataset;
  std::string pair;
  std::string groundtruth = "devkit";
  std::string frames;
  std::string labels;
  std::string layout;
  std::string detections;
  int labels_camera = -1;
  int detections_camera = -1;
  double min_score = -1e300;
  std::optional<double> right_shift_px;
  StereoImport stereo;  // instead of the folder, if --left is given

  void AddTo(CLI::App& app);
  // Adds --type and --layout.
  void AddLayoutTo(CLI::App& app);
  // Adds only the flags that select the part to read and its ground truth. The caller provides the
  // folder and --groundtruth.
  void AddTruthTo(CLI::App& app);
  // Images given by --left and --right are first imported into the cache, with progress on stderr
  // unless `quiet`. Throws Error for an invalid range of frames, UsageError if no sequence or both
  // kinds of sequence are given.
  SequenceRequest Request(bool quiet = false) const;
  // Files and folders that the user named and that are not part of a sequence.
  std::vector<std::filesystem::path> OwnInputs() const;
};

// Adds --left, --right, --calib, --times and --rate.
void AddStereo(CLI::App& app, StereoImport& stereo);
// Throws UsageError if --left, --right or --calib is missing.
void CheckStereo(const StereoImport& stereo);
// The files and folders of an import. Some paths may be empty.
std::vector<std::filesystem::path> InputsOf(const StereoImport& stereo);

void AddRightShift(CLI::App& app, std::optional<double>& right_shift_px);

}  // namespace cvo
