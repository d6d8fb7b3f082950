// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "reports/results/suite_runs.h"

namespace cvo::reports {

// The jobs that belong to one row.
struct RowRuns {
  std::vector<std::string> keys;  // values of the keys of the table
  std::vector<const SuiteRun*> runs;
};

// Groups the runs into rows, in the order of the plan. `runs` must outlive the result.
std::vector<RowRuns> GroupRuns(const std::vector<SuiteRun>& runs,
                               const std::vector<std::string>& keys);

// The scene of a run: the name of the sequence, the images and the frames that were run.
std::string SceneOf(const SuiteRun& run);

// What is averaged over within a row: the seed, and every key that is neither a key of the row nor
// the sequence.
std::string RepetitionOf(const SuiteRun& run, const std::vector<std::string>& keys);

// The row that `row` is compared with: the row with the same keys except the one in `reference`,
// which is "key=value" or kRowAbove. nullptr if there is none or it is the row itself.
const RowRuns* FindReference(const std::vector<RowRuns>& rows, const RowRuns& row,
                             const std::vector<std::string>& keys, const std::string& reference);

// Completes the reference of a plan: "2d" means "variant=2d". Throws Error if its key is not a key
// of the rows.
std::string FullReference(const SuitePlan& plan);

// The keys that rows average over although the plan has several values of them, as "key: a, b".
std::vector<std::string> PooledKeys(const std::vector<SuiteRun>& runs,
                                    const std::vector<std::string>& keys);

}  // namespace cvo::reports
