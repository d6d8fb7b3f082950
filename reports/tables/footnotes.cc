// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/footnotes.h"

#include <algorithm>
#include <array>
#include <map>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/results/contract_text.h"
#include "reports/results/metric_catalogue.h"
#include "reports/statistics/estimate.h"

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
    if (text.empty()) return;
    if (names_.find(text) == names_.end()) order_.push_back(text);
    AddOnce(name, names_[text]);
  }
  void Print(const std::string& before, Lines& lines, const char* between = ": ") const {
    for (const std::string& text : order_) {
      lines.push_back(StrCat(before, Joined(names_.at(text), ", "), between, text));
    }
  }

 private:
  Lines order_;
  std::map<std::string, Lines> names_;
};

void AddJobs(const Table& table, Lines& lines) {
  const JobCounts& jobs = table.jobs;
  std::string line = StrCat(jobs.done, " of ", jobs.planned, " runs");
  const auto add = [&line](std::size_t count, const char* what) {
    if (count > 0) line += StrCat(", ", count, " ", what);
  };
  add(jobs.lost, "of them lost");
  add(jobs.failed, "failed");
  add(jobs.not_run, "not run yet");
  add(jobs.no_data, "without their sequence");
  lines.push_back(line);
}

void AddProblems(const Table& table, Lines& lines) {
  Lines problems;
  for (const Problem& problem : table.problems) {
    if (problem.state == "not run") continue;
    // A sequence that is missing is listed once, not once per variant and seed.
    const std::string whose =
        problem.state == "no data"
            ? problem.sequence
            : StrCat(problem.row, ", ", problem.sequence, ", seed ", problem.seed);
    AddOnce(
        StrCat(whose, ": ", problem.state, problem.message.empty() ? "" : ": " + problem.message,
               problem.log.empty() ? "" : " (log: " + problem.log + ")"),
        problems);
  }
  for (std::size_t i = 0; i < std::min(problems.size(), kShownProblems); ++i)
    lines.push_back(problems[i]);
  if (problems.size() > kShownProblems) {
    lines.push_back(StrCat("and ", problems.size() - kShownProblems, " more: table.json has all"));
  }
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

// States how many scenes are needed to detect a small difference in any row: the statistical power
// of the table.
void AddPower(const Table& table, Lines& lines) {
  Lines needs;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    std::size_t most = 0;
    for (const Row& row : table.rows) {
      const auto& difference = row.cells[i].difference;
      if (difference) most = std::max(most, difference->scenes_for_10_percent.value_or(0));
    }
    if (most > 0) needs.push_back(StrCat(ColumnName(table, i), " ", most));
  }
  if (needs.empty()) return;
  lines.push_back(
      StrCat("scenes needed to detect a difference of ", 100.0 * kPowerDifference,
             " % (80 % power, 5 % two-sided, uncorrected), for the row that needs most: ",
             Joined(needs, ", ")));
}

void AddIntervals(const Table& table, Lines& lines) {
  NamesByText meanings;
  std::size_t differences = 0;
  NamesByText pairings;
  for (const Row& row : table.rows) {
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const Cell& cell = row.cells[i];
      const std::string label = ColumnName(table, i);
      if (cell.interval) meanings.Add(cell.interval->meaning, label);
      if (!cell.difference) continue;
      differences += cell.difference->adjusted_p_value ? 1 : 0;
      pairings.Add("compared on " + cell.difference->pairing, label);
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
  AddPower(table, lines);
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

// The counts of a column. If they differ between rows, each is followed by the rows it applies to.
std::string CountsOfColumn(const Table& table, std::size_t column) {
  Lines texts;
  std::map<std::string, Lines> rows;
  for (const Row& row : table.rows) {
    if (!row.cells[column].present) continue;
    const std::string text = CountsText(row.cells[column].n);
    AddOnce(text, texts);
    rows[text].push_back(RowLabel(row));
  }
  if (texts.size() == 1) return texts[0];
  return Joined(texts, "; ", [&](const std::string& text) {
    return StrCat(text, " (", Joined(rows[text], ", "), ")");
  });
}

void AddCounts(const Table& table, Lines& lines) {
  NamesByText counts;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    counts.Add(CountsOfColumn(table, i), ColumnName(table, i));
  }
  counts.Print("n, ", lines);
}

// Names metrics without coverage in the table, since accuracy alone favours whoever loses the hard
// parts.
void AddMissingCoverage(const Table& table, Lines& lines) {
  NamesByText missing;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const std::string coverage = CoverageOf(table.columns[i].metric);
    const bool there = coverage.empty() ||
                       std::any_of(table.columns.begin(), table.columns.end(),
                                   [&](const Column& other) { return other.metric == coverage; });
    if (!there) {
      missing.Add("coverage is not in this table; what was lost does not count here",
                  ColumnName(table, i));
    }
  }
  missing.Print("", lines);
}

// The distinct reasons why figures of a source are not comparable, and what was inferred about
// them.
Lines Reasons(const Table& table, std::size_t source) {
  Lines reasons;
  for (const Row& row : table.rows) {
    for (const ReferenceRow& line : row.reference) {
      if (line.source != source) continue;
      for (std::size_t i = 0; i < line.cells.size(); ++i) {
        const auto& cell = line.cells[i];
        if (!cell || cell->reason.empty() || cell->match == Match::kOtherFrames) continue;
        AddOnce(ColumnName(table, i) + " " + cell->reason, reasons);
      }
    }
  }
  return reasons;
}

bool AnyDoesNotCompare(const Table& table) {
  const auto in = [](const std::vector<ReferenceRow>& others) {
    for (const ReferenceRow& line : others) {
      for (const auto& cell : line.cells) {
        if (cell && cell->match != Match::kMatches) return true;
      }
    }
    return false;
  };
  return in(table.others) || std::any_of(table.rows.begin(), table.rows.end(),
                                         [&](const Row& row) { return in(row.reference); });
}

void AddReferences(const Table& table, Lines& lines) {
  if (AnyDoesNotCompare(table)) {
    lines.emplace_back(
        "(in brackets): not comparable with ours: other scenes, frames or images, or a metric that "
        "differs or that the source does not define");
  }
  for (std::size_t i = 0; i < table.sources.size(); ++i) {
    std::string note = SourceMark(i) + " " + table.sources[i].source;
    if (!table.sources[i].caveat.empty()) note += "; " + table.sources[i].caveat;
    for (const std::string& reason : Reasons(table, i)) note += "; " + reason;
    lines.push_back(note);
  }
}

void AddOptions(const Table& table, Lines& lines) {
  for (const ChangedOption& option : table.provenance.options) {
    lines.push_back(StrCat("option ", option.path, ": ", Joined(option.values, ", "), " (default ",
                           option.default_value.empty() ? "none" : option.default_value, ")"));
  }
}

}  // namespace

std::string SourceMark(std::size_t source) {
  return StrCat("[", static_cast<char>('a' + static_cast<int>(source % 26)), "]");
}

std::string CountsText(const Counts& n) {
  Lines counts;
  if (n.bodies > 0) counts.push_back(Counted(n.bodies, "body", "bodies"));
  if (n.scenes > 0) counts.push_back(Counted(n.scenes, "scene"));
  if (n.seeds > 0) counts.push_back(Counted(n.seeds, "seed"));
  if (n.runs > 0) counts.push_back(Counted(n.runs, "run"));
  return Joined(counts, ", ");
}

std::string UnitsText(const Counts& n) {
  if (n.scenes > 1) return Counted(n.scenes, "scene");
  if (n.bodies > 0) return Counted(n.bodies, "body", "bodies");
  return Counted(n.runs, "run");
}

std::vector<std::string> Footnotes(const Table& table) {
  Lines lines;
  AddJobs(table, lines);
  AddProblems(table, lines);
  AddSplits(table, lines);
  for (const std::string& note : table.notes) lines.push_back(note);
  AddOptions(table, lines);
  AddCells(table, lines);
  AddMissingCoverage(table, lines);
  AddCounts(table, lines);
  AddIntervals(table, lines);
  AddReferences(table, lines);
  return lines;
}

std::vector<std::string> Definitions(const Table& table) {
  Lines lines;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const Column& column = table.columns[i];
    std::string note = ColumnName(table, i) + ":";
    for (const auto& [field, text] : ContractTexts(column.contract)) {
      const bool named = field == "poses" || field == "delta" || field == "alignment";
      note += StrCat(note.back() == ':' ? " " : "; ", named ? field + " " : "", text);
    }
    if (note.back() != ':') lines.push_back(note);
  }
  return lines;
}

}  // namespace cvo::reports
