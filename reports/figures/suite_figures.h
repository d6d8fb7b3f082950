// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/record/suite_runs.h"
#include "reports/figures/figure_style.h"
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
// variant: the first in the plan. `folder` is the output folder of the suite.
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

// ---- What the kinds of figures share, and the function that adds each kind.

bool IsOption(const std::string& key);  // other keys identify inputs and estimators

// The variant of all runs, or "all variants" if there are several.
std::string OneVariant(const SuitePlan& plan);

// The palette of the variants of a suite, followed by other names.
Palette PaletteOf(const SuitePlan& plan, const std::vector<std::string>& others = {});
Palette PaletteOfDrawn(const SuiteData& data);

// The drawn runs of one sequence, one per variant.
struct DrawnScene {
  std::string sequence;
  std::vector<const DrawnRun*> runs;
};
// In the order of the data, which must outlive the result.
std::vector<DrawnScene> GroupByScene(const std::vector<DrawnRun>& runs);

// What the titles of figures of a scene end with: its seeds, and how the truth is aligned.
std::string SceneText(const DrawnScene& scene);

// Values over frames, or places along a path. Frames that are left out are a gap.
struct Track {
  std::vector<Datum> data = {};
  int last = 0;

  void Add(int frame, double x, double y);
};

// Each of these functions adds the figures of its kind, or says why there are none.

// Paired differences from the reference of the table, as a forest plot.
void AddAblation(const SuiteData& data, SuiteFigures& figures);
// Metrics over the value of an option, with their coverage, and over CPU time if it is measured.
void AddSensitivity(const SuiteData& data, SuiteFigures& figures);
void AddErrorOverTime(const SuiteData& data, SuiteFigures& figures);
void AddTrajectories(const SuiteData& data, SuiteFigures& figures);

}  // namespace cvo::reports
