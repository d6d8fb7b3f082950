// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/figures/figure_style.h"
#include "reports/figures/suite_figures.h"

// What the kinds of figures of a suite share, and the function that adds each kind.
namespace cvo::reports {

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

// Adds a line, and behind it the band of its intervals.
void AddWithBand(Series line, std::vector<Series>& series);

// The interval of a cell, as its values are shown.
std::optional<ValueRange> IntervalOf(const std::optional<Interval>& interval, double scale,
                                     double base = 0.0);

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

// Each of these functions adds the figures of its kind, or says why there are none.

// Change in error by sequence.
void AddErrorReduction(const SuiteData& data, const std::vector<SeriesRows>& series,
                       SuiteFigures& figures);
void AddErrorOverCoverage(const SuiteData& data, const std::vector<SeriesRows>& series,
                          SuiteFigures& figures);
// For suites whose rows are compared with the row above.
void AddWaterfall(const SuiteData& data, SuiteFigures& figures);
// Metrics over the value of an option, with their coverage.
void AddSensitivity(const SuiteData& data, SuiteFigures& figures);
void AddErrorOverTime(const SuiteData& data, SuiteFigures& figures);
void AddTrajectories(const SuiteData& data, SuiteFigures& figures);
// The mean of the estimated calibration error over time, if a run estimates it.
void AddCalibration(const SuiteData& data, SuiteFigures& figures);
void AddStageTimes(const SuiteData& data, SuiteFigures& figures);

}  // namespace cvo::reports
