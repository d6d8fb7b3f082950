// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/figures/numbers.h"
#include "reports/page/html.h"
#include "reports/page/page_parts.h"
#include "reports/statistics/estimate.h"

namespace cvo::reports {
namespace {

constexpr std::size_t kNamed = 12;  // any more are only counted

// The values of a key, in the order of the plan.
std::vector<std::string> ValuesOf(const std::vector<PageRun>& runs, const std::string& key) {
  std::vector<std::string> values;
  for (const PageRun& run : runs) AddOnce(KeyOf(run.run.planned, key), values);
  return values;
}

std::string Named(const std::vector<std::string>& values) {
  if (values.size() <= kNamed) return Listed(values);
  std::vector<std::string> first(values.begin(), values.begin() + kNamed);
  first.push_back(StrCat(values.size() - kNamed, " more"));
  return Listed(first);
}

std::string ComparedText(const PageContent& content, const Table& table) {
  std::string text;
  for (const std::string& key : table.keys) {
    if (key == "sequence" || key == "family") continue;
    const std::vector<std::string> values = ValuesOf(content.runs, key);
    const std::string counted = key == "variant"
                                    ? Counted(values.size(), "variant")
                                    : StrCat(Counted(values.size(), "value"), " of ", key);
    text += StrCat(text.empty() ? "Compares " : ", ", counted, " (", Named(values), ")");
  }
  std::set<std::uint64_t> seeds;
  for (const PageRun& run : content.runs) seeds.insert(run.run.planned.seed);
  const std::vector<std::string> sequences = ValuesOf(content.runs, "sequence");
  std::set<std::string> splits;
  for (const Row& row : table.rows) {
    if (!row.split.empty()) splits.insert(row.split);
  }
  return StrCat(text.empty() ? "On " : text + " on ", Counted(sequences.size(), "sequence"), " (",
                Named(sequences), sequences.size() == 1 ? ") with " : "), each with ",
                Counted(seeds.size(), "seed"), ".",
                splits.empty() ? "" : " Split: ", Listed({splits.begin(), splits.end()}),
                splits.empty() ? "" : ".");
}

std::string VariantsHtml(const std::vector<Fact>& variants) {
  if (variants.empty()) return "";
  std::string html = "<dl class=\"facts\">\n";
  for (const auto& [name, meaning] : variants) {
    html += Element("dt", name) + Element("dd", meaning) + "\n";
  }
  return html + "</dl>\n";
}

std::string JobsText(const JobCounts& jobs) {
  std::string text = StrCat(jobs.done, " of ", Counted(jobs.planned, "run"), " ",
                            jobs.done == 1 ? "is" : "are", " complete");
  const auto add = [&text](std::size_t count, const char* what) {
    if (count > 0) text += StrCat("; ", count, " ", what);
  };
  add(jobs.lost, "of them lost the camera");
  add(jobs.failed, "failed");
  add(jobs.not_run, "not run yet");
  add(jobs.no_data, "without their sequence");
  return text + (jobs.AllDone() && jobs.lost == 0 ? "; none failed." : ".");
}

std::string RuleText(const std::string& reference) {
  return StrCat(
      "Differences are relative to ", reference,
      ", over the pairs that both have. A difference is considered significant if its 95 % "
      "interval does not contain 0, its p-value, corrected for the number of comparisons in the "
      "table (Holm), is below 0.05, and there are at least ",
      kMinPairs,
      " pairs. Intervals cover the variation over scenes; where a row has only one scene, "
      "over its bodies.");
}

}  // namespace

std::string SummarySection(const PageContent& content) {
  std::string html = "<section id=\"summary\">\n<h2>Summary</h2>\n";
  if (!content.about.empty()) html += Element("p", content.about) + "\n";
  for (const std::string& problem : content.problems) {
    html += "<p class=\"problem\">" + Escaped(problem) + "</p>\n";
  }
  if (content.table) {
    const Table& table = *content.table;
    html += Element("p", ComparedText(content, table)) + "\n" + VariantsHtml(content.variants);
    html += "<p>" + Escaped(JobsText(table.jobs));
    html += table.problems.empty() ? "</p>\n"
                                   : " <a href=\"#missing\">What is missing, and why</a>.</p>\n";
    if (table.reference.empty()) {
      html += "<p>No row is the reference, so no differences are reported.</p>\n";
    } else {
      html += "<h2>Significant differences</h2>\n" + Element("p", RuleText(table.reference));
      const std::string findings = FindingsHtml(table, table.reference);
      html += findings.empty() ? "<p>There is nothing to compare yet.</p>\n" : findings;
    }
  }
  return html + "</section>\n";
}

std::string ComparisonSection(const PageContent& content) {
  if (content.compared_with.empty()) return "";
  std::string html = "<section id=\"comparison\">\n<h2>Compared with " +
                     Escaped(content.compared_with) + "</h2>\n";
  if (!content.comparison) {
    return html +
           "<p class=\"problem\">The two results cannot be compared: see above.</p>\n</section>\n";
  }
  html +=
      Element("p", StrCat("Differences between these results and those of ", content.compared_with,
                          ". Runs are paired by row, sequence and seed. ",
                          RuleText(content.compared_with)));
  html += FindingsHtml(*content.comparison, content.compared_with);
  return html + TableFrame(*content.comparison, "comparison") + "</section>\n";
}

}  // namespace cvo::reports
