// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/estimation/window_solver.h"

namespace cvo {

// Removes all points of the problem and the pose of `removed` from its energy by Schur complement
// and returns what is left as a prior over the other frames (estimator.md 4.2): factors and the old
// prior are linearised at the problem's state, factors after the robust loss. The problem holds
// just the factors to be marginalised: points with all their remaining observations. Pass an
// invalid id to remove points only. Directions with less than 1e-10 of the largest eigenvalue carry
// no information.
PosePrior Marginalize(const StereoCamera& camera, const NoiseOptions& noise,
                      const WindowProblem& problem, FrameId removed);

}  // namespace cvo
