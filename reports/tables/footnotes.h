// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/tables/table.h"

namespace cvo::reports {

// "[a]", "[b]", ...: the mark of a source of reference rows.
std::string SourceMark(std::size_t source);

// "11 bodies, 4 scenes, 5 seeds, 20 runs": what a value is a mean over.
std::string CountsText(const Counts& n);

// The units that an interval resamples: "4 scenes" or, for a single scene, "11 bodies" or "5 runs".
std::string UnitsText(const Counts& n);

// What a reader must know about the numbers: which runs are missing, what intervals mean, what
// values are based on and leave out, and where the numbers of others come from.
std::vector<std::string> Footnotes(const Table& table);

// The definition of each column, from its contract.
std::vector<std::string> Definitions(const Table& table);

}  // namespace cvo::reports
