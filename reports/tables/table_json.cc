// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/table_json.h"

#include <cmath>

#include "core/files/json_fields.h"

namespace cvo::reports {
namespace {

double Finite(double value, const std::string& where) {
  if (!std::isfinite(value)) ThrowError(where, StrCat(value), "a finite number");
  return value;
}

Json ToJson(const Column& column) {
  return {{"metric", column.metric},
          {"label", column.label},
          {"unit", column.unit},
          {"contract", cvo::ToJson(column.contract)}};
}

Json ToJson(const SequenceInfo& sequence) {
  return {{"name", sequence.name},     {"type", sequence.type},
          {"pair", sequence.pair},     {"first_frame", sequence.first_frame},
          {"frames", sequence.frames}, {"total_frames", sequence.total_frames}};
}

Json ToJson(const Interval& interval, const std::string& where) {
  return {{"low", Finite(interval.low, where)},
          {"high", Finite(interval.high, where)},
          {"meaning", interval.meaning}};
}

Json ToJson(const Difference& difference, const std::string& where) {
  Json json = {{"reference", difference.reference},
               {"value", Finite(difference.value, where)},
               {"reference_value", Finite(difference.reference_value, where)},
               {"difference", Finite(difference.difference, where)}};
  if (difference.interval) json["interval"] = ToJson(*difference.interval, where);
  if (difference.percent) json["percent"] = Finite(*difference.percent, where);
  if (difference.percent_interval) {
    json["percent_interval"] = ToJson(*difference.percent_interval, where);
  }
  if (difference.reference_lower) {
    json["reference_lower_percent"] = Finite(*difference.reference_lower, where);
  }
  if (difference.reference_lower_interval) {
    json["reference_lower_percent_interval"] = ToJson(*difference.reference_lower_interval, where);
  }
  if (difference.effect) json["effect"] = Finite(*difference.effect, where);
  json["distinguishable"] = difference.distinguishable;
  json["pairs"] = difference.pairs;
  json["pairing"] = difference.pairing;
  return json;
}

Json ToJson(const Cell& cell, const Column& column) {
  Json json = {{"metric", column.metric}, {"status", cell.present ? "ok" : "missing"}};
  if (!cell.present) {
    json["message"] = cell.message;
    return json;
  }
  json["value"] = Finite(cell.value, column.metric);
  json["unit"] = column.unit;
  json["n"] = {{"runs", cell.n.runs},
               {"scenes", cell.n.scenes},
               {"bodies", cell.n.bodies},
               {"seeds", cell.n.seeds}};
  if (cell.interval) json["interval"] = ToJson(*cell.interval, column.metric);
  if (cell.difference) json["difference"] = ToJson(*cell.difference, column.metric);
  if (!cell.left_out.empty()) json["left_out"] = cell.left_out;
  if (!cell.not_comparable.empty()) json["not_comparable"] = cell.not_comparable;
  json["runs"] = cell.runs;
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
  Json json = {{"system", line.system}, {"source", table.sources[line.source].id}};
  if (line.frames > 0) {
    json["first_frame"] = line.first_frame;
    json["frames"] = line.frames;
  }
  json["cells"] = std::move(cells);
  return json;
}

Json ToJson(const JobCounts& jobs) {
  return {{"planned", jobs.planned}, {"done", jobs.done},       {"lost", jobs.lost},
          {"failed", jobs.failed},   {"not_run", jobs.not_run}, {"no_data", jobs.no_data}};
}

Json ToJson(const RunLink& run) {
  return {{"sequence", run.sequence}, {"seed", run.seed}, {"result", run.result}};
}

Json ToJson(const Problem& problem) {
  Json json = {{"row", problem.row},
               {"sequence", problem.sequence},
               {"seed", problem.seed},
               {"state", problem.state},
               {"message", problem.message}};
  if (!problem.log.empty()) json["log"] = problem.log;
  return json;
}

Json ToJson(const ChangedOption& option) {
  Json values = Json::array();
  for (const std::string& value : option.values) values.push_back(ParseJson(value, option.path));
  return {{"path", option.path},
          {"default", option.default_value.empty() ? Json(nullptr)
                                                   : ParseJson(option.default_value, option.path)},
          {"values", values}};
}

Json ToJson(const ReferenceSource& source) {
  return {{"id", source.id},
          {"source", source.source},
          {"kind", source.kind},
          {"caveat", source.caveat}};
}

template <typename T, typename... Context>
Json ListOf(const std::vector<T>& values, const Context&... context) {
  Json list = Json::array();
  for (const T& value : values) list.push_back(ToJson(value, context...));
  return list;
}

Json ToJson(const Row& row, const Table& table) {
  Json json = Json::object();
  for (std::size_t i = 0; i < table.keys.size(); ++i) json["keys"][table.keys[i]] = row.keys[i];
  if (row.sequence) json["sequence"] = ToJson(*row.sequence);
  if (!(row.truth == Contract())) json["truth"] = cvo::ToJson(row.truth);
  if (!row.corrections.empty()) json["corrections"] = row.corrections;
  json["jobs"] = ToJson(row.jobs);
  json["runs"] = ListOf(row.runs);
  json["cells"] = Json::array();
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    json["cells"].push_back(ToJson(row.cells[i], table.columns[i]));
  }
  json["reference"] = ListOf(row.reference, table);
  return json;
}

Json ToJson(const Provenance& provenance) {
  return {{"builds", provenance.builds},
          {"seeds", provenance.seeds},
          {"options", ListOf(provenance.options)}};
}

}  // namespace

std::string TableJson(const Table& table) {
  Json json = {{"schema_version", kTableSchemaVersion},
               {"kind", "table"},
               {"title", table.title},
               {"about", table.about},
               {"reference", table.reference},
               {"keys", table.keys},
               {"columns", ListOf(table.columns)},
               {"rows", Json::array()},
               {"others", ListOf(table.others, table)},
               {"sources", ListOf(table.sources)},
               {"jobs", ToJson(table.jobs)},
               {"problems", ListOf(table.problems)},
               {"notes", table.notes},
               {"provenance", ToJson(table.provenance)}};
  if (table.change) json["change"] = true;
  for (const Row& row : table.rows) json["rows"].push_back(ToJson(row, table));
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace cvo::reports
