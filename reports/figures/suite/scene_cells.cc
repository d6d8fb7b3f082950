// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figures/suite/scene_cells.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/figures/suite/swept_lines.h"
#include "reports/tables/cells.h"
#include "reports/tables/columns.h"
#include "reports/tables/comparisons.h"

namespace cvo::reports {
namespace {

std::string ValueOf(const std::vector<std::string>& keys, const std::vector<std::string>& values,
                    const std::string& key) {
  const auto found = std::find(keys.begin(), keys.end(), key);
  return found == keys.end() ? "" : values[static_cast<std::size_t>(found - keys.begin())];
}

// Describes what identifies a row apart from its sequence: label, name and option values.
SeriesRows Describe(const std::vector<std::string>& keys, const std::vector<std::string>& values) {
  SeriesRows series;
  const auto add = [](const std::string& text, std::string& list) {
    list += StrCat(list.empty() ? "" : ", ", text);
  };
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i] == "sequence" || keys[i] == "family") continue;
    const bool option = IsOption(keys[i]);
    add(option ? keys[i] + " " + values[i] : values[i], series.label);
    add(values[i], option ? series.options : series.name);
  }
  return series;
}

// The keys of the table, and the sequence.
std::vector<std::string> KeysByScene(const Table& table) {
  std::vector<std::string> keys = table.keys;
  if (std::find(keys.begin(), keys.end(), "sequence") == keys.end()) keys.emplace_back("sequence");
  return keys;
}

std::vector<Cell> CellsOf(const RowRuns& row, const RowRuns* reference,
                          const std::vector<std::string>& keys, const Table& table) {
  std::vector<Cell> cells;
  for (const Column& column : table.columns) {
    Cell cell = MakeCell(row, keys, column);
    if (reference != nullptr && cell.present && AreComparable(row, *reference, column)) {
      cell.difference = MakeDifference({keys, row, *reference, table.reference}, column);
    }
    cells.push_back(std::move(cell));
  }
  return cells;
}

}  // namespace

std::size_t CountSceneRows(const SuiteData& data) {
  return GroupRuns(data.runs, KeysByScene(data.table)).size();
}

std::vector<SeriesRows> SplitByScene(const SuiteData& data) {
  const std::vector<std::string> keys = KeysByScene(data.table);
  const bool by_sequence = keys.size() == data.table.keys.size();
  SuitePlan plan = data.plan;
  plan.rows = keys;
  const std::string reference = FullReference(plan);
  const std::vector<RowRuns> rows = GroupRuns(data.runs, keys);
  std::vector<SeriesRows> series;
  for (const RowRuns& row : rows) {
    SeriesRows described = Describe(keys, row.keys);
    if (described.name.empty()) described.name = OneVariant(data.plan);
    FindOrAdd(series, &SeriesRows::label, std::move(described))
        .scenes.push_back(
            {ValueOf(keys, row.keys, "sequence"),
             CellsOf(row, FindReference(rows, row, keys, reference), keys, data.table)});
  }
  std::vector<Difference*> differences;
  for (SeriesRows& known : series) {
    for (SceneRow& scene : known.scenes) {
      for (Cell& cell : scene.cells) {
        if (cell.difference) differences.push_back(&*cell.difference);
      }
    }
  }
  CorrectForMany(differences);
  for (const Row& row : data.table.rows) {
    if (by_sequence) break;
    const std::string label = Describe(data.table.keys, row.keys).label;
    for (SeriesRows& known : series) {
      if (known.label == label) known.all = &row;
    }
  }
  return series;
}

}  // namespace cvo::reports
