// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/record/metric_catalogue.h"
#include "reports/tables/cells.h"

namespace cvo::reports {
namespace {

bool Contains(const std::vector<std::string>& keys, const std::string& key) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

// The last row before this one, of the same sequence if the rows have that key.
const RowRuns* FindRowAbove(const std::vector<RowRuns>& rows, const RowRuns& row,
                            const std::vector<std::string>& keys) {
  const auto at =
      static_cast<std::size_t>(std::find(keys.begin(), keys.end(), "sequence") - keys.begin());
  const RowRuns* above = nullptr;
  for (const RowRuns& other : rows) {
    if (other.keys == row.keys) break;
    if (at == keys.size() || other.keys[at] == row.keys[at]) above = &other;
  }
  return above;
}

Contract SharedContract(const RunSummary& run, const MetricValue& metric) {
  return ColumnContract(metric.contract, run.sequence.range());
}

// The first thing that two runs state differently about a metric, with what each states.
struct Differing {
  std::string field;  // "unit" or a field of the contract; empty: nothing
  std::string in_a;
  std::string in_b;
};
Differing CompareMeaning(const std::string& unit_a, const Contract& a, const std::string& unit_b,
                         const Contract& b) {
  if (unit_a != unit_b) return {"unit", unit_a, unit_b};
  const std::string field = FirstDifference(a, b);
  return field.empty() ? Differing() : Differing{field, FieldText(a, field), FieldText(b, field)};
}

// The column, if runs of our own or of other `systems` have a value for it. Their contracts must be
// the same; the truth, too, within one type of dataset.
std::optional<Column> MakeColumn(const std::string& name, const std::vector<SuiteRun>& runs,
                                 bool systems) {
  using Meaning = std::pair<const RunSummary*, const MetricValue*>;
  std::optional<Meaning> first;
  std::map<std::string, Meaning> of_type;
  for (const SuiteRun& suite_run : runs) {
    if (!suite_run.run || suite_run.planned.system.empty() == systems) continue;
    const RunSummary& run = *suite_run.run;
    const MetricValue* metric = FindMetric(run, name);
    if (metric == nullptr) continue;
    if (!first) first = {&run, metric};
    const Meaning& alike =
        of_type.try_emplace(run.sequence.type, Meaning{&run, metric}).first->second;
    for (const auto& [other, with_truth] : {std::pair{*first, false}, std::pair{alike, true}}) {
      const auto contract_of = [&, with_truth = with_truth](const Meaning& meaning) {
        const Contract contract = SharedContract(*meaning.first, *meaning.second);
        return with_truth ? WithTruthOf(contract, meaning.second->contract) : contract;
      };
      const Differing differing = CompareMeaning(NameOf(other.second->unit), contract_of(other),
                                                 NameOf(metric->unit), contract_of({&run, metric}));
      if (differing.field.empty()) continue;
      ThrowError("metric " + name,
                 StrCat(other.first->file.string(), " with ", differing.field, " \"",
                        differing.in_a, "\" and ", run.file.string(), " with ", differing.field,
                        " \"", differing.in_b, "\""),
                 "one unit and contract in a table");
    }
  }
  if (!first) return std::nullopt;
  return Column{name, MetricLabel(name), NameOf(first->second->unit),
                SharedContract(*first->first, *first->second)};
}

}  // namespace

std::vector<RowRuns> GroupRuns(const std::vector<SuiteRun>& runs,
                               const std::vector<std::string>& keys) {
  std::vector<RowRuns> rows;
  std::map<std::vector<std::string>, std::size_t> index;
  for (const SuiteRun& run : runs) {
    std::vector<std::string> values;
    for (const std::string& key : keys) values.push_back(KeyOf(run.planned, key));
    const auto [found, is_new] = index.try_emplace(values, rows.size());
    if (is_new) rows.push_back({values, {}});
    rows[found->second].runs.push_back(&run);
  }
  return rows;
}

std::string SceneOf(const SuiteRun& run) {
  const SequenceInfo& sequence = run.run->sequence;
  return StrCat(KeyOf(run.planned, "sequence"), " ", sequence.pair, " ",
                FrameRange(sequence.first_frame, sequence.frames));
}

std::string RepetitionOf(const SuiteRun& run, const std::vector<std::string>& keys) {
  std::string repetition = StrCat("seed ", run.planned.seed);
  for (const auto& [key, value] : run.planned.keys) {
    if (key != "sequence" && !Contains(keys, key)) repetition += StrCat(" ", key, "=", value);
  }
  return repetition;
}

const RowRuns* FindReference(const std::vector<RowRuns>& rows, const RowRuns& row,
                             const std::vector<std::string>& keys, const std::string& reference) {
  if (reference.empty()) return nullptr;
  if (reference == kRowAbove) return FindRowAbove(rows, row, keys);
  const std::size_t equals = reference.find('=');
  std::vector<std::string> wanted = row.keys;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i] == reference.substr(0, equals)) wanted[i] = reference.substr(equals + 1);
  }
  if (wanted == row.keys) return nullptr;
  return FindBy(rows, &RowRuns::keys, wanted);
}

std::string FullReference(const SuitePlan& plan) {
  if (plan.reference.empty() || plan.reference == kRowAbove) return plan.reference;
  const std::size_t equals = plan.reference.find('=');
  const bool is_full = equals != std::string::npos;
  const std::string key = is_full ? plan.reference.substr(0, equals) : "variant";
  if (!Contains(plan.rows, key)) {
    ThrowError(plan.file.string() + ", table, reference", plan.reference,
               "a value of one of the rows' keys");
  }
  return is_full ? plan.reference : "variant=" + plan.reference;
}

std::vector<std::string> PooledKeys(const std::vector<RowRuns>& rows,
                                    const std::vector<std::string>& keys) {
  std::set<std::string> others;
  for (const RowRuns& row : rows) {
    for (const SuiteRun* run : row.runs) {
      for (const auto& [key, value] : run->planned.keys) {
        if (key != "sequence" && !Contains(keys, key)) others.insert(key);
      }
    }
  }
  std::vector<std::string> texts;
  for (const std::string& key : others) {
    std::vector<std::string> pooled;
    for (const RowRuns& row : rows) {
      std::vector<std::string> of_row;
      for (const SuiteRun* run : row.runs) AddOnce(KeyOf(run->planned, key), of_row);
      if (of_row.size() < 2) continue;
      for (const std::string& value : of_row) AddOnce(value, pooled);
    }
    if (!pooled.empty()) texts.push_back(key + ": " + Joined(pooled, ", "));
  }
  return texts;
}

std::vector<std::string> WithCoverage(const std::vector<std::string>& metrics) {
  std::vector<std::string> all;
  for (const std::string& metric : metrics) {
    const std::string coverage = CoverageOf(metric);
    if (!coverage.empty() && !Contains(metrics, coverage)) AddOnce(coverage, all);
    AddOnce(metric, all);
  }
  return all;
}

std::vector<Column> MakeColumns(const std::vector<std::string>& metrics,
                                const std::vector<SuiteRun>& runs) {
  std::vector<Column> columns;
  for (const std::string& name : metrics) {
    std::optional<Column> column = MakeColumn(name, runs, false);
    if (!column) column = MakeColumn(name, runs, true);
    if (column) columns.push_back(std::move(*column));
  }
  return columns;
}

std::string DifferingMeaning(const RowRuns& row, const Column& column) {
  for (const SuiteRun* run : row.runs) {
    const MetricValue* metric = run->run ? FindMetric(*run->run, column.metric) : nullptr;
    if (metric == nullptr) continue;
    const Differing differing = CompareMeaning(column.unit, column.contract, NameOf(metric->unit),
                                               SharedContract(*run->run, *metric));
    if (differing.field.empty()) return "";
    return StrCat(differing.field, " \"", differing.in_b, "\"");
  }
  return "";
}

bool AreComparable(const RowRuns& row, const RowRuns& reference, const Column& column) {
  std::set<double> shifts_px;
  bool systems = false;
  for (const RowRuns* runs : {&row, &reference}) {
    for (const SuiteRun* run : runs->runs) {
      if (run->run) shifts_px.insert(run->run->sequence.camera.right_shift_px);
      systems = systems || !run->planned.system.empty();
    }
  }
  return DifferingMeaning(row, column).empty() && DifferingMeaning(reference, column).empty() &&
         (!systems || shifts_px.size() <= 1);
}

}  // namespace cvo::reports
