// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/read_table.h"

#include <algorithm>
#include <array>

#include "core/files/json_fields.h"
#include "core/files/text_file.h"
#include "reports/tables/read_cells.h"
#include "reports/tables/table_json.h"

namespace cvo::reports {
namespace {

// Each element of an array, told by its place for errors.
template <typename Read>
void ForEach(const Fields& fields, const char* key, const Read& read) {
  std::size_t index = 0;
  for (const Json& element : fields.Array(key)) {
    read(Fields(element, StrCat(fields.where(), ", ", key, "[", index, "]")));
    ++index;
  }
}

Column ReadColumn(const Fields& fields) {
  Column column;
  column.metric = fields.Text("metric");
  column.label = fields.Text("label");
  column.unit = fields.Text("unit");
  column.contract =
      FromJson<Contract>(fields.Object("contract").json(), fields.where() + ", contract");
  return column;
}

SequenceInfo ReadSequence(const Fields& fields) {
  SequenceInfo sequence;
  sequence.name = fields.Text("name");
  sequence.type = fields.Text("type");
  sequence.pair = fields.Text("pair");
  sequence.first_frame = static_cast<int>(fields.Integer("first_frame"));
  sequence.frames = static_cast<int>(fields.Integer("frames"));
  sequence.total_frames = static_cast<int>(fields.Integer("total_frames"));
  return sequence;
}

JobCounts ReadJobs(const Fields& fields) {
  JobCounts jobs;
  jobs.planned = fields.Count("planned");
  jobs.done = fields.Count("done");
  jobs.lost = fields.Count("lost");
  jobs.failed = fields.Count("failed");
  jobs.not_run = fields.Count("not_run");
  jobs.no_data = fields.Count("no_data");
  return jobs;
}

Problem ReadProblem(const Fields& fields) {
  Problem problem;
  problem.row = fields.Text("row");
  problem.sequence = fields.Text("sequence");
  problem.seed = fields.Count("seed");
  problem.state = fields.Text("state");
  problem.message = fields.Text("message");
  problem.log = fields.TextOr("log", "");
  return problem;
}

ReferenceSource ReadSource(const Fields& fields) {
  return {fields.Text("id"), fields.Text("source"), fields.Text("kind"), fields.Text("caveat"), ""};
}

ChangedOption ReadOption(const Fields& fields) {
  ChangedOption option;
  option.path = fields.Text("path");
  if (!fields.Has("default")) ThrowError(fields.where() + ", field default", "nothing", "a value");
  const Json& value = fields.json()["default"];
  if (!value.is_null()) option.default_value = value.dump();
  for (const Json& other : fields.Array("values")) option.values.push_back(other.dump());
  return option;
}

Provenance ReadProvenance(const Fields& fields) {
  Provenance provenance;
  provenance.builds = fields.Texts("builds");
  provenance.seeds = fields.Counts("seeds");
  ForEach(fields, "options",
          [&](const Fields& option) { provenance.options.push_back(ReadOption(option)); });
  return provenance;
}

Row ReadRow(const Fields& fields, const Table& table) {
  Row row;
  for (const std::string& key : table.keys) {
    row.keys.push_back(fields.Object("keys").Text(key.c_str()));
  }
  if (fields.Has("sequence")) row.sequence = ReadSequence(fields.Object("sequence"));
  if (fields.Has("truth")) {
    row.truth = FromJson<Contract>(fields.Object("truth").json(), fields.where() + ", truth");
  }
  row.corrections = fields.TextOr("corrections", "");
  row.jobs = ReadJobs(fields.Object("jobs"));
  ForEach(fields, "runs", [&](const Fields& run) {
    row.runs.push_back({run.Text("sequence"), run.Count("seed"), run.Text("result")});
  });
  ForEach(fields, "cells", [&](const Fields& cell) {
    if (row.cells.size() == table.columns.size()) {
      ThrowError(cell.where(), "one cell more", StrCat(table.columns.size(), ", one per column"));
    }
    row.cells.push_back(ReadCell(cell, table.columns[row.cells.size()], row.runs.size()));
  });
  if (row.cells.size() != table.columns.size()) {
    ThrowError(fields.where(), StrCat(row.cells.size(), " cells"),
               StrCat(table.columns.size(), ", one per column"));
  }
  ForEach(fields, "reference", [&](const Fields& line) {
    row.reference.push_back(ReadReferenceRow(line, table.columns, table.sources));
  });
  return row;
}

void CheckKind(const Fields& fields) {
  if (!fields.Has("schema_version") || !fields.Has("kind")) {
    ThrowError(fields.where(), "JSON without schema_version and kind", "a table.json");
  }
  if (const std::string kind = fields.Text("kind"); kind != "table") {
    ThrowError(fields.where(), StrCat("kind \"", kind, "\""), "kind \"table\", as in table.json");
  }
  fields.CheckSchema(kTableSchemaVersion);
}

}  // namespace

Table ReadTable(std::string_view json, const std::string& where) {
  const Json parsed = ParseJson(json, where);
  const Fields fields(parsed, where);
  CheckKind(fields);
  Table table;
  table.title = fields.Text("title");
  table.about = fields.Text("about");
  table.reference = fields.Text("reference");
  table.change = fields.Has("change") && fields.Bool("change");
  table.keys = fields.Texts("keys");
  ForEach(fields, "columns",
          [&](const Fields& column) { table.columns.push_back(ReadColumn(column)); });
  ForEach(fields, "sources",
          [&](const Fields& source) { table.sources.push_back(ReadSource(source)); });
  ForEach(fields, "rows", [&](const Fields& row) { table.rows.push_back(ReadRow(row, table)); });
  ForEach(fields, "others", [&](const Fields& line) {
    table.others.push_back(ReadReferenceRow(line, table.columns, table.sources));
  });
  table.jobs = ReadJobs(fields.Object("jobs"));
  ForEach(fields, "problems",
          [&](const Fields& problem) { table.problems.push_back(ReadProblem(problem)); });
  table.notes = fields.Texts("notes");
  table.provenance = ReadProvenance(fields.Object("provenance"));
  return table;
}

Table ReadTableFile(const std::filesystem::path& file) {
  return ReadTable(ReadFileBytes(file), file.string());
}

}  // namespace cvo::reports
