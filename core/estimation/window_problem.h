// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/estimation/window.h"
#include "core/solvers/window_solver.h"

namespace cvo {

// The window's camera, prior and frames, none of these fixed; no points.
WindowProblem MakeFrames(const Window& window);

// Adds the landmark as the problem's next point, with all its observations.
void AddLandmark(const Landmark& landmark, const FeatureNoise& noise, WindowProblem& problem);

// Indices of the landmarks worth optimising: seen at least twice, the longest seen first, at most
// max_points of them; ascending.
std::vector<int> SelectLandmarks(const Window& window, int max_points);

}  // namespace cvo
