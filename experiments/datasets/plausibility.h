// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/datasets/sequence.h"

namespace cvo {

// What is well-formed in the times and the true poses of a sequence and yet hardly true, one line
// each: a gap between frames, a camera that jumps. Empty for a good one.
std::vector<std::string> FindImplausible(const Sequence& sequence);

}  // namespace cvo
