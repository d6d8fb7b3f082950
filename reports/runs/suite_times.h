// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cvo::reports {

// Times of a group of runs; values are medians over them.
struct TimesRow {
  std::vector<std::string> keys;
  std::size_t runs = 0;
  double clusters = 0.0;  // tracked per frame, mean over frames
  double frames_per_s = 0.0;
  std::vector<double> stages_ms;  // mean over frames; 0 if a run lacks the stage
};

struct SuiteTimes {
  std::vector<std::string> keys;  // what distinguishes rows: scenes, detections, variant, options
  std::vector<std::string> stages;
  std::vector<TimesRow> rows;         // in the order of the plan
  std::vector<std::string> machines;  // distinct processors with their numbers of threads
};

// Reads the times of the finished runs in a suite's output folder; the runs of one family form one
// row. Throws Error if there is no plan, or if no run is finished.
SuiteTimes ReadSuiteTimes(const std::filesystem::path& folder);

// Returns the times as texts, header first. The last column is the time per frame divided by that
// of the first row with the same scenes and variant.
std::vector<std::vector<std::string>> TimesTable(const SuiteTimes& times);

}  // namespace cvo::reports
