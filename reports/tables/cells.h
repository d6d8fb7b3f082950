// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/record/metric_catalogue.h"
#include "core/record/run_summary.h"
#include "core/record/suite_runs.h"
#include "reports/tables/table.h"

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

// The keys that some row averages over several values of, as "key: a, b".
std::vector<std::string> PooledKeys(const std::vector<RowRuns>& rows,
                                    const std::vector<std::string>& keys);

// Inserts the coverage before each group of metrics that lacks it, since accuracy without coverage
// favours whoever loses the hard parts.
std::vector<std::string> WithCoverage(const std::vector<std::string>& metrics);

// The columns that at least one run has a value for, in the order of `metrics`. Throws Error naming
// both files if two of our own runs define a metric differently: in any field of its definition, or
// in the truth within one type of dataset. Runs of other systems may differ (DifferingMeaning).
std::vector<Column> MakeColumns(const std::vector<std::string>& metrics,
                                const std::vector<SuiteRun>& runs);

// How the first run of a row that has the metric defines it differently from the column. Empty if
// it does not.
std::string DifferingMeaning(const RowRuns& row, const Column& column);

// Names of scenes. One under several names has the first of them: scenes are told apart by their
// images, and what was done to these, where they are known.
class SceneNames {
 public:
  const std::string& Of(const std::string& images, const std::string& name) {
    return names_.try_emplace(images.empty() ? name : images, name).first->second;
  }

 private:
  std::map<std::string, std::string> names_;
};

// Whether a difference between two rows is meaningful: both define the metric as the column does
// and, if one is of another system, both use the same correction of the calibration.
bool AreComparable(const RowRuns& row, const RowRuns& reference, const Column& column);

// The mean of a metric over the runs of a row: over seeds, then bodies, then scenes.
Cell MakeCell(const RowRuns& row, const std::vector<std::string>& keys, const Column& column);

// The paired difference of a row to its reference. Empty if the two have nothing in common.
std::optional<Difference> MakeDifference(const RowRuns& row, const RowRuns& reference,
                                         const std::vector<std::string>& keys,
                                         const Column& column);

// Corrects the p-values of differences that are read together for their number (Holm), and marks
// those that are distinguishable from noise.
void CorrectForMany(const std::vector<Difference*>& differences);

}  // namespace cvo::reports
