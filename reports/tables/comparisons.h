// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/statistics/estimate.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// Converts a paired estimate. `reference` is the label of the reference row, `meaning` describes
// the intervals, and `pairing` what the two rows have in common.
Difference DifferenceOf(const PairedEstimate& estimate, const std::string& reference,
                        const std::string& meaning, const std::string& pairing);

// Whether a difference is an improvement. Empty if the metric is unknown.
std::optional<bool> IsBetter(const std::string& metric, double difference);

// "undecided (3 pairs, 6 needed)". `what` is the singular name of the paired units.
std::string UndecidedText(std::size_t pairs, const std::string& what = "pair");

// "better", "worse", "differs", "the same", "not significant" or UndecidedText. Call it after
// CorrectForMany.
std::string VerdictText(const Difference& difference, const std::string& metric,
                        const std::string& what = "pair");

// Corrects the p-values of differences that are read together for their number (Holm), and marks
// those that are distinguishable from noise.
void CorrectForMany(const std::vector<Difference*>& differences);

// The same for all differences of a table.
void CorrectForMany(Table& table);

// One line per cell whose paired difference is not 0: its size, its interval, and whether it is
// distinguishable from noise. Distinguishable ones come first. "nothing changed" if there is none.
std::string MovedText(const Table& table);

}  // namespace cvo::reports
