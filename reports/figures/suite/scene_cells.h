// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/figures/suite/suite_figures.h"

namespace cvo::reports {

// A row of the table on one sequence alone.
struct SceneRow {
  std::string sequence;
  std::vector<Cell> cells;  // one per column of the table
};

// A row of the table but for the sequence, and what it is made of.
struct SeriesRows {
  std::string label;         // "full", or "good, full" where rows are by more
  std::string name;          // the same without options, or the one variant: for its colour
  std::string options;       // their values: "5"
  const Row* all = nullptr;  // of the table, over all sequences; nullptr where it is by sequence
  std::vector<SceneRow> scenes;
};

// In the order of the table, with differences against its reference. The table must outlive it.
std::vector<SeriesRows> SplitByScene(const SuiteData& data);

// How many rows that would be, of all series.
std::size_t CountSceneRows(const SuiteData& data);

}  // namespace cvo::reports
