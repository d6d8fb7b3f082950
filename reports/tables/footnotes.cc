// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <tuple>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/record/contract.h"
#include "core/record/metric_catalogue.h"
#include "reports/statistics/estimate.h"
#include "reports/tables/table_texts.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kShownProblems = 12;

using Lines = std::vector<std::string>;

// The label of a column, with its unit if several columns share the label.
std::string ColumnName(const Table& table, std::size_t index) {
  const Column& column = table.columns[index];
  const auto same = std::count_if(table.columns.begin(), table.columns.end(),
                                  [&](const Column& other) { return other.label == column.label; });
  return same == 1 ? column.label : StrCat(column.label, " [", column.unit, "]");
}

// Remarks that apply to several columns or rows. Each is listed once, in order of first appearance.
class NamesByText {
 public:
  void Add(const std::string& text, const std::string& name) {
    if (!text.empty()) AddOnce(name, FindOrAdd(names_, &Named::first, {text, {}}).second);
  }
  void Print(const std::string& before, Lines& lines, const char* between = ": ") const {
    for (const auto& [text, names] : names_) {
      lines.push_back(StrCat(before, Joined(names, ", "), between, text));
    }
  }

 private:
  using Named = std::pair<std::string, Lines>;
  std::vector<Named> names_;
};

// A sequence that is missing is listed once, not once per variant and seed.
void AddProblems(const Table& table, Lines& lines) {
  Lines problems;
  for (const Problem& problem : table.problems) {
    if (problem.state == "not run") continue;
    const std::string whose =
        problem.state == "no data"
            ? problem.sequence
            : StrCat(problem.row, ", ", problem.sequence, ", seed ", problem.seed);
    AddOnce(
        StrCat(whose, ": ", problem.state, problem.message.empty() ? "" : ": " + problem.message,
               problem.log.empty() ? "" : " (log: " + problem.log + ")"),
        problems);
  }
  if (problems.size() > kShownProblems) {
    const std::size_t more = problems.size() - kShownProblems;
    problems.resize(kShownProblems);
    problems.push_back(StrCat("and ", more, " more: table.json has all"));
  }
  lines.insert(lines.end(), problems.begin(), problems.end());
}

// Explains each split that occurs in the rows.
void AddSplits(const Table& table, Lines& lines) {
  constexpr std::array<std::pair<const char*, const char*>, 4> kSplits = {
      {{"development", "options were chosen on these scenes, so the values are in-sample"},
       {"test", "no option was chosen on these scenes"},
       {"given", "recorded images"},
       {"none", "scenes of neither the development nor the test split"}}};
  for (const auto& [split, meaning] : kSplits) {
    if (std::any_of(table.rows.begin(), table.rows.end(), [name = split](const Row& row) {
          return row.split.find(name) != std::string::npos;
        })) {
      lines.push_back(StrCat("split ", split, ": ", meaning));
    }
  }
}

// Also states how many scenes are needed to detect a small difference in any row: the statistical
// power of the table.
void AddIntervals(const Table& table, Lines& lines) {
  NamesByText meanings;
  NamesByText pairings;
  std::size_t differences = 0;
  std::vector<std::size_t> needed(table.columns.size());
  for (const Row& row : table.rows) {
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const std::string name = ColumnName(table, i);
      const auto& [interval, difference] = std::tie(row.cells[i].interval, row.cells[i].difference);
      if (interval) meanings.Add(interval->meaning, name);
      if (!difference) continue;
      differences += difference->adjusted_p_value ? 1 : 0;
      pairings.Add("compared on " + difference->pairing, name);
      needed[i] = std::max(needed[i], difference->scenes_for_10_percent.value_or(0));
    }
  }
  meanings.Print("low..high, ", lines);
  if (differences > 0) {
    lines.push_back(StrCat(
        "*: distinguishable from noise: the interval of the paired difference excludes 0, and its "
        "p-value (Student's t over scenes), corrected for the ",
        differences, " comparisons of this table (Holm), is below 0.05; never with fewer than ",
        kMinPairs, " pairs"));
  }
  pairings.Print("", lines);
  Lines needs;
  for (std::size_t i = 0; i < needed.size(); ++i) {
    if (needed[i] > 0) needs.push_back(StrCat(ColumnName(table, i), " ", needed[i]));
  }
  if (needs.empty()) return;
  lines.push_back(
      StrCat("scenes needed to detect a difference of ", 100.0 * kPowerDifference,
             " % (80 % power, 5 % two-sided, uncorrected), for the row that needs most: ",
             Joined(needs, ", ")));
}

// Adds the remarks about cells. Those that are the same for several rows are listed once.
void AddCells(const Table& table, Lines& lines) {
  NamesByText rows;
  for (const Row& row : table.rows) {
    NamesByText remarks;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const Cell& cell = row.cells[i];
      const std::string label = ColumnName(table, i);
      if (!row.runs.empty() && !cell.present) remarks.Add(cell.message, label);
      remarks.Add(cell.left_out, label);
      if (!cell.not_comparable.empty()) {
        remarks.Add("in brackets, defined differently: " + cell.not_comparable, label);
      }
    }
    Lines of_row;
    remarks.Print("", of_row);
    for (const std::string& line : of_row) rows.Add(line, RowLabel(row));
  }
  rows.Print("", lines, "; ");
}

// Names metrics without coverage in the table, since accuracy alone favours whoever loses the hard
// parts. Then states the counts of each column; if they differ between rows, each is followed by
// the rows it applies to.
void AddCoverageAndCounts(const Table& table, Lines& lines) {
  NamesByText missing;
  NamesByText counts;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const std::string coverage = CoverageOf(table.columns[i].metric);
    if (!coverage.empty() && FindBy(table.columns, &Column::metric, coverage) == nullptr) {
      missing.Add("coverage is not in this table; what was lost does not count here",
                  ColumnName(table, i));
    }
    std::vector<std::pair<std::string, Lines>> rows;  // by count
    for (const Row& row : table.rows) {
      if (!row.cells[i].present) continue;
      const std::string text = CountsText(row.cells[i].n);
      FindOrAdd(rows, &std::pair<std::string, Lines>::first, {text, {}})
          .second.push_back(RowLabel(row));
    }
    counts.Add(Joined(rows, "; ",
                      [&](const auto& of_count) {
                        const auto& [text, labels] = of_count;
                        return rows.size() == 1 ? text
                                                : StrCat(text, " (", Joined(labels, ", "), ")");
                      }),
               ColumnName(table, i));
  }
  missing.Print("", lines);
  counts.Print("n, ", lines);
}

// The sources of reference rows, each with the distinct reasons why its figures are not comparable,
// and what was inferred about them.
void AddReferences(const Table& table, Lines& lines) {
  bool any_differs = false;
  std::vector<Lines> reasons(table.sources.size());
  const auto gather = [&](const std::vector<ReferenceRow>& rows, bool explain) {
    for (const ReferenceRow& line : rows) {
      for (std::size_t i = 0; i < line.cells.size(); ++i) {
        const auto& cell = line.cells[i];
        if (!cell) continue;
        any_differs = any_differs || cell->match != Match::kMatches;
        if (!explain || cell->reason.empty() || cell->match == Match::kOtherFrames) continue;
        AddOnce(ColumnName(table, i) + " " + cell->reason, reasons[line.source]);
      }
    }
  };
  for (const Row& row : table.rows) gather(row.reference, true);
  gather(table.others, false);
  if (any_differs) {
    lines.emplace_back(
        "(in brackets): not comparable with ours: other scenes, frames or images, or a metric that "
        "differs or that the source does not define");
  }
  for (std::size_t i = 0; i < table.sources.size(); ++i) {
    std::string note = SourceMark(i) + " " + table.sources[i].source;
    if (!table.sources[i].caveat.empty()) note += "; " + table.sources[i].caveat;
    for (const std::string& reason : reasons[i]) note += "; " + reason;
    lines.push_back(note);
  }
}

}  // namespace

std::string SourceMark(std::size_t source) {
  return StrCat("[", static_cast<char>('a' + static_cast<int>(source % 26)), "]");
}

std::string JobsText(const JobCounts& jobs) {
  std::string line = StrCat(jobs.done, " of ", jobs.planned, " runs");
  for (const auto& [count, what] : {std::pair{jobs.lost, "of them lost"},
                                    {jobs.failed, "failed"},
                                    {jobs.not_run, "not run yet"},
                                    {jobs.no_data, "without their sequence"}}) {
    if (count > 0) line += StrCat(", ", count, " ", what);
  }
  return line;
}

std::string CountsText(const Counts& n) {
  Lines counts;
  if (n.bodies > 0) counts.push_back(Counted(n.bodies, "body", "bodies"));
  if (n.scenes > 0) counts.push_back(Counted(n.scenes, "scene"));
  if (n.seeds > 0) counts.push_back(Counted(n.seeds, "seed"));
  if (n.runs > 0) counts.push_back(Counted(n.runs, "run"));
  return Joined(counts, ", ");
}

std::vector<std::string> Footnotes(const Table& table) {
  Lines lines = {JobsText(table.jobs)};
  AddProblems(table, lines);
  AddSplits(table, lines);
  lines.insert(lines.end(), table.notes.begin(), table.notes.end());
  for (const ChangedOption& option : table.provenance.options) {
    lines.push_back(StrCat("option ", option.path, ": ", Joined(option.values, ", "), " (default ",
                           option.default_value.empty() ? "none" : option.default_value, ")"));
  }
  AddCells(table, lines);
  AddCoverageAndCounts(table, lines);
  AddIntervals(table, lines);
  AddReferences(table, lines);
  return lines;
}

std::vector<std::string> Definitions(const Table& table) {
  Lines lines;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const std::string definition =
        Joined(ContractTexts(table.columns[i].contract), "; ", [](const auto& part) {
          const auto& [field, text] = part;
          const bool named = field == "poses" || field == "delta" || field == "alignment";
          return named ? field + " " + text : text;
        });
    if (!definition.empty()) lines.push_back(StrCat(ColumnName(table, i), ": ", definition));
  }
  return lines;
}

}  // namespace cvo::reports
