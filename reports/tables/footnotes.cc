// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <tuple>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/record/contract.h"
#include "core/record/metric_catalogue.h"
#include "reports/statistics/estimate.h"
#include "reports/tables/table_texts.h"

namespace cvo::reports {
namespace {

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

// Explains each split that occurs in the rows.
void AddSplits(const Table& table, Lines& lines) {
  for (const auto& [split, meaning] :
       {std::pair{"development", "options were chosen on these scenes, so values are in-sample"},
        std::pair{"test", "no option was chosen on these scenes"},
        std::pair{"given", "recorded images"},
        std::pair{"none", "scenes of neither the development nor the test split"}}) {
    if (std::ranges::any_of(table.rows, [name = split](const Row& row) {
          return row.split.find(name) != std::string::npos;
        })) {
      lines.push_back(StrCat("split ", split, ": ", meaning));
    }
  }
}

// What values are means over, what intervals and stars mean.
void AddStatistics(const Table& table, Lines& lines) {
  NamesByText counts;
  std::size_t intervals = 0;
  std::size_t comparisons = 0;
  bool undecided = false;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    Lines of_rows;
    for (const Row& row : table.rows) {
      const Cell& cell = row.cells[i];
      if (cell.value) AddOnce(CountsText(cell.n), of_rows);
      intervals += cell.interval ? 1 : 0;
      comparisons += cell.difference && cell.difference->adjusted_p_value ? 1 : 0;
      undecided = undecided || (cell.difference && cell.difference->truth_gap);
    }
    counts.Add(Joined(of_rows, " or "), ColumnName(table, i));
  }
  counts.Print("n, ", lines);
  if (intervals > 0) lines.push_back(StrCat("low..high: ", kIntervalMeaning));
  if (undecided) {
    lines.emplace_back(
        "within the gap of the truths: smaller than camera_truth_gap, by which the two truths of "
        "the recording differ themselves; such a difference has no percentage and no mark");
  }
  if (comparisons == 0) return;
  lines.push_back(StrCat(
      "*: distinguishable from noise: the interval of the paired difference excludes 0, and its "
      "p-value (Student's t over scenes), corrected for the ",
      comparisons, " comparisons of this table (Holm), is below 0.05; never with fewer than ",
      kMinPairs, " pairs"));
  lines.emplace_back(
      "differences are over what both rows have: errors of bodies that both estimate (object ATE: "
      "in the frames that both estimate), otherwise all visible object-frames; metrics of runs "
      "over the same scenes and seeds");
}

// Remarks about cells. Those that are the same for several rows are listed once.
void AddCells(const Table& table, Lines& lines) {
  NamesByText rows;
  for (const Row& row : table.rows) {
    NamesByText remarks;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const Cell& cell = row.cells[i];
      const std::string label = ColumnName(table, i);
      if (!row.runs.empty() && !cell.value) remarks.Add(cell.message, label);
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

// The sources of reference rows, with what is not comparable about their figures or was inferred.
void AddReferences(const Table& table, Lines& lines) {
  std::map<std::string, Lines> reasons;  // by source
  for (const Row& row : table.rows) {
    for (const ReferenceRow& line : row.reference) {
      for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const ReferenceCell* cell = line.Find(table.columns[i]);
        if (cell == nullptr || cell->reason.empty() || cell->match == Match::kOtherFrames) continue;
        AddOnce(ColumnName(table, i) + " " + cell->reason, reasons[line.source]);
      }
    }
  }
  if (!table.sources.empty()) {
    lines.emplace_back(
        "(in brackets): not comparable with ours: other scenes, frames or images, or a metric that "
        "differs or that the source does not define");
  }
  for (const ReferenceSource& source : table.sources) {
    lines.push_back(StrCat(SourceMark(table, source.id), " ", source.source,
                           source.caveat.empty() ? "" : "; ", source.caveat));
    for (const std::string& reason : reasons[source.id]) lines.back() += "; " + reason;
  }
}

void AddDefinitions(const Table& table, Lines& lines) {
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const std::string definition =
        Joined(ContractTexts(table.columns[i].contract), "; ", [](const auto& part) {
          const auto& [field, text] = part;
          const bool named = field == "poses" || field == "delta" || field == "alignment";
          return named ? field + " " + text : text;
        });
    if (!definition.empty()) lines.push_back(StrCat(ColumnName(table, i), ": ", definition));
  }
}

}  // namespace

std::string SourceMark(const Table& table, const std::string& source) {
  const auto index = FindBy(table.sources, &ReferenceSource::id, source) - table.sources.data();
  return StrCat("[", static_cast<char>('a' + static_cast<int>(index % 26)), "]");
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
  for (const auto& [count, one, many] : {std::tuple{n.bodies, "body", "bodies"},
                                         {n.scenes, "scene", ""},
                                         {n.seeds, "seed", ""},
                                         {n.runs, "run", ""}}) {
    if (count > 0) counts.push_back(Counted(count, one, many));
  }
  return Joined(counts, ", ");
}

// A sequence that is missing is listed once, not once per variant and seed.
std::vector<std::string> ProblemTexts(const Table& table) {
  constexpr std::size_t kShown = 12;
  Lines problems;
  for (const Problem& problem : table.problems) {
    const std::string whose =
        problem.state == "no data"
            ? problem.sequence
            : StrCat(problem.row, ", ", problem.sequence, ", seed ", problem.seed);
    AddOnce(
        StrCat(whose, ": ", problem.state, problem.message.empty() ? "" : ": " + problem.message,
               problem.log.empty() ? "" : " (log: " + problem.log + ")"),
        problems);
  }
  if (problems.size() > kShown) {
    const std::size_t more = problems.size() - kShown;
    problems.resize(kShown);
    problems.push_back(StrCat("and ", more, " more: table.json has all"));
  }
  return problems;
}

std::vector<std::string> Footnotes(const Table& table) {
  Lines lines = ProblemTexts(table);
  lines.insert(lines.begin(), JobsText(table.jobs));
  AddSplits(table, lines);
  lines.insert(lines.end(), table.notes.begin(), table.notes.end());
  for (const ChangedOption& option : table.provenance.options) {
    lines.push_back(StrCat("option ", option.path, ": ", Joined(option.values, ", "), " (default ",
                           option.default_value.empty() ? "none" : option.default_value, ")"));
  }
  AddCells(table, lines);
  AddStatistics(table, lines);
  AddReferences(table, lines);
  AddDefinitions(table, lines);
  return lines;
}

}  // namespace cvo::reports
