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
  const RowRuns* above = nullptr;
  for (const RowRuns& other : rows) {
    if (&other == &row || other.keys == row.keys) break;
    bool is_alike = true;
    for (std::size_t i = 0; i < keys.size(); ++i) {
      is_alike = is_alike && (keys[i] != "sequence" || other.keys[i] == row.keys[i]);
    }
    if (is_alike) above = &other;
  }
  return above;
}

Contract SharedContract(const RunSummary& run, const MetricValue& metric) {
  return ColumnContract(metric.contract, run.sequence.range());
}

struct Meaning {
  const RunSummary* run;
  const MetricValue* metric;
  Contract contract;
};

void CheckSame(const Meaning& a, const Meaning& b) {
  const auto refuse = [&](const std::string& field, const std::string& in_a,
                          const std::string& in_b) {
    ThrowError("metric " + a.metric->name,
               StrCat(a.run->file.string(), " with ", field, " \"", in_a, "\" and ",
                      b.run->file.string(), " with ", field, " \"", in_b, "\""),
               StrCat("one ", field == "unit" ? "unit" : "contract", " in a table"));
  };
  const std::string field = FirstDifference(a.contract, b.contract);
  if (!field.empty()) {
    refuse(field, FieldText(a.contract, field), FieldText(b.contract, field));
  }
  if (a.metric->unit != b.metric->unit) {
    refuse("unit", NameOf(a.metric->unit), NameOf(b.metric->unit));
  }
}

Meaning WithTruth(Meaning meaning) {
  meaning.contract = WithTruthOf(meaning.contract, meaning.metric->contract);
  return meaning;
}

std::optional<Column> MakeColumn(const std::string& name, const std::vector<SuiteRun>& runs,
                                 bool systems) {
  std::vector<Meaning> kinds;  // the first run, then the first of each other type of dataset
  for (const SuiteRun& run : runs) {
    const MetricValue* metric = run.run ? FindMetric(*run.run, name) : nullptr;
    if (metric == nullptr || run.planned.system.empty() == systems) continue;
    const Meaning meaning{&*run.run, metric, SharedContract(*run.run, *metric)};
    if (!kinds.empty()) CheckSame(kinds[0], meaning);
    const auto same_type = std::find_if(kinds.begin(), kinds.end(), [&](const Meaning& kind) {
      return kind.run->sequence.type == meaning.run->sequence.type;
    });
    if (same_type == kinds.end()) {
      kinds.push_back(meaning);
    } else {
      CheckSame(WithTruth(*same_type), WithTruth(meaning));
    }
  }
  if (kinds.empty()) return std::nullopt;
  return Column{name, MetricLabel(name), NameOf(kinds[0].metric->unit), kinds[0].contract};
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

std::vector<std::string> PooledKeys(const std::vector<SuiteRun>& runs,
                                    const std::vector<std::string>& keys) {
  std::map<std::string, std::vector<std::string>> pooled;
  for (const SuiteRun& run : runs) {
    for (const auto& [key, value] : run.planned.keys) {
      if (key != "sequence" && !Contains(keys, key)) pooled[key];
    }
  }
  std::vector<std::string> texts;
  for (auto& [key, values] : pooled) {
    for (const SuiteRun& run : runs) AddOnce(KeyOf(run.planned, key), values);
    if (values.size() > 1) texts.push_back(key + ": " + Joined(values, ", "));
  }
  return texts;
}

std::vector<std::string> WithCoverage(const std::vector<std::string>& metrics) {
  std::vector<std::string> all;
  const auto has = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const std::string& metric : metrics) {
    const std::string coverage = CoverageOf(metric);
    if (!coverage.empty() && !has(metrics, coverage) && !has(all, coverage)) {
      all.push_back(coverage);
    }
    if (!has(all, metric)) all.push_back(metric);
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
    const Contract contract = SharedContract(*run->run, *metric);
    const std::string field =
        NameOf(metric->unit) != column.unit ? "unit" : FirstDifference(column.contract, contract);
    if (field.empty()) return "";
    return StrCat(field, " \"", field == "unit" ? NameOf(metric->unit) : FieldText(contract, field),
                  "\"");
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
