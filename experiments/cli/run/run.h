// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "experiments/datasets/import/import_stereo.h"
#include "experiments/datasets/sequence.h"
#include "experiments/metrics/pose_errors.h"
#include "experiments/runner/run_result.h"

namespace cvo {

inline constexpr const char* kSequenceMissing =
    "no sequence: give a folder, or --left, --right and --calib";

// Flags that select the sequence to read, and the part of it.
struct SequenceFlags : SequenceRequest {
  std::string frames;        // "A:B"
  std::string layout_flag;   // JSON, or a file
  StereoImport stereo = {};  // instead of the folder, if --left is given

  void AddTo(CLI::App& app);
  // Adds --type and --layout.
  void AddLayoutTo(CLI::App& app);
  // Adds only the flags that select the part to read and its labels. The caller provides the
  // folder.
  void AddTruthTo(CLI::App& app);
  // Images given by --left and --right are first imported into the cache, with progress on stderr
  // unless `quiet`. Throws Error for an invalid range of frames, UsageError if no sequence or both
  // kinds of sequence are given.
  SequenceRequest Request(bool quiet = false) const;
};

// Adds --left, --right, --calib, --times and --rate.
void AddStereo(CLI::App& app, StereoImport& stereo);
// Throws UsageError if --left, --right or --calib is missing.
void CheckStereo(const StereoImport& stereo);
// The detector levels of a rendered scene, one of which --detections may name.
std::vector<std::string> DetectorLevels(const std::filesystem::path& folder);

// The request with the boxes of a rendered scene's detector `good`, unless it names others.
SequenceRequest WithBoxes(SequenceRequest request);

// The files and folders of an import. Some paths may be empty.
std::vector<std::filesystem::path> InputsOf(const StereoImport& stereo);

// Adds --variant and --set.
void AddEstimator(CLI::App& app, std::string& variant, std::vector<std::string>& set);

// Prints a line per body that is visible in some frame. `metrics`: those of these bodies.
void PrintBodies(const std::vector<BodyScore>& bodies, const std::vector<Metric>& metrics,
                 std::ostream& out);

// Prints one metric per line: name, value, unit and number of errors.
void PrintMetrics(const std::vector<Metric>& metrics, std::ostream& out);

}  // namespace cvo
