// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/solvers/window_solver.h"

namespace cvo {

// Eliminates all points of the problem and the pose of `removed` by Schur complement, and returns
// the result as a prior over the other frames and right_field_px (METHOD.md 7.3). Factors and the
// old prior are linearised at the problem's state, factors after the robust loss. The problem must
// hold only the factors to be marginalised: points with all their remaining observations.
// Directions whose eigenvalue is below 1e-10 of the largest are taken to carry no information.
WindowPrior Marginalize(const NoiseOptions& noise, const WindowProblem& problem, FrameId removed);

}  // namespace cvo
