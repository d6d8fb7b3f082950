// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace cvo::reports {

// Differences of pairs, within their strata.
using Differences = std::vector<std::vector<double>>;

// Two-sided p-value of "the mean over strata of their mean difference is 0": Student's t with as
// many degrees of freedom as there are differences more than strata. A stratum of one difference
// is taken as known. Empty where no stratum has two.
std::optional<double> PairedPValue(const Differences& differences);

// How many differences, equally many in each stratum and of the same spread, tell one of `size`
// > 0 from 0 with a probability of 80 %, at 5 % two-sided. Empty where no stratum has two.
std::optional<std::size_t> PairsNeeded(const Differences& differences, double size);

// Holm's step-down correction (1979) of p-values that are looked at together, each in its place:
// the chance that any of the true "no difference" has an adjusted one below 5 % is at most 5 %,
// however they depend on each other.
std::vector<double> HolmAdjusted(const std::vector<double>& p_values);

}  // namespace cvo::reports
