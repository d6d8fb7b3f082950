// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cvo::reports {

// Time of a group of runs; figures are medians over them.
struct TimesRow {
  std::vector<std::string> keys;
  std::size_t runs = 0;
  double clusters = 0.0;  // tracked per frame, mean over frames
  double frames_per_s = 0.0;
  std::vector<double> stages_ms;  // mean over frames; 0 where a run lacks the stage
};

struct SuiteTimes {
  std::vector<std::string> keys;  // what rows differ in: scenes, detections, variant, options
  std::vector<std::string> stages;
  std::vector<TimesRow> rows;         // as the plan has them
  std::vector<std::string> machines;  // processor and threads, each once
};

// Of the runs of a suite's folder that are done; those of one family are one row. Throws Error
// without a plan, or where nothing is done.
SuiteTimes ReadSuiteTimes(const std::filesystem::path& folder);

// As texts, the header first. The last column is the time per frame over that of the first row with
// the same scenes and variant.
std::vector<std::vector<std::string>> TimesTable(const SuiteTimes& times);

}  // namespace cvo::reports
