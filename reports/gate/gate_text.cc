// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <sstream>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "core/files/text/utf8.h"
#include "reports/gate/check_runs.h"
#include "reports/tables/table_texts.h"

namespace cvo::reports {
namespace {

using TextRows = std::vector<std::vector<std::string>>;  // the first is the header

constexpr std::size_t kMaxProblems = 20;

std::vector<std::string> Cells(const Comparison& comparison) {
  return {comparison.variant,
          comparison.scene.empty() ? "all" : comparison.scene,
          comparison.metric + (comparison.unit == "1" ? "" : " (" + comparison.unit + ")"),
          FormatGeneral(comparison.baseline, 4),
          FormatGeneral(comparison.now, 4),
          comparison.relative ? FormatSigned(100.0 * comparison.change(), 3) + " %"
                              : FormatSigned(comparison.change(), 3),
          ToleranceText(comparison),
          StrCat(comparison.pairs),
          NameOf(comparison.verdict)};
}

// The comparisons that moved beyond their tolerance.
TextRows MovedRows(const GateReport& report) {
  TextRows rows = {
      {"variant", "scene", "metric", "baseline", "now", "change", "tolerance", "pairs", "verdict"}};
  for (const Verdict verdict : {Verdict::kWorse, Verdict::kBetter}) {
    for (const Comparison& comparison : report.comparisons) {
      if (comparison.verdict == verdict) rows.push_back(Cells(comparison));
    }
  }
  return rows;
}

// Aligned columns after an empty line. Empty if there is only a header.
std::string BelowHeader(const TextRows& rows) {
  return rows.size() < 2 ? "" : "\n" + AlignedText(rows);
}

std::string ListText(const char* title, const std::vector<std::string>& lines) {
  std::string text = lines.empty() ? "" : StrCat("\n", title, ":\n");
  for (const std::string& line : lines) text += StrCat("  ", line, "\n");
  return text;
}

std::string Headline(const GateReport& report) {
  const std::string& commit = report.baseline_commit;
  return StrCat(report.suite, ": ", Counted(report.runs, "run"), " compared with those of ",
                commit.empty() ? "an unknown commit" : commit.substr(0, 12), ": ",
                report.Count(Verdict::kWorse), " worse, ", report.Count(Verdict::kBetter),
                " better, ", report.Count(Verdict::kWithin), " within tolerance, ",
                report.Count(Verdict::kSame), " the same",
                report.exact > 0 ? StrCat("; ", report.exact - report.changed, " of ", report.exact,
                                          " values equal to the last bit")
                                 : "",
                report.problems.empty() ? "" : ", " + Counted(report.problems.size(), "problem"));
}

}  // namespace

std::string ToleranceText(const Comparison& comparison) {
  if (!comparison.relative) return FormatGeneral(comparison.tolerance, 3);
  const double percent = 100.0 * comparison.tolerance;
  return percent < 1e4 ? FormatGeneral(percent, 3) + " %" : "any factor";
}

std::string NoticedText(const Baseline& baseline) {
  TextRows rows = {{"metric", "noticed from", "variant", "value"}};
  std::vector<Comparison> most;  // of each metric
  for (const Comparison& comparison : NoticedBy(baseline)) {
    if (comparison.verdict == Verdict::kBlind) continue;
    Comparison& known = FindOrAdd(most, &Comparison::metric, comparison);
    if (comparison.tolerance > known.tolerance) known = comparison;
  }
  for (const Comparison& comparison : most) {
    rows.push_back({comparison.metric, ToleranceText(comparison), comparison.variant,
                    FormatGeneral(comparison.baseline, 4)});
  }
  return "smallest change for the worse on every scene that a check on another platform notices, "
         "of the variant that needs most:\n" +
         BelowHeader(rows);
}

std::string GateVerdict(const GateReport& report) {
  return report.Regressed() ? "regression" : report.Failed() ? "changed" : "no regression";
}

std::string GateText(const GateReport& report) {
  std::vector<std::string> problems = report.problems;
  if (problems.size() > kMaxProblems) {
    problems.resize(kMaxProblems);
    problems.push_back(StrCat("and ", report.problems.size() - kMaxProblems, " more"));
  }
  if (report.changed > 0) {
    problems.insert(problems.begin(),
                    StrCat(report.changed, " of ", report.exact,
                           " values differ from the baseline: the estimator changed; if this is "
                           "intended, update the baseline"));
  }
  return StrCat(Headline(report), "\n", BelowHeader(MovedRows(report)),
                ListText("problems", problems), ListText("notes", report.notes));
}

std::string GateMarkdown(const GateReport& report) {
  std::string verdict = GateVerdict(report);
  verdict.front() = static_cast<char>(std::toupper(verdict.front()));
  // An indented block of code, whose lines no name in the results can leave or make active.
  std::istringstream lines(PrintableLines(GateText(report)));
  std::string markdown = StrCat("### ", verdict, "\n\n");
  for (std::string line; std::getline(lines, line);) markdown += "    " + line + "\n";
  return markdown;
}

std::string GateJunit(const GateReport& report) {
  const std::string name = HtmlEscaped(Printable(report.suite));
  const std::string text = HtmlEscaped(GateText(report));
  const std::string counts =
      StrCat("tests=\"1\" failures=\"", report.Failed() ? 1 : 0, "\" errors=\"0\" skipped=\"0\"");
  const std::string outcome = report.Failed() ? StrCat("<failure message=\"", GateVerdict(report),
                                                       "\">", text, "</failure>")
                                              : StrCat("<system-out>", text, "</system-out>");
  return StrCat("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites ", counts,
                ">\n <testsuite name=\"clustervo.", name, "\" ", counts,
                ">\n  <testcase classname=\"clustervo.", name, "\" name=\"gate\" time=\"0\">\n",
                outcome, "\n  </testcase>\n </testsuite>\n</testsuites>\n");
}

}  // namespace cvo::reports
