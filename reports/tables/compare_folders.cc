// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "reports/statistics/estimate.h"
#include "reports/tables/make_table.h"

namespace cvo::reports {
namespace {

using Values = std::set<std::string>;
using OptionValues = std::map<std::string, Values>;  // by path

// The variants, builds and options of the runs of one folder.
struct Made {
  Values variants;
  Values builds;
  std::map<std::string, OptionValues> options;  // by variant
};

Made MadeWith(const std::vector<SuiteRun>& runs) {
  Made made;
  for (const SuiteRun& run : runs) {
    const std::string variant = KeyOf(run.planned, "variant");
    made.variants.insert(variant);
    if (!run.run) continue;
    constexpr std::size_t kTold = 12;  // characters of a hash
    if (!run.run->build.identity.empty()) {
      made.builds.insert(run.run->build.identity.substr(0, kTold));
    }
    for (const auto& [path, value] : FlatJson(run.run->options)) {
      made.options[variant][path].insert(value);
    }
  }
  return made;
}

std::string ValuesText(const Values& values) {
  constexpr std::size_t kMost = 3;
  if (values.empty()) return "-";
  if (values.size() > kMost) return Counted(values.size(), "value");
  return Joined(values, " or ");
}

std::string ChangeOf(const Values& before, const Values& after) {
  return StrCat(ValuesText(before), " -> ", ValuesText(after));
}

// The options that differ in a variant that both folders have, with the values of the first such
// variant.
std::vector<std::string> OptionChanges(const Made& before, const Made& after) {
  std::map<std::string, std::string> changes;
  for (const auto& [variant, options] : after.options) {
    const auto there = before.options.find(variant);
    if (there == before.options.end()) continue;
    std::map<std::string, std::pair<Values, Values>> values;  // by path: before, after
    for (const auto& [path, was] : there->second) values[path].first = was;
    for (const auto& [path, is] : options) values[path].second = is;
    for (const auto& [path, both] : values) {
      const auto& [was, is] = both;
      if (was != is) changes.try_emplace(path, StrCat(path, " ", ChangeOf(was, is)));
    }
  }
  std::vector<std::string> texts;
  for (const auto& [path, text] : changes) texts.push_back(text);
  return texts;
}

std::string OnlyIn(const Values& one, const Values& other) {
  std::vector<std::string> only;
  std::set_difference(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(only));
  return Joined(only, ", ");
}

// Describes in one line how the runs of two folders differ apart from their results: variants that
// only one folder has, options of the variants that both have, builds of the program.
std::string WhatDiffers(const std::vector<SuiteRun>& before, const std::vector<SuiteRun>& after) {
  const Made a = MadeWith(before);
  const Made b = MadeWith(after);
  std::vector<std::string> parts;
  const auto add = [&](const char* what, const std::string& text) {
    if (!text.empty()) parts.push_back(what + text);
  };
  constexpr std::size_t kMost = 12;
  std::vector<std::string> options = OptionChanges(a, b);
  if (options.size() > kMost) {
    const std::size_t more = options.size() - kMost;
    options.resize(kMost);
    options.push_back(StrCat("and ", more, " more"));
  }
  add("options ", Joined(options, ", "));
  add("builds ", a.builds == b.builds ? "" : ChangeOf(a.builds, b.builds));
  add("variants only before: ", OnlyIn(a.variants, b.variants));
  add("variants only after: ", OnlyIn(b.variants, a.variants));
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

std::string Line(const Row& row, const Column& column, const Difference& difference) {
  const std::string unit = column.unit == "1" ? "" : " " + column.unit;
  std::string line = StrCat("  ", RowLabel(row), ", ", column.metric, ": ",
                            FormatSigned(difference.difference, 4), unit);
  if (difference.percent) line += StrCat(" (", FormatSigned(*difference.percent, 4), " %)");
  if (difference.interval) {
    line += StrCat(", ", FormatSigned(difference.interval->low, 4), " to ",
                   FormatSigned(difference.interval->high, 4));
  } else {
    line += ", no interval";
  }
  return StrCat(line, ", ", Counted(difference.pairs, "pair"), "\n");
}

}  // namespace

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
  const std::set<std::string> levels = CpuLevels(both);
  if (levels.size() > 1 && levels != CpuLevels(runs)) table.notes.push_back(CpuLevelNote(levels));
  NoteUnpaired(rows_before, rows, table);
  return table;
}

std::string MovedText(const Table& table) {
  std::string distinguishable;
  std::string noise;
  std::map<std::size_t, std::string> undecided;  // by the number of pairs
  for (const Row& row : table.rows) {
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const auto& difference = row.cells[i].difference;
      if (!difference || difference->difference == 0.0) continue;
      (difference->distinguishable     ? distinguishable
       : difference->pairs < kMinPairs ? undecided[difference->pairs]
                                       : noise) += Line(row, table.columns[i], *difference);
    }
  }
  std::string text;
  if (!distinguishable.empty()) text += "changed, distinguishable from noise:\n" + distinguishable;
  if (!noise.empty()) text += "changed, not distinguishable from noise:\n" + noise;
  for (const auto& [pairs, lines] : undecided) {
    text += StrCat("moved, ", UndecidedText(pairs), ":\n", lines);
  }
  return text.empty() ? "nothing changed\n" : text;
}

}  // namespace cvo::reports
