// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/datasets/sequence.h"

namespace cvo {

// What is well-formed in the times and the true poses of a sequence and yet implausible, one line
// each: a gap between frames, a camera or a body that jumps, a car that slips sideways. Empty for a
// good one. `bodies`: null where nothing is known of them.
std::vector<std::string> FindImplausible(const Sequence& sequence, const ObjectTruth* bodies);

}  // namespace cvo
