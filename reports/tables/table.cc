// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/table.h"

#include <utility>

#include "core/base/lists.h"
#include "core/files/text_file.h"
#include "core/record/metric_catalogue.h"

namespace cvo::reports {
namespace {

void CheckCell(const Cell& cell, const Row& row, const std::string& metric,
               const std::string& where) {
  if (cell.value) CheckPossible(metric, *cell.value, where);
  if (cell.interval) {  // the interval of a mean may exceed the range of possible values
    const auto [low, high] = std::pair(cell.interval->low, cell.interval->high);
    for (const double end : {low, high}) CheckPossible("interval", end, where + ", " + metric);
    if (!(low <= high)) {
      ThrowError(StrCat(where, ", ", metric, ", interval"), StrCat(low, " to ", high),
                 "low <= high");
    }
  }
  for (const std::size_t run : cell.runs) {
    if (run < row.runs.size()) continue;
    ThrowError(where + ", field runs", StrCat(run),
               StrCat("indices of the row's ", row.runs.size(), " runs"));
  }
}

void CheckSize(std::size_t size, std::size_t expected, const std::string& where) {
  if (size != expected) ThrowError(where, StrCat(size, " elements"), StrCat(expected));
}

void CheckSources(const std::vector<ReferenceRow>& rows, const Table& table,
                  const std::string& where) {
  for (const ReferenceRow& row : rows) {
    if (FindBy(table.sources, &ReferenceSource::id, row.source) != nullptr) continue;
    ThrowError(where + ", field source", Quoted(row.source), "the id of one of the sources");
  }
}

void CheckRows(const Table& table, const std::string& where) {
  CheckSources(table.others, table, where + ", others");
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const Row& row = table.rows[i];
    const std::string of_row = StrCat(where, ", rows[", i, "]");
    CheckSize(row.keys.size(), table.keys.size(), of_row + ", keys");
    CheckSize(row.cells.size(), table.columns.size(), of_row + ", cells");
    CheckSources(row.reference, table, of_row + ", reference");
    for (std::size_t j = 0; j < row.cells.size(); ++j) {
      CheckCell(row.cells[j], row, table.columns[j].metric, StrCat(of_row, ", cells[", j, "]"));
    }
  }
}

}  // namespace

std::string RowLabel(const Row& row) { return Joined(row.keys, " "); }

std::string FrameRange(int first, int count) { return StrCat(first, ":", first + count); }

std::string TableJson(const Table& table) { return FileText(table); }

Table ReadTable(std::string_view json, const std::string& where) {
  const auto table = ReadRecord<Table>(ParseJson(json, where), where);
  CheckRows(table, where);
  return table;
}

}  // namespace cvo::reports
