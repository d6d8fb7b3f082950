// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/record/suite_runs.h"
#include "reports/chart/chart.h"
#include "reports/runs/run_detail.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// A run that is drawn frame by frame.
struct DrawnRun {
  std::string sequence;  // its name in the suite, with its detections if there are several
  std::string variant;   // with what is replaced by the truth: "full, oracle boxes"
  std::uint64_t seed = 0;
  std::string job;
  RunDetail detail;
  std::vector<IdentitySwitch> switches;
};

// Everything that figures are made of.
struct SuiteData {
  SuitePlan plan;
  std::vector<SuiteRun> runs;  // in the order of the plan
  Table table;
  std::vector<DrawnRun> drawn;         // one run per sequence and variant, in the order of the plan
  std::vector<std::string> not_drawn;  // runs, or parts of them, that cannot be drawn, and why
};

// Reads the runs that the table was made from and, frame by frame, one run per sequence and
// variant: the first in the plan whose options are at, or nearest to, their defaults. `folder` is
// the output folder of the suite.
SuiteData ReadSuiteData(const std::filesystem::path& folder, const Table& table);

// A chart with its texts, which the chart itself lacks: a page writes them as HTML, a file draws
// them.
struct Figure {
  std::string name;     // letters, digits and "-": a file name
  std::string title;    // first sentence: what is shown; the rest: relation, delta and alignment
  std::string caption;  // how to read it: marks, intervals, machine
  Chart chart;
};

struct SuiteFigures {
  std::vector<Figure> figures;
  std::vector<std::string> not_drawn;  // what could not be drawn, and why
};

// Draws every figure that the data allow. This depends on what the data contain, not on names.
SuiteFigures MakeSuiteFigures(const SuiteData& data);

}  // namespace cvo::reports
