// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.h"
#include "core/files/text/escape.h"
#include "core/files/text/number.h"
#include "core/files/text/utf8.h"
#include "reports/gate/gate_text.h"

namespace cvo::reports {
namespace {

std::string Escaped(const std::string& text) { return HtmlEscaped(Printable(text)); }

// `failure` is empty if the case passes.
std::string TestCase(const std::string& group, const std::string& name,
                     const std::string& failure) {
  const std::string start = StrCat("  <testcase classname=\"", Escaped(group), "\" name=\"",
                                   Escaped(name), "\" time=\"0\"");
  if (failure.empty()) return start + "/>\n";
  return StrCat(start, "><failure message=\"", Escaped(failure), "\"/></testcase>\n");
}

std::string Failure(const Comparison& comparison) {
  if (comparison.verdict != Verdict::kWorse) return "";
  return StrCat(FormatGeneral(comparison.now, 6), ", in the baseline ",
                FormatGeneral(comparison.baseline, 6), ": ",
                FormatSigned(comparison.difference(), 3), ", tolerance ",
                FormatGeneral(comparison.tolerance, 3));
}

}  // namespace

std::string GateJunit(const GateReport& report) {
  const std::string change = ChangeLine(report);
  const std::size_t others = report.problems.size() + (change.empty() ? 0 : 1);
  const std::string group = "clustervo." + report.suite;
  const std::string counts =
      StrCat("tests=\"", others + report.comparisons.size(), "\" failures=\"",
             others + report.Count(Verdict::kWorse), "\" errors=\"0\" skipped=\"0\" time=\"0\"");
  std::string text = StrCat("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites ", counts,
                            ">\n <testsuite name=\"", Escaped(group), "\" ", counts, ">\n");
  for (const Comparison& comparison : report.comparisons) {
    const std::string where = comparison.scene.empty() ? "" : " on " + comparison.scene;
    text += TestCase(StrCat(group, ".", comparison.variant), comparison.metric + where,
                     Failure(comparison));
  }
  for (const GateProblem& problem : report.problems) {
    text += TestCase(group, problem.where, problem.message);
  }
  if (!change.empty()) text += TestCase(group, "same values", change);
  std::string notes;
  for (const std::string& line : NoteLines(report)) notes += StrCat("\n", Escaped(line));
  if (!notes.empty()) text += StrCat("  <system-out>", notes, "\n  </system-out>\n");
  return text + " </testsuite>\n</testsuites>\n";
}

}  // namespace cvo::reports
