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

// A row without its cells. Links are relative to `folder`.
Row DescribeRow(const RowRuns& row, const std::filesystem::path& folder);

// The jobs that did not end well, those of one kind and reason in the order of the plan.
std::vector<Problem> ListProblems(const std::vector<RowRuns>& rows);

// Builds, seeds and options of the runs. `default_options`: nested JSON, empty where not known.
Provenance DescribeRuns(const std::vector<SuiteRun>& runs, const std::string& default_options);

// Levels of the processors that runs were made on, and what is to be said where there are several;
// empty where there are not.
std::set<std::string> CpuLevels(const std::vector<SuiteRun>& runs);
std::string CpuLevelNote(const std::set<std::string>& levels);

// What a reader must know: corrected calibrations, what rows average over, several builds or
// levels of processors.
std::vector<std::string> TableNotes(const std::vector<SuiteRun>& runs, const Table& table);

}  // namespace cvo::reports
