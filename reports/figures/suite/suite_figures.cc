// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figures/suite/suite_figures.h"

#include <map>

#include "core/base/error.h"
#include "reports/figures/suite/suite_parts.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kMaxSceneRows = 400;

// Names that differ only in punctuation give the same id, so all but the first are numbered.
void MakeIdsUnique(std::vector<Figure>& figures) {
  std::map<std::string, int> seen;
  for (Figure& figure : figures) {
    const int count = ++seen[figure.id];
    if (count > 1) figure.id += StrCat("-", count);
  }
}

}  // namespace

SuiteDrawing SuiteFigures(const SuiteData& data) {
  SuiteDrawing drawing;
  const std::size_t rows = CountSceneRows(data);
  if (rows <= kMaxSceneRows) {
    const std::vector<SeriesRows> series = SplitByScene(data);
    DrawErrorReduction(data, series, drawing);
    DrawErrorOverCoverage(data, series, drawing);
  } else {
    drawing.not_drawn.push_back(
        StrCat("Change in error by sequence, and error over coverage: ", rows,
               " rows of the table by sequence, at most ", kMaxSceneRows, " can be read."));
  }
  DrawWaterfall(data, drawing);
  DrawDriftReduction(data, drawing);
  DrawSensitivity(data, drawing);
  DrawErrorOverTime(data, drawing);
  DrawTrajectories(data, drawing);
  DrawFrameTracks(data, drawing);
  DrawCalibration(data, drawing);
  DrawStageTimes(data, drawing);
  MakeIdsUnique(drawing.figures);
  drawing.not_drawn.insert(drawing.not_drawn.end(), data.not_drawn.begin(), data.not_drawn.end());
  return drawing;
}

}  // namespace cvo::reports
