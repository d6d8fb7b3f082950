// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace cvo::synth {

// The standard normal distribution's quantiles in the middle of 2^16 equal steps, scaled to unit
// variance: 16 random bits as index give a normal number, a 64-bit draw gives four. The tail ends
// at 4.3; nothing that is rounded to 8 bits can tell.
const std::vector<float>& NormalQuantiles();

// Cumulative distribution of the standard normal.
double NormalCdf(double x);

}  // namespace cvo::synth
