// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/figures/palette.h"
#include "reports/figures/suite_figures.h"

namespace cvo::reports {

bool IsOption(const std::string& key);  // other keys identify inputs and estimators

// The variant of all runs, or "all variants" if there are several.
std::string OneVariant(const SuitePlan& plan);

// The palette of the variants of a suite, followed by other names.
Palette PaletteOf(const SuitePlan& plan, const std::vector<std::string>& others = {});

// The drawn runs of one sequence, one per variant.
struct DrawnScene {
  std::string sequence;
  std::vector<const DrawnRun*> runs;
};
// In the order of the data, which must outlive the result.
std::vector<DrawnScene> GroupByScene(const std::vector<DrawnRun>& runs);

std::vector<std::string> VariantsOf(const std::vector<DrawnRun>& runs);

// The seeds of the runs: "seed 1" if they are the same, or "seeds: full 1, 2d 2".
std::string SeedText(const DrawnScene& scene);

// How the truth is aligned to the world frame of a run, for titles.
inline constexpr const char* kTruthAlignment =
    "truth aligned by the camera (rotation: mean over its orientations, translation: over its "
    "positions), one rigid offset per body";

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

// Each of these functions adds the figures of its kind, or says why there are none.

// Change in error by sequence. `series`: from SplitByScene.
void AddErrorReduction(const SuiteData& data, const std::vector<SeriesRows>& series,
                       SuiteFigures& figures);
void AddErrorOverCoverage(const SuiteData& data, const std::vector<SeriesRows>& series,
                          SuiteFigures& figures);
// For suites whose rows are compared with the row above.
void AddWaterfall(const SuiteData& data, SuiteFigures& figures);
// Maximum drift against published figures (ReferenceFigure), for the camera and for each body.
void AddDriftReduction(const SuiteData& data, SuiteFigures& figures);
// Metrics over the value of an option, with their coverage.
void AddSensitivity(const SuiteData& data, SuiteFigures& figures);
void AddErrorOverTime(const SuiteData& data, SuiteFigures& figures);
void AddTrajectories(const SuiteData& data, SuiteFigures& figures);
// Which frames were in the spatial and in the temporal track, for the first run that has a spatial
// track.
void AddFrameTracks(const SuiteData& data, SuiteFigures& figures);
// The mean of the estimated calibration error over time, if a run estimates it.
void AddCalibration(const SuiteData& data, SuiteFigures& figures);
void AddStageTimes(const SuiteData& data, SuiteFigures& figures);

}  // namespace cvo::reports
