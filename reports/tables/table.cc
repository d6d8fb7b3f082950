// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/table.h"

#include <algorithm>
#include <utility>

#include "core/base/lists.h"
#include "core/files/text_file.h"
#include "core/record/metric_catalogue.h"

namespace cvo::reports {
namespace {

// A reference figure in the column of its metric.
struct FigureInFile {
  std::string metric;
  double value = 0.0;
  std::string unit;
  Match comparison = Match::kMatches;
  std::string reason;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("metric", self.metric);
    archive.Field("value", self.value);
    archive.Field("unit", self.unit);
    archive.Field("comparison", self.comparison);
    archive.Optional("reason", self.reason);
  }
};

std::vector<FigureInFile> FiguresOf(const ReferenceRow& line, const Table& table) {
  std::vector<FigureInFile> figures;
  for (std::size_t i = 0; i < line.cells.size(); ++i) {
    if (!line.cells[i]) continue;
    figures.push_back({table.columns[i].metric, line.cells[i]->value, table.columns[i].unit,
                       line.cells[i]->match, line.cells[i]->reason});
  }
  return figures;
}

// The index of the first element whose `member` is this text. Throws Error if there is none;
// `expected` says what the text should be.
template <typename T>
std::size_t IndexOf(const std::string& text, const std::vector<T>& values, std::string T::*member,
                    const std::string& where, const char* expected) {
  const auto found = std::find_if(values.begin(), values.end(),
                                  [&](const T& value) { return value.*member == text; });
  if (found == values.end()) ThrowError(where, Quoted(text), expected);
  return static_cast<std::size_t>(found - values.begin());
}

void CheckCell(const Cell& cell, const Row& row, const std::string& metric,
               const std::string& where) {
  if (cell.present) CheckPossible(metric, cell.value, where);
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

void CheckCells(const Table& table, const std::string& where) {
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const Row& row = table.rows[i];
    for (std::size_t j = 0; j < row.cells.size(); ++j) {
      CheckCell(row.cells[j], row, table.columns[j].metric,
                StrCat(where, ", rows[", i, "], cells[", j, "]"));
    }
  }
}

}  // namespace

template <typename Self, typename Archive>
void Cell::VisitFields(Self& self, Archive& archive, const Column& column) {
  archive.Constant("metric", column.metric);
  archive.Flag("status", self.present, "missing", "ok");
  if (!self.present) {
    archive.Field("message", self.message);
    return;
  }
  archive.Field("value", self.value);
  archive.Constant("unit", column.unit);
  archive.Field("n", self.n);
  archive.Optional("interval", self.interval);
  archive.Optional("difference", self.difference);
  archive.Optional("left_out", self.left_out);
  archive.Optional("not_comparable", self.not_comparable);
  archive.Field("runs", self.runs);
}

template <typename Self, typename Archive>
void ReferenceRow::VisitFields(Self& self, Archive& archive, const Table& table) {
  std::string source;
  std::vector<FigureInFile> figures;
  if constexpr (!Archive::kReads) {
    source = table.sources[self.source].id;
    figures = FiguresOf(self, table);
  }
  archive.Field("system", self.system);
  archive.Field("source", source);
  if (archive.Has("frames", self.frames > 0)) {
    archive.Field("first_frame", self.first_frame);
    archive.Field("frames", self.frames);
  }
  archive.Field("cells", figures);
  if constexpr (Archive::kReads) {
    self.source = IndexOf(source, table.sources, &ReferenceSource::id,
                          archive.where() + ", field source", "the id of one of the sources");
    self.cells.resize(table.columns.size());
    for (const FigureInFile& figure : figures) {
      self.cells[IndexOf(figure.metric, table.columns, &Column::metric,
                         archive.where() + ", cells, field metric", "the metric of a column")] =
          ReferenceCell{figure.value, figure.comparison, figure.reason};
    }
  }
}

template <typename Self, typename Archive>
void Row::VisitFields(Self& self, Archive& archive, const Table& table) {
  archive.Named("keys", self.keys, table.keys);
  archive.Optional("sequence", self.sequence);
  archive.Optional("truth", self.truth);
  archive.Optional("corrections", self.corrections);
  archive.Optional("split", self.split);
  archive.Field("jobs", self.jobs);
  archive.Field("runs", self.runs);
  archive.Each("cells", self.cells, table.columns);
  archive.Field("reference", self.reference, table);
}

template <typename Self, typename Archive>
void ChangedOption::VisitFields(Self& self, Archive& archive) {
  archive.Field("path", self.path);
  Json default_value;
  std::vector<Json> values;
  if constexpr (!Archive::kReads) {
    if (!self.default_value.empty()) default_value = ParseJson(self.default_value, self.path);
    for (const std::string& value : self.values) values.push_back(ParseJson(value, self.path));
  }
  archive.Field("default", default_value);
  archive.Field("values", values);
  if constexpr (Archive::kReads) {
    if (!default_value.is_null()) self.default_value = default_value.dump();
    for (const Json& value : values) self.values.push_back(value.dump());
  }
}

template <typename Self, typename Archive>
void Table::VisitFields(Self& self, Archive& archive) {
  archive.Field("title", self.title);
  archive.Field("about", self.about);
  archive.Field("reference", self.reference);
  archive.Field("keys", self.keys);
  archive.Field("columns", self.columns);
  if constexpr (Archive::kReads) archive.Field("sources", self.sources);  // rows refer to them
  archive.Field("rows", self.rows, self);
  archive.Field("others", self.others, self);
  archive.Field("sources", self.sources);
  archive.Field("jobs", self.jobs);
  archive.Field("problems", self.problems);
  archive.Field("notes", self.notes);
  archive.Field("provenance", self.provenance);
  archive.Optional("change", self.change);
}

std::string RowLabel(const Row& row) { return Joined(row.keys, " "); }

std::string FrameRange(int first, int count) { return StrCat(first, ":", first + count); }

std::string TableJson(const Table& table) { return FileText(table); }

Table ReadTable(std::string_view json, const std::string& where) {
  const auto table = ReadRecord<Table>(ParseJson(json, where), where);
  CheckCells(table, where);
  return table;
}

}  // namespace cvo::reports
