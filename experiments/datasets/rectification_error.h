// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiments/datasets/sequence.h"

namespace cvo {

// StereoCamera::right_shift_px of a data set whose rectification is known to be off; 0 for others.
double KnownRightShift(const Sequence& sequence);

}  // namespace cvo
