// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/statistics/estimate.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// A difference as an estimate has it. `reference`: its label; `meaning`: of its intervals.
Difference DifferenceOf(const PairedEstimate& estimate, const std::string& reference,
                        const std::string& meaning, const std::string& pairing);

// Whether a higher or lower value is better; empty for a metric that is not known.
std::optional<bool> IsBetter(const std::string& metric, double difference);

// "undecided (3 pairs, 6 needed)"; `what` is one of those that are paired.
std::string UndecidedText(std::size_t pairs, const std::string& what = "pair");

// "better", "worse", "differs", "the same", "not significant" or UndecidedText. After
// CorrectForMany.
std::string VerdictText(const Difference& difference, const std::string& metric,
                        const std::string& what = "pair");

// Corrects the p-values of differences that are read together for their number (Holm), and says
// which of them can be told from noise.
void CorrectForMany(const std::vector<Difference*>& differences);

// All differences of a table.
void CorrectForMany(Table& table);

// One line per cell whose paired difference is not 0: by how much, in which interval, and whether
// that can be told from noise; these first. "nothing changed" where there is none.
std::string MovedText(const Table& table);

}  // namespace cvo::reports
