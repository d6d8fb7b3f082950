// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace cvo::reports {

// Differences of pairs, grouped by stratum.
using Differences = std::vector<std::vector<double>>;

// Two-sided p-value of the hypothesis "the mean over strata of their mean differences is 0".
// Student's t, with as many degrees of freedom as there are differences minus strata. The only
// difference of a stratum is taken as known exactly. Empty if no stratum has two differences.
std::optional<double> PairedPValue(const Differences& differences);

// The number of differences that are needed to detect a mean difference of `size` > 0 with a power
// of 80 %, at 5 % two-sided, if each stratum has equally many and their spread stays the same.
// Empty if no stratum has two differences.
std::optional<std::size_t> PairsNeeded(const Differences& differences, double size);

// Holm's step-down correction (1979) of p-values that are looked at together. Returns the adjusted
// p-values in the order of the input: the probability that any true null hypothesis has an adjusted
// p-value below 5 % is at most 5 %, whatever their dependence.
std::vector<double> HolmAdjusted(const std::vector<double>& p_values);

}  // namespace cvo::reports
