// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "reports/figures/figure.h"
#include "reports/results/suite_runs.h"
#include "reports/runs/identity_switches.h"
#include "reports/runs/run_detail.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// A run that is drawn frame by frame.
struct DrawnRun {
  std::string sequence;  // as the suite names it, and its detections where it has several
  std::string variant;   // and what the truth replaces: "full, oracle boxes"
  std::uint64_t seed = 0;
  std::string job;
  RunDetail detail;
  std::optional<std::vector<IdentitySwitch>> switches;  // empty: not known
};

// All that figures are made of.
struct SuiteData {
  SuitePlan plan;
  std::vector<SuiteRun> runs;  // in the order of the plan
  Table table;
  std::vector<DrawnRun> drawn;         // by sequence, then variant: the first seed
  std::vector<std::string> not_drawn;  // runs that cannot be, and why
};

// Reads what the table was made of, and frame by frame the first seed of each sequence and variant,
// options at their defaults. `folder`: what the suite was run to.
SuiteData ReadSuiteData(const std::filesystem::path& folder, const Table& table);

// Every figure that the data allow: which ones follows from what is there, not from names.
SuiteDrawing SuiteFigures(const SuiteData& data);

}  // namespace cvo::reports
