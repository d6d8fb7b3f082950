// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/tables/table.h"

namespace cvo::reports {

// "[a]", "[b]", ...: a source of reference rows.
std::string SourceMark(std::size_t source);

// "11 bodies, 4 scenes, 5 seeds, 20 runs": what a value is made of.
std::string CountsText(const Counts& n);

// Of these, what an interval resamples: "4 scenes", or "11 bodies" or "5 runs" of one scene.
std::string UnitsText(const Counts& n);

// What a reader must know of the figures: runs that are missing, what intervals mean, what values
// are made of and leave out, and where figures of others come from.
std::vector<std::string> Footnotes(const Table& table);

// What each column is, by its contract.
std::vector<std::string> Definitions(const Table& table);

}  // namespace cvo::reports
