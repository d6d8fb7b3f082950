// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "reports/tables/row_runs.h"
#include "reports/tables/table.h"

namespace cvo::reports {

JobCounts CountJobs(const std::vector<const SuiteRun*>& runs);

// Describes a row without its cells. Links are relative to `folder`.
Row DescribeRow(const RowRuns& row, const std::filesystem::path& folder);

// The jobs that did not end well, grouped by state and, within a state, in the order of the rows.
std::vector<Problem> ListProblems(const std::vector<RowRuns>& rows);

// The builds, seeds and options of the runs. `default_options`: nested JSON, empty if unknown.
Provenance DescribeRuns(const std::vector<SuiteRun>& runs, const std::string& default_options);

// The levels of the processors on which the runs were made, and a note for the reader if there are
// several. The note is empty otherwise.
std::set<std::string> CpuLevels(const std::vector<SuiteRun>& runs);
std::string CpuLevelNote(const std::set<std::string>& levels);

// What a reader must know to compare rows: corrected calibrations, perturbed images, what rows
// average over, several builds or processor levels.
std::vector<std::string> TableNotes(const std::vector<SuiteRun>& runs, const Table& table);

}  // namespace cvo::reports
