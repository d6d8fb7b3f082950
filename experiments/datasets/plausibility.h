// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/datasets/sequence.h"

namespace cvo {

// Describes what is well-formed but implausible in the calibration, the timestamps and the true
// poses of a sequence, one line per finding: a baseline not in metres, a gap between frames, a
// camera or a body that jumps, a car that slips sideways. Empty if nothing is. `bodies` is null if
// there is no ground truth of bodies.
std::vector<std::string> FindImplausible(const Sequence& sequence, const ObjectTruth* bodies);

}  // namespace cvo
