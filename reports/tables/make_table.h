// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "reports/tables/reference.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// Makes the table of the output folder of a suite, however much of the suite has run. Rows are
// based on the runs that exist and state how many these are; the other runs are listed. Throws
// Error for a plan that cannot be read and, naming both files, if two of our own results define the
// same metric differently. `default_options`: nested JSON, empty if unknown. `compared_with`:
// replaces the reference of the plan and is written as it is there; throws Error if it matches no
// row. Empty: the reference of the plan.
Table MakeTable(const std::filesystem::path& folder, const Reference& reference,
                const std::string& default_options, const std::string& compared_with = "");

// Compares the runs of `folder` with those of `before`, paired by row, scene, seed and body. Values
// are those of `folder`; differences are with respect to the same row of `before`. Throws Error as
// MakeTable does, and if the two have no run in common.
Table CompareFolders(const std::filesystem::path& before, const std::filesystem::path& folder);

// Whether no job failed or has yet to run, and at least one was completed. Jobs whose sequence is
// not on this machine do not count.
bool IsComplete(const Table& table);

}  // namespace cvo::reports
