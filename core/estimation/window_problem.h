// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/estimation/window.h"
#include "core/features/stereo_feature.h"
#include "core/features/stereo_matcher.h"
#include "core/solvers/window_solver.h"

namespace cvo {

// Makes a problem from the window's camera, prior and frames, with no frame fixed and no points.
WindowProblem MakeFrames(const Window& window);

// Appends the landmark as the problem's next point, with all its observations.
void AddLandmark(const Landmark& landmark, const FeatureNoise& noise, WindowProblem& problem);

// Returns the indices, ascending, of the landmarks to optimise: those observed at least twice and,
// if there are more than max_points, those with the most observations.
std::vector<int> SelectLandmarks(const Window& window, int max_points);

// Eliminates all points of the problem and the pose of `removed` by Schur complement, and returns
// the result as a prior over the other frames and right_field_px (Eq. 11 of the paper; METHOD.md
// 7.3). Factors and the old prior are linearised at the problem's state, factors after the robust
// loss. The problem must hold only the factors to be marginalised: points with all their remaining
// observations. Directions whose eigenvalue is below 1e-10 of the largest carry no information.
WindowPrior Marginalize(const NoiseOptions& noise, const WindowProblem& problem, FrameId removed);

// Returns the row offsets of all features that have one.
std::vector<RowOffset> RowOffsets(const std::vector<StereoFeature>& features, double scale_factor);

// Appends to the prior what the row offsets of the pair say of its right_field_px (METHOD.md 7.6):
// a rotation of the right camera, a longer lens and a shifted centre of distortion move rows and
// columns by related amounts. `deviation_px` is the standard deviation of each coefficient of the
// row field from such a cause.
void AppendRowEvidence(const RowField& rows, const StereoCamera& camera, double deviation_px,
                       WindowPrior& prior);

}  // namespace cvo
