// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/record/run_summary.h"
#include "reports/tables/table.h"

namespace cvo::reports {

struct ComparedRun {
  std::string name;  // unique: the variant, or the folder
  std::string folder;
  std::string variant;
  std::uint64_t seed = 0;
  std::string status;
  int first_frame = 0;
  int frames = 0;
  std::string build;
  std::map<std::string, std::string> options;  // those that differ between the runs

  CVO_FIELDS(name, folder, variant, seed, status, first_frame, frames, build, options);
};

// A metric with its value in each run.
struct ComparedMetric {
  std::string name;
  std::string unit;
  std::vector<std::optional<double>> values;  // by run
  std::string differing;  // first field of its contract that differs between runs; empty: none

  CVO_RECORD(CVO_FIELD(name, unit, values) CVO_OPTIONAL(differing));
};

// A run compared with the first one on what both have: frames of one body or of the camera, or all
// bodies.
struct PairedComparison {
  std::string run;
  std::string what;  // "camera", or the name of a body or of a metric
  // Metric of the same kind in the catalogue. For the camera, camera_ate_mean, over these frames.
  std::string metric;
  std::string unit;
  std::size_t frames = 0;  // number that both have; 0: bodies are paired
  Difference difference;
  std::string verdict;

  CVO_FIELDS(run, what, metric, unit, frames, difference, verdict);
};

// Runs on one sequence, side by side. Differences are each run's value minus the first one's.
struct RunComparison {
  static constexpr int kSchemaVersion = 1;
  static constexpr const char* kKind = "comparison of runs";

  std::string sequence;
  std::vector<ComparedRun> runs;
  std::vector<ComparedMetric> metrics;
  std::vector<PairedComparison> by_frame;
  std::vector<PairedComparison> by_body;
  std::vector<std::string> notes;  // what is not compared, and why

  CVO_FIELDS(sequence, runs, metrics, by_frame, by_body, notes);
};

// Compares the runs in at least two folders; the first is the reference for the others. Throws
// Error for a folder that holds no run, and for runs on different sequences.
RunComparison CompareRuns(const std::vector<std::filesystem::path>& folders);

// Returns how many consecutive frames to resample as one block, because errors of neighbouring
// frames are correlated. There are about as many blocks as frames in each.
std::size_t BlockLength(std::size_t frames);

}  // namespace cvo::reports
