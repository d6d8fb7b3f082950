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
#include "reports/statistics/estimate.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// Calls `act` with the indices of each frame that both ascending lists have. `shift` and
// `other_shift` convert their frames to a common numbering.
template <typename Act>
void ForCommonFrames(const std::vector<int>& frames, int shift, const std::vector<int>& others,
                     int other_shift, const Act& act) {
  for (std::size_t i = 0, k = 0; i < frames.size() && k < others.size();) {
    const int frame = frames[i] + shift;
    const int other = others[k] + other_shift;
    if (frame == other) act(i, k);
    if (frame <= other) ++i;
    if (other <= frame) ++k;
  }
}

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

// The columns for the trajectory of the camera, and those for moving bodies: the ablation of the
// paper (its table 4), coverage, and identity.
std::vector<std::string> CameraMetrics();
std::vector<std::string> ObjectMetrics();

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

// Whether a difference between two rows is meaningful: both define the metric as the column does
// and, if one is of another system, both use the same correction of the calibration.
bool AreComparable(const RowRuns& row, const RowRuns& reference, const Column& column);

// Throws Error naming both files unless two runs of one scene define a metric in the same way.
void CheckSameMetric(const RunSummary& a, const MetricValue& in_a, const RunSummary& b,
                     const MetricValue& in_b);

// How a metric of a run is computed from its bodies.
struct BodyMetric {
  MetricForm form;

  const MetricEntry& entry() const { return EntryOf(form.id); }
  bool predicted() const { return form.bodies == BodyGroup::kPredicted; }
  bool movers() const { return form.bodies != BodyGroup::kStanding; }
  // Whether the errors of the metric are listed frame by frame.
  bool by_frames() const { return form.id == MetricId::kObjectAte; }
  Within within() const {
    return entry().kind == MetricKind::kCount ? Within::kSum : Within::kMean;
  }
};

// Empty if the metric is not about bodies.
std::optional<BodyMetric> FindBodyMetric(const std::string& metric);

// The bodies of a run from which the metric is computed.
const std::vector<BodyRow>& BodiesOf(const BodyMetric& metric, const RunSummary& run);

// The contribution of a body to the metric. Empty if the metric does not apply to the body or the
// run has no value for it.
std::optional<Part> PartOf(const BodyMetric& metric, const BodyRow& body);

// The contributions of the same body in two runs. Errors that are listed by frame are taken over
// the frames that both runs have.
std::optional<std::pair<Part, Part>> PairOf(const BodyMetric& metric, const BodyRow& body,
                                            const BodyRow& reference);

// Describes in words what PairOf compares.
const char* PairingText(const BodyMetric& metric);

// The runs of a row and of its reference, with the keys that identify rows.
struct PairedRows {
  const std::vector<std::string>& keys;
  const RowRuns& row;
  const RowRuns& reference;
  std::string reference_label;
};

// The mean of a metric over the runs of a row: over seeds, then bodies, then scenes.
Cell MakeCell(const RowRuns& row, const std::vector<std::string>& keys, const Column& column);

// The paired difference of a row to its reference. Empty if the two have nothing in common. Throws
// Error naming both files if two runs of one scene define the metric differently.
std::optional<Difference> MakeDifference(const PairedRows& rows, const Column& column);

// Converts a paired estimate. `reference` is the label of the reference row, `meaning` describes
// the intervals, and `pairing` what the two rows have in common.
Difference DifferenceOf(const PairedEstimate& estimate, const std::string& reference,
                        const std::string& meaning, const std::string& pairing);

// Whether a difference is an improvement. Empty if the metric is unknown.
std::optional<bool> IsBetter(const std::string& metric, double difference);

// "undecided (3 pairs, 6 needed)". `what` is the singular name of the paired units.
std::string UndecidedText(std::size_t pairs, const std::string& what = "pair");

// "better", "worse", "differs", "the same", "not significant" or UndecidedText. Call it after
// CorrectForMany.
std::string VerdictText(const Difference& difference, const std::string& metric,
                        const std::string& what = "pair");

// Corrects the p-values of differences that are read together for their number (Holm), and marks
// those that are distinguishable from noise.
void CorrectForMany(const std::vector<Difference*>& differences);

}  // namespace cvo::reports
