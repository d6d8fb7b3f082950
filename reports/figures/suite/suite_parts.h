// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reports/figures/suite/scene_cells.h"
#include "reports/figures/suite/suite_figures.h"

namespace cvo::reports {

// Each adds the figures of its kind, or why there are none.
// Of a suite whose rows are compared with the row above.
void DrawWaterfall(const SuiteData& data, SuiteDrawing& drawing);
void DrawSensitivity(const SuiteData& data, SuiteDrawing& drawing);
void DrawErrorReduction(const SuiteData& data, const std::vector<SeriesRows>& series,
                        SuiteDrawing& drawing);
// Against what others published (ReferenceFigure), camera and bodies one by one.
void DrawDriftReduction(const SuiteData& data, SuiteDrawing& drawing);
void DrawErrorOverCoverage(const SuiteData& data, const std::vector<SeriesRows>& series,
                           SuiteDrawing& drawing);
void DrawErrorOverTime(const SuiteData& data, SuiteDrawing& drawing);
void DrawTrajectories(const SuiteData& data, SuiteDrawing& drawing);
// Which frames were in the two tracks, for the first run.
void DrawFrameTracks(const SuiteData& data, SuiteDrawing& drawing);
void DrawStageTimes(const SuiteData& data, SuiteDrawing& drawing);

}  // namespace cvo::reports
