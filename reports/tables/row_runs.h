// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "reports/results/suite_runs.h"

namespace cvo::reports {

// The jobs of one row.
struct RowRuns {
  std::vector<std::string> keys;  // values
  std::vector<const SuiteRun*> runs;
};

// Rows in the order of the plan. `runs` must outlive them.
std::vector<RowRuns> GroupRuns(const std::vector<SuiteRun>& runs,
                               const std::vector<std::string>& keys);

// The scene that a run is of: its name and the frames that were run.
std::string SceneOf(const SuiteRun& run);

// What is averaged over within a row: the seed, and every key that neither is one of the row's nor
// the sequence.
std::string RepetitionOf(const SuiteRun& run, const std::vector<std::string>& keys);

// The row that another is compared with: the same but for the key of `reference`, which is
// "key=value" or kRowAbove. nullptr where there is none or where it is the row itself.
const RowRuns* FindReference(const std::vector<RowRuns>& rows, const RowRuns& row,
                             const std::vector<std::string>& keys, const std::string& reference);

// "2d" means "variant=2d". Throws Error where the key is none of the rows'.
std::string FullReference(const SuitePlan& plan);

// Keys that rows average over though the plan has several values of them, as "key: a, b".
std::vector<std::string> PooledKeys(const std::vector<SuiteRun>& runs,
                                    const std::vector<std::string>& keys);

}  // namespace cvo::reports
