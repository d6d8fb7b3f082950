// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/estimation/window.h"
#include "core/solvers/window_solver.h"

namespace cvo {

// Makes a problem from the window's camera, prior and frames, with no frame fixed and no points.
WindowProblem MakeFrames(const Window& window);

// Appends the landmark as the problem's next point, with all its observations.
void AddLandmark(const Landmark& landmark, const FeatureNoise& noise, WindowProblem& problem);

// Returns the indices, ascending, of the landmarks to optimise: those observed at least twice and,
// if there are more than max_points, those with the most observations.
std::vector<int> SelectLandmarks(const Window& window, int max_points);

}  // namespace cvo
