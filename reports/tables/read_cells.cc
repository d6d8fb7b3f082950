// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/read_cells.h"

#include <algorithm>
#include <array>

namespace cvo::reports {
namespace {

constexpr std::array kMatches = {Match::kMatches,         Match::kOtherScenes,
                                 Match::kOtherFrames,     Match::kOtherImages,
                                 Match::kContractUnknown, Match::kContractDiffers};

Interval ReadInterval(const Fields& fields) {
  return {fields.Number("low"), fields.Number("high"), fields.Text("meaning")};
}

std::optional<Interval> OptionalInterval(const Fields& fields, const char* key) {
  if (!fields.Has(key)) return std::nullopt;
  return ReadInterval(fields.Object(key));
}

std::optional<double> OptionalNumber(const Fields& fields, const char* key) {
  if (!fields.Has(key)) return std::nullopt;
  return fields.Number(key);
}

Difference ReadDifference(const Fields& fields) {
  Difference difference;
  difference.reference = fields.Text("reference");
  difference.value = fields.Number("value");
  difference.reference_value = fields.Number("reference_value");
  difference.difference = fields.Number("difference");
  difference.interval = OptionalInterval(fields, "interval");
  difference.percent = OptionalNumber(fields, "percent");
  difference.percent_interval = OptionalInterval(fields, "percent_interval");
  difference.reference_lower = OptionalNumber(fields, "reference_lower_percent");
  difference.reference_lower_interval =
      OptionalInterval(fields, "reference_lower_percent_interval");
  difference.effect = OptionalNumber(fields, "effect");
  difference.distinguishable = fields.Bool("distinguishable");
  difference.pairs = fields.Count("pairs");
  difference.pairing = fields.Text("pairing");
  return difference;
}

void CheckText(const Fields& fields, const char* key, const std::string& expected) {
  const std::string found = fields.Text(key);
  if (found != expected) {
    ThrowError(StrCat(fields.where(), ", field ", key), found, expected + " as its column says");
  }
}

// Indices into the runs of the row.
std::vector<std::size_t> ReadRunIndices(const Fields& fields, std::size_t runs) {
  const std::vector<std::uint64_t> indices = fields.Counts("runs");
  for (const std::uint64_t index : indices) {
    if (index >= runs) {
      ThrowError(fields.where() + ", field runs", StrCat(index),
                 StrCat("indices of the row's ", runs, " runs"));
    }
  }
  return {indices.begin(), indices.end()};
}

Match ReadMatch(const Fields& fields) {
  const std::string text = fields.Text("comparison");
  const auto found = std::find_if(kMatches.begin(), kMatches.end(),
                                  [&](Match match) { return text == ToString(match); });
  if (found == kMatches.end()) {
    ThrowError(fields.where() + ", field comparison", text, "\"matches\" or why it does not");
  }
  return *found;
}

}  // namespace

Cell ReadCell(const Fields& fields, const Column& column, std::size_t runs) {
  CheckText(fields, "metric", column.metric);
  Cell cell;
  if (const std::string status = fields.Text("status"); status != "ok") {
    if (status != "missing") {
      ThrowError(fields.where() + ", field status", status, "ok or missing");
    }
    cell.message = fields.Text("message");
    return cell;
  }
  CheckText(fields, "unit", column.unit);
  cell.present = true;
  cell.value = fields.Number("value");
  const Fields n = fields.Object("n");
  cell.n = {n.Count("runs"), n.Count("scenes"), n.Count("bodies"), n.Count("seeds")};
  cell.interval = OptionalInterval(fields, "interval");
  if (fields.Has("difference")) cell.difference = ReadDifference(fields.Object("difference"));
  cell.left_out = fields.TextOr("left_out", "");
  cell.not_comparable = fields.TextOr("not_comparable", "");
  cell.runs = ReadRunIndices(fields, runs);
  return cell;
}

ReferenceRow ReadReferenceRow(const Fields& fields, const std::vector<Column>& columns,
                              const std::vector<ReferenceSource>& sources) {
  ReferenceRow line;
  line.system = fields.Text("system");
  const std::string id = fields.Text("source");
  const auto source = std::find_if(sources.begin(), sources.end(),
                                   [&](const ReferenceSource& other) { return other.id == id; });
  if (source == sources.end()) {
    ThrowError(fields.where() + ", field source", id, "the id of one of the sources");
  }
  line.source = static_cast<std::size_t>(source - sources.begin());
  if (fields.Has("frames")) {
    line.first_frame = static_cast<int>(fields.Integer("first_frame"));
    line.frames = static_cast<int>(fields.Integer("frames"));
  }
  line.cells.resize(columns.size());
  for (const Json& json : fields.Array("cells")) {
    const Fields cell(json, fields.where() + ", cells");
    const std::string metric = cell.Text("metric");
    const auto column = std::find_if(columns.begin(), columns.end(),
                                     [&](const Column& other) { return other.metric == metric; });
    if (column == columns.end()) {
      ThrowError(cell.where() + ", field metric", metric, "the metric of a column");
    }
    line.cells[static_cast<std::size_t>(column - columns.begin())] = ReferenceCell{
        cell.Number("value"), ReadMatch(cell), cell.Has("reason") ? cell.Text("reason") : ""};
  }
  return line;
}

}  // namespace cvo::reports
