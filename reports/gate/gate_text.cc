// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/gate/gate_text.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "reports/gate/gate_runs.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kNearest = 5;
constexpr std::size_t kMaxProblems = 20;

std::vector<std::string> Cells(const Comparison& comparison) {
  return {comparison.variant,
          comparison.scene.empty() ? "all" : comparison.scene,
          comparison.metric + (comparison.unit == "1" ? "" : " (" + comparison.unit + ")"),
          FormatGeneral(comparison.baseline, 4),
          FormatGeneral(comparison.now, 4),
          FormatSigned(comparison.difference(), 3),
          FormatGeneral(comparison.tolerance, 3),
          StrCat(comparison.pairs),
          comparison.verdict == Verdict::kWorse ? "WORSE" : ToString(comparison.verdict)};
}

double PartOfTolerance(const Comparison& comparison) {
  return std::abs(comparison.difference()) / std::max(comparison.tolerance, 1e-300);
}

std::vector<const Comparison*> Nearest(const GateReport& report) {
  std::vector<const Comparison*> within;
  for (const Comparison& comparison : report.comparisons) {
    if (comparison.verdict == Verdict::kWithin && comparison.scene.empty()) {
      within.push_back(&comparison);
    }
  }
  std::stable_sort(within.begin(), within.end(), [](const Comparison* a, const Comparison* b) {
    return PartOfTolerance(*a) > PartOfTolerance(*b);
  });
  within.resize(std::min(within.size(), kNearest));
  return within;
}

std::size_t Width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

std::string CommitName(const std::string& commit) {
  return commit.empty() ? "an unknown commit" : commit.substr(0, 12);
}

}  // namespace

TextRows MovedRows(const GateReport& report) {
  TextRows rows;
  for (const Verdict verdict : {Verdict::kWorse, Verdict::kBetter}) {
    for (const Comparison& comparison : report.comparisons) {
      if (comparison.verdict == verdict) rows.push_back(Cells(comparison));
    }
  }
  for (const Comparison* comparison : Nearest(report)) rows.push_back(Cells(*comparison));
  if (rows.empty()) return rows;
  rows.insert(rows.begin(), {"variant", "scene", "metric", "baseline", "now", "difference",
                             "tolerance", "pairs", "verdict"});
  return rows;
}

TextRows TimeRows(const GateReport& report) {
  TextRows rows;
  if (report.times.empty()) return rows;
  rows.push_back({"variant", StrCat("time / ", kTimeReference, ", then"), "now", "factor", "limit",
                  "verdict"});
  for (const TimeComparison& time : report.times) {
    const char* verdict = time.verdict == Verdict::kWorse    ? "SLOWER"
                          : time.verdict == Verdict::kBetter ? "faster"
                                                             : "within";
    rows.push_back({time.variant, FormatGeneral(time.baseline, 3), FormatGeneral(time.now, 3),
                    FormatGeneral(time.now / time.baseline, 3), FormatGeneral(time.limit, 3),
                    verdict});
  }
  return rows;
}

std::string Headline(const GateReport& report) {
  return StrCat(report.suite, ": ", Counted(report.runs, "run"), " compared with those of ",
                CommitName(report.baseline_commit), ": ", report.Count(Verdict::kWorse), " worse, ",
                report.Count(Verdict::kBetter), " better, ", report.Count(Verdict::kWithin),
                " within tolerance, ", report.Count(Verdict::kSame), " the same",
                report.problems.empty() ? "" : ", " + Counted(report.problems.size(), "problem"));
}

std::string GateVerdict(const GateReport& report) {
  return report.Regressed() ? "regression" : report.Failed() ? "changed" : "no regression";
}

std::string ChangeLine(const GateReport& report) {
  if (report.changed == 0) return "";
  return StrCat(report.changed, " of ", report.comparisons.size(),
                " values differ from the baseline: the estimator changed; if this is intended, "
                "update the baseline");
}

std::vector<std::string> ProblemLines(const GateReport& report) {
  std::vector<std::string> lines;
  if (report.changed > 0) lines.push_back(ChangeLine(report));
  const std::size_t shown = std::min(report.problems.size(), kMaxProblems);
  for (std::size_t i = 0; i < shown; ++i) {
    lines.push_back(StrCat(report.problems[i].where, ": ", report.problems[i].message));
  }
  if (shown < report.problems.size()) {
    lines.push_back(StrCat("and ", report.problems.size() - shown, " more"));
  }
  return lines;
}

std::vector<std::string> NoteLines(const GateReport& report) {
  std::vector<std::string> lines = report.notes;
  if (report.Count(Verdict::kBetter) > 0) {
    lines.emplace_back(
        "better than the baseline by more than the tolerance: update the baseline to hold this "
        "level");
  }
  for (const TimeComparison& time : report.times) {
    if (time.verdict != Verdict::kWorse) continue;
    lines.push_back(StrCat(time.variant, " is slower than it was, measured in the time of ",
                           kTimeReference, " (not part of the verdict without --gate-time)"));
  }
  for (const std::string& problem : report.time_problems) lines.push_back(problem);
  return lines;
}

std::string AlignedText(const TextRows& rows) {
  if (rows.empty()) return "";
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const std::vector<std::string>& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], Width(row[i]));
  }
  std::string text;
  for (const std::vector<std::string>& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      text += row[i];
      if (i + 1 < row.size()) text.append(widths[i] - Width(row[i]) + 2, ' ');
    }
    text += '\n';
  }
  return text;
}

std::string PowerText(const std::vector<LostPart>& parts) {
  TextRows rows = {{"variant", "verdict", "values that differ", "worse in"}};
  for (const LostPart& part : parts) {
    std::vector<std::string> worse;
    for (const Comparison& comparison : part.report.comparisons) {
      if (comparison.verdict == Verdict::kWorse) AddOnce(comparison.metric, worse);
    }
    std::string why = Joined(worse, ", ");
    if (!part.report.problems.empty()) {
      why += StrCat(why.empty() ? "" : ", ", Counted(part.report.problems.size(), "problem"));
    }
    rows.push_back({part.variant, part.report.Failed() ? "noticed" : "NOT NOTICED",
                    StrCat(part.report.Differing(), " of ", part.report.comparisons.size()), why});
  }
  return AlignedText(rows);
}

std::string GateText(const GateReport& report) {
  std::string text = Headline(report) + "\n";
  const TextRows moved = MovedRows(report);
  if (!moved.empty()) text += StrCat("\n", AlignedText(moved));
  const TextRows times = TimeRows(report);
  if (!times.empty()) text += StrCat("\n", AlignedText(times));
  for (const auto& [title, lines] :
       {std::pair{"problems", ProblemLines(report)}, std::pair{"notes", NoteLines(report)}}) {
    if (!lines.empty()) text += StrCat("\n", title, ":\n");
    for (const std::string& line : lines) text += "  " + line + "\n";
  }
  return text;
}

}  // namespace cvo::reports
