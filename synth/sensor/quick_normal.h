// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace cvo::synth {

// Returns the quantiles of the standard normal distribution at the midpoints of 2^16 equal
// intervals of probability, scaled to unit variance. Used as an index, 16 random bits give one
// normal number, so a 64-bit draw gives four. The tails end at 4.3, which makes no difference after
// rounding to 8 bits.
const std::vector<float>& NormalQuantiles();

// Cumulative distribution function of the standard normal distribution.
double NormalCdf(double x);

}  // namespace cvo::synth
