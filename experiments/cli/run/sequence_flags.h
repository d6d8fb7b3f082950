// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/datasets/sequence.h"
#include "experiments/import/import_stereo.h"

namespace cvo {

inline constexpr const char* kSequenceMissing =
    "no sequence: give a folder, or --left, --right and --calib";

// The flags that say which sequence to read, and which part of it.
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
  StereoImport stereo;  // in place of the folder, where --left is given

  void AddTo(CLI::App& app);
  // --type and --layout.
  void AddLayoutTo(CLI::App& app);
  // Those alone that say which part is read and what is true of it; the folder and --groundtruth
  // are left to the caller.
  void AddTruthTo(CLI::App& app);
  // Images of --left and --right become a sequence in the cache first, unless `quiet` with progress
  // on stderr.
  // Throws Error for a range of frames that is none, UsageError where there is no sequence or two.
  SequenceRequest Request(bool quiet = false) const;
  // Files and folders that were named and are no part of a sequence.
  std::vector<std::filesystem::path> OwnInputs() const;
};

// --left, --right, --calib, --times and --rate.
void AddStereo(CLI::App& app, StereoImport& stereo);
// Throws UsageError where one of the first three is missing.
void CheckStereo(const StereoImport& stereo);
// Its files and folders, some empty.
std::vector<std::filesystem::path> InputsOf(const StereoImport& stereo);

void AddRightShift(CLI::App& app, std::optional<double>& right_shift_px);

}  // namespace cvo
