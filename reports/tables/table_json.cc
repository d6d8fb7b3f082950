// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/table_json.h"

#include <cmath>

#include "reports/tables/json_fields.h"

namespace cvo::reports {
namespace {

double Finite(double value, const std::string& where) {
  if (!std::isfinite(value)) ThrowError(where, StrCat(value), "a finite number");
  return value;
}

Json ToJson(const Contract& contract) {
  Json json = Json::object();
  for (const auto& [field, value] : contract) json[field] = value;
  return json;
}

Json ToJson(const Column& column) {
  return {{"metric", column.metric},
          {"label", column.label},
          {"unit", column.unit},
          {"contract", ToJson(column.contract)}};
}

Json ToJson(const SequenceInfo& sequence) {
  return {{"name", sequence.name},     {"type", sequence.type},
          {"pair", sequence.pair},     {"first_frame", sequence.first_frame},
          {"frames", sequence.frames}, {"total_frames", sequence.total_frames}};
}

Json ToJson(const Cell& cell, const Column& column, const std::vector<std::string>& links) {
  Json json = {{"metric", column.metric}, {"status", cell.present ? "ok" : "missing"}};
  if (!cell.present) {
    json["message"] = cell.message;
    return json;
  }
  json["value"] = Finite(cell.value, column.metric);
  json["unit"] = column.unit;
  json["n"] = cell.n;
  if (cell.interval) {
    json["interval"] = {{"low", Finite(cell.interval->low, column.metric)},
                        {"high", Finite(cell.interval->high, column.metric)},
                        {"meaning", cell.interval->meaning}};
  }
  json["left_out"] = cell.left_out;
  json["links"] = links;
  return json;
}

Json ToJson(const ReferenceRow& line, const Table& table) {
  Json cells = Json::array();
  for (std::size_t i = 0; i < line.cells.size(); ++i) {
    if (!line.cells[i]) continue;
    Json cell = {{"metric", table.columns[i].metric},
                 {"value", Finite(line.cells[i]->value, table.columns[i].metric)},
                 {"unit", table.columns[i].unit},
                 {"comparison", ToString(line.cells[i]->match)}};
    if (!line.cells[i]->reason.empty()) cell["reason"] = line.cells[i]->reason;
    cells.push_back(std::move(cell));
  }
  return {{"system", line.system},
          {"source", table.sources[line.source].id},
          {"first_frame", line.first_frame},
          {"frames", line.frames},
          {"cells", cells}};
}

Json ToJson(const Row& row, const Table& table) {
  Json json = {{"sequence", ToJson(row.sequence)},
               {"variant", row.variant},
               {"seeds", row.seeds},
               {"truth", row.truth},
               {"status", row.status},
               {"message", row.message},
               {"results", row.links}};
  json["cells"] = Json::array();
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    json["cells"].push_back(ToJson(row.cells[i], table.columns[i], row.links));
  }
  json["reference"] = Json::array();
  for (const ReferenceRow& line : row.reference) json["reference"].push_back(ToJson(line, table));
  return json;
}

Json ToJson(const ReferenceSource& source) {
  return {{"id", source.id},
          {"source", source.source},
          {"kind", source.kind},
          {"caveat", source.caveat}};
}

}  // namespace

std::string TableJson(const Table& table) {
  Json json = {{"schema_version", kTableSchemaVersion}, {"kind", "table"}, {"title", table.title}};
  for (const char* list : {"columns", "rows", "sources", "notes"}) json[list] = Json::array();
  for (const Column& column : table.columns) json["columns"].push_back(ToJson(column));
  for (const Row& row : table.rows) json["rows"].push_back(ToJson(row, table));
  for (const ReferenceSource& source : table.sources) json["sources"].push_back(ToJson(source));
  for (const std::string& note : table.notes) json["notes"].push_back(note);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace cvo::reports
