// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/figures/suite/suite_figures.h"

namespace cvo::reports {

// The part of a table row that belongs to one sequence.
struct SceneRow {
  std::string sequence;
  std::vector<Cell> cells;  // one per column of the table
};

// The rows of the table that share all keys except the sequence.
struct SeriesRows {
  std::string label;         // "full", or "good, full" if rows have more keys
  std::string name;          // the label without options, or the only variant; sets the colour
  std::string options;       // the values of the options: "5"
  const Row* all = nullptr;  // row over all sequences; nullptr if the table is by sequence
  std::vector<SceneRow> scenes;
};

// Splits the rows of the table by sequence, in the order of the table, with differences against its
// reference. `data` must outlive the result.
std::vector<SeriesRows> SplitByScene(const SuiteData& data);

// The number of rows that SplitByScene would return, over all series.
std::size_t CountSceneRows(const SuiteData& data);

}  // namespace cvo::reports
