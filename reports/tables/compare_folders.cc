// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/tables/make_table.h"

namespace cvo::reports {
namespace {

using Values = std::set<std::string>;

Values VariantsOf(const std::vector<SuiteRun>& runs) {
  Values variants;
  for (const SuiteRun& run : runs) variants.insert(KeyOf(run.planned, "variant"));
  return variants;
}

// What the runs of a folder were made with, by what it is: variants, builds, and options of the
// variants that the other folder has, too.
std::map<std::string, Values> MadeWith(const std::vector<SuiteRun>& runs, const Values& others) {
  std::map<std::string, Values> made = {{"variants", VariantsOf(runs)}};
  for (const SuiteRun& run : runs) {
    if (!run.run) continue;
    constexpr std::size_t kTold = 12;  // characters of a hash
    const std::string& build = run.run->build.identity;
    if (!build.empty()) made["builds"].insert(build.substr(0, kTold));
    if (!others.contains(KeyOf(run.planned, "variant"))) continue;
    for (const auto& [path, value] : FlatJson(run.run->options)) {
      made["option " + path].insert(value);
    }
  }
  return made;
}

// How the runs of two folders differ apart from their results, in one line.
std::string WhatDiffers(const std::vector<SuiteRun>& before, const std::vector<SuiteRun>& after) {
  std::map<std::string, Values> a = MadeWith(before, VariantsOf(after));
  std::map<std::string, Values> b = MadeWith(after, VariantsOf(before));
  for (const auto& [what, values] : b) a[what];
  std::vector<std::string> parts;
  const auto text = [](const Values& values) {
    return values.empty() ? "-" : Joined(values, " or ");
  };
  for (const auto& [what, values] : a) {
    if (values != b[what]) parts.push_back(StrCat(what, " ", text(values), " -> ", text(b[what])));
  }
  if (parts.empty()) return "The two folders have the same options, builds and variants.";
  return StrCat("The two folders differ: ", Joined(parts, "; "), ".");
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
    table.notes.push_back(Joined(row.keys, " ") + ": no such row in the second folder");
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

Table CompareFolders(const std::filesystem::path& before, const std::filesystem::path& folder) {
  const SuitePlan plan = ReadPlan(folder / "plan.json");
  const SuitePlan plan_before = ReadPlan(before / "plan.json");
  CheckSameRows(plan_before, plan);
  const std::vector<std::string> metrics = WithCoverage(plan.metrics);
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
  NoteUnpaired(rows_before, rows, table);
  return table;
}

std::string MovedText(const Table& table) {
  std::size_t compared = 0;
  std::size_t moved = 0;
  std::size_t distinguishable = 0;
  for (const Row& row : table.rows) {
    for (const Cell& cell : row.cells) {
      if (!cell.difference) continue;
      ++compared;
      moved += cell.difference->difference != 0.0 ? 1 : 0;
      distinguishable += cell.difference->distinguishable ? 1 : 0;
    }
  }
  return StrCat(moved, " of ", compared, " values changed, ", distinguishable,
                " distinguishable from noise (*)\n");
}

}  // namespace cvo::reports
