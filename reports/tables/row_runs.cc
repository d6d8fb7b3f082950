// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/row_runs.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/lists.h"

namespace cvo::reports {
namespace {

bool Contains(const std::vector<std::string>& keys, const std::string& key) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
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
  return StrCat(KeyOf(run.planned, "sequence"), " ", sequence.pair, " ", sequence.first_frame, ":",
                sequence.first_frame + sequence.frames);
}

std::string RepetitionOf(const SuiteRun& run, const std::vector<std::string>& keys) {
  std::string repetition = StrCat("seed ", run.planned.seed);
  for (const auto& [key, value] : run.planned.keys) {
    if (key != "sequence" && !Contains(keys, key)) repetition += StrCat(" ", key, "=", value);
  }
  return repetition;
}

namespace {

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

}  // namespace

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

}  // namespace cvo::reports
