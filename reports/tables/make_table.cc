// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/make_table.h"

#include <algorithm>
#include <functional>
#include <map>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text_file.h"
#include "reports/tables/cells.h"
#include "reports/tables/columns.h"
#include "reports/tables/comparisons.h"
#include "reports/tables/reference_rows.h"
#include "reports/tables/table_parts.h"
#include "reports/tables/what_differs.h"

namespace cvo::reports {
namespace {

std::vector<std::string> MetricsOf(const SuitePlan& plan) {
  if (!plan.metrics.empty()) return WithCoverage(plan.metrics);
  std::vector<std::string> metrics = CameraMetrics();
  for (const std::string& metric : ObjectMetrics()) metrics.push_back(metric);
  return metrics;
}

// Returns the row that a row is compared with, or nullptr if there is none.
using ReferenceOf = std::function<const RowRuns*(const RowRuns& row)>;

void AddRows(const std::vector<RowRuns>& rows, const std::filesystem::path& folder,
             const ReferenceOf& reference_of, Table& table) {
  for (const RowRuns& runs : rows) {
    Row row = DescribeRow(runs, folder);
    const RowRuns* reference = reference_of(runs);
    for (const Column& column : table.columns) {
      Cell cell = MakeCell(runs, table.keys, column);
      cell.not_comparable = DifferingMeaning(runs, column);
      if (reference != nullptr && cell.present && AreComparable(runs, *reference, column)) {
        cell.difference = MakeDifference({table.keys, runs, *reference, table.reference}, column);
      }
      row.cells.push_back(std::move(cell));
    }
    table.rows.push_back(std::move(row));
  }
  CorrectForMany(table);
}

// Fills in everything but the rows and the reference.
Table DescribeTable(const SuitePlan& plan, const std::vector<SuiteRun>& runs,
                    const std::vector<std::string>& metrics, const std::string& default_options) {
  Table table;
  table.title = plan.name;
  table.about = plan.about;
  table.keys = plan.rows;
  table.columns = MakeColumns(metrics, runs);
  std::vector<const SuiteRun*> all;
  for (const SuiteRun& run : runs) all.push_back(&run);
  table.jobs = CountJobs(all);
  table.problems = ListProblems(GroupRuns(runs, plan.rows));
  table.provenance = DescribeRuns(runs, default_options);
  table.notes = TableNotes(runs, table);
  return table;
}

// Notes about runs of the same scene and seed that used different images in the two folders.
std::vector<std::string> OtherImages(const std::vector<SuiteRun>& before,
                                     const std::vector<SuiteRun>& after) {
  std::map<std::string, const SuiteRun*> first;
  for (const SuiteRun& run : before) {
    if (run.run) first.try_emplace(StrCat(SceneOf(run), " ", run.planned.seed), &run);
  }
  std::vector<std::string> notes;
  for (const SuiteRun& run : after) {
    if (!run.run) continue;
    const auto other = first.find(StrCat(SceneOf(run), " ", run.planned.seed));
    if (other == first.end()) continue;
    if (other->second->run->sequence.content == run.run->sequence.content) continue;
    AddOnce(StrCat(SceneOf(run), ", seed ", run.planned.seed,
                   ": the two folders ran it on different images"),
            notes);
  }
  return notes;
}

void CheckSameRows(const SuitePlan& before, const SuitePlan& after) {
  if (before.rows == after.rows) return;
  ThrowError(StrCat(before.file.string(), " and ", after.file.string()),
             StrCat("rows by ", Joined(before.rows, ", "), " and by ", Joined(after.rows, ", ")),
             "the same rows");
}

// Adds notes about rows that only one side has or that have no run in common.
void NoteUnpaired(const std::vector<RowRuns>& before, const std::vector<RowRuns>& after,
                  Table& table) {
  for (const RowRuns& row : before) {
    if (FindBy(after, &RowRuns::keys, row.keys) != nullptr) continue;
    Row label;
    label.keys = row.keys;
    table.notes.push_back(RowLabel(label) + ": no such row in the second folder");
  }
  bool any = false;
  for (const Row& row : table.rows) {
    const bool paired = std::any_of(row.cells.begin(), row.cells.end(),
                                    [](const Cell& cell) { return cell.difference.has_value(); });
    if (!paired) table.notes.push_back(RowLabel(row) + ": no run in common with the first folder");
    any = any || paired;
  }
  if (!any) ThrowError("compare", "no row with a run that both have", "the same scenes and seeds");
}

}  // namespace

Table MakeTable(const std::filesystem::path& folder, const Reference& reference,
                const std::string& default_options, const std::string& compared_with) {
  SuitePlan plan = ReadPlan(folder / "plan.json");
  if (!compared_with.empty()) plan.reference = compared_with;
  const std::string full_reference = FullReference(plan);
  const std::vector<std::string> metrics = MetricsOf(plan);
  const std::vector<SuiteRun> runs = ReadRuns(folder, plan, metrics);
  const std::vector<RowRuns> rows = GroupRuns(runs, plan.rows);
  Table table = DescribeTable(plan, runs, metrics, default_options);
  table.reference = plan.reference;
  const auto reference_of = [&](const RowRuns& row) {
    return FindReference(rows, row, plan.rows, full_reference);
  };
  if (!compared_with.empty() && std::none_of(rows.begin(), rows.end(), reference_of)) {
    ThrowError("reference " + Quoted(compared_with), "no such row in " + plan.file.string(),
               "the variant or the key=value of a row");
  }
  AddRows(rows, folder, reference_of, table);
  AddReferenceRows(reference, table);
  return table;
}

Table CompareFolders(const std::filesystem::path& before, const std::filesystem::path& folder) {
  const SuitePlan plan = ReadPlan(folder / "plan.json");
  const SuitePlan plan_before = ReadPlan(before / "plan.json");
  CheckSameRows(plan_before, plan);
  const std::vector<std::string> metrics = MetricsOf(plan);
  const std::vector<SuiteRun> runs = ReadRuns(folder, plan, metrics);
  const std::vector<SuiteRun> runs_before = ReadRuns(before, plan_before, metrics);
  std::vector<SuiteRun> both = runs_before;
  both.insert(both.end(), runs.begin(), runs.end());
  MakeColumns(metrics, both);  // throws if contracts differ, naming a file of each
  const std::vector<RowRuns> rows = GroupRuns(runs, plan.rows);
  const std::vector<RowRuns> rows_before = GroupRuns(runs_before, plan.rows);
  Table table = DescribeTable(plan, runs, metrics, "");
  table.title = StrCat(folder.string(), " against ", before.string());
  table.reference = before.string();
  table.about = WhatDiffers(runs_before, runs);
  table.change = true;
  AddRows(
      rows, folder,
      [&](const RowRuns& row) { return FindBy(rows_before, &RowRuns::keys, row.keys); }, table);
  for (const std::string& note : OtherImages(runs_before, runs)) table.notes.push_back(note);
  if (CpuLevels(runs) != CpuLevels(both)) table.notes.push_back(CpuLevelNote(CpuLevels(both)));
  NoteUnpaired(rows_before, rows, table);
  return table;
}

bool IsComplete(const Table& table) {
  return table.jobs.failed == 0 && table.jobs.not_run == 0 && table.jobs.done > 0;
}

}  // namespace cvo::reports
