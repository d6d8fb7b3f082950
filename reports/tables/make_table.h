// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "reports/tables/reference.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// The table of the folder that a suite is run to, whatever part of it has run. A row stands on the
// runs that are there and says on how many; the others are listed. Throws Error for a plan that
// cannot be read and, naming both files, where two of our own results mean different things by the
// same metric. `default_options`: nested JSON, empty where not known. `compared_with`: in place of
// the plan's reference, as it is written there; throws Error where no row is it. Empty: the plan's.
Table MakeTable(const std::filesystem::path& folder, const Reference& reference,
                const std::string& default_options, const std::string& compared_with = "");

// The runs of `folder` against those of `before`, paired per row, scene, seed and body: values are
// those of `folder`, differences are against the same row of `before`. Throws Error as MakeTable,
// and where the two have no run in common.
Table CompareFolders(const std::filesystem::path& before, const std::filesystem::path& folder);

// No job failed or is yet to run, and some job ran: sequences that are not there do not count.
bool IsComplete(const Table& table);

}  // namespace cvo::reports
