// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reports/figures/suite/scene_cells.h"
#include "reports/figures/suite/suite_figures.h"

namespace cvo::reports {

// Each of these functions adds the figures of its kind, or says why there are none.

// For suites whose rows are compared with the row above.
void DrawWaterfall(const SuiteData& data, SuiteDrawing& drawing);
void DrawSensitivity(const SuiteData& data, SuiteDrawing& drawing);
void DrawErrorReduction(const SuiteData& data, const std::vector<SeriesRows>& series,
                        SuiteDrawing& drawing);
// Against published figures (ReferenceFigure), for the camera and for each body.
void DrawDriftReduction(const SuiteData& data, SuiteDrawing& drawing);
void DrawErrorOverCoverage(const SuiteData& data, const std::vector<SeriesRows>& series,
                           SuiteDrawing& drawing);
void DrawErrorOverTime(const SuiteData& data, SuiteDrawing& drawing);
void DrawTrajectories(const SuiteData& data, SuiteDrawing& drawing);
// Shows which frames were in the spatial and in the temporal track, for the first run that has a
// spatial track.
void DrawFrameTracks(const SuiteData& data, SuiteDrawing& drawing);
// The mean of the estimated calibration error over time, if a run estimates it.
void DrawCalibration(const SuiteData& data, SuiteDrawing& drawing);
void DrawStageTimes(const SuiteData& data, SuiteDrawing& drawing);

}  // namespace cvo::reports
