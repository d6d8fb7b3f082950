// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include "reports/page/html.h"
#include "reports/page/page_parts.h"
#include "reports/page/quantity.h"
#include "reports/results/contract_text.h"
#include "reports/results/metric_catalogue.h"

namespace cvo::reports {
namespace {

struct Term {
  std::string name;
  std::string meaning;
};

// The terms that the page uses for estimators, statistics and runs.
std::vector<Term> Terms() {
  return {
      {"variant",
       "A version of the estimator. full is the complete method; the others omit or change one "
       "part."},
      {"cluster", "A set of landmarks that move together: the estimate of one object."},
      {"landmark", "A point in the scene that is seen in the images."},
      {"sequence", "A recorded or rendered image sequence with its ground truth."},
      {"seed",
       "Initial value of the random number generator. Runs that differ only in the seed show the "
       "random variation."},
      {"interval",
       "95 % confidence interval of a mean, by bootstrap over its scenes, or the bodies of a "
       "single "
       "scene. Seeds are averaged first."},
      {"split",
       "What scenes are used for: options were chosen on development scenes, results are reported "
       "on test scenes. Recorded images are given."},
      {"pair", "A scene (or body of a single scene) that is present in both rows of a difference."},
      {"occluded, predicted",
       "Hidden by another object; its pose is then given only by the motion model."},
      {"left out", "What is excluded from a value, and why."},
  };
}

std::string ContractHtml(const Contract& contract) {
  std::string html;
  for (const auto& [name, text] : ContractTexts(contract)) {
    html += "<li>" + Element("em", name) + ": " + Escaped(text) + "</li>\n";
  }
  return html.empty()
             ? ""
             : "<details><summary>Exact definition</summary><ul>\n" + html + "</ul></details>\n";
}

std::string Meaning(const std::string& metric) {
  const std::optional<MetricForm> form = FindForm(metric);
  if (!form) return "See the definition below.";
  std::string meaning = EntryOf(form->id).meaning;
  if (form->bodies == BodyGroup::kStanding) meaning += " Of objects that stand still.";
  if (form->bodies == BodyGroup::kPredicted) meaning += " Of frames in which it was predicted.";
  if (form->causal) meaning += " Causal: of the estimates at the time of each frame.";
  return meaning;
}

std::string MeasureHtml(const Column& column) {
  const std::string direction = BetterDirection(column.metric);
  std::string html = "<dt id=\"measure-" + Escaped(column.metric) + "\">" + Escaped(column.label);
  if (column.unit != "1" && !column.unit.empty()) html += " [" + Escaped(column.unit) + "]";
  html += "</dt>\n<dd>" + Escaped(Meaning(column.metric));
  if (!direction.empty()) html += direction == "lower" ? " Lower is better." : " Higher is better.";
  return html + ContractHtml(column.contract) + "</dd>\n";
}

std::string TermsHtml() {
  std::string html;
  for (const Term& term : Terms()) {
    html += Element("dt", term.name) + "\n" + Element("dd", term.meaning) + "\n";
  }
  return html;
}

}  // namespace

std::string GlossarySection(const PageContent& content) {
  std::string html = "<section id=\"glossary\">\n<h2>Terms and metrics</h2>\n<dl>\n" + TermsHtml();
  if (content.table) {
    for (const Column& column : content.table->columns) html += MeasureHtml(column);
  }
  return html + "</dl>\n</section>\n";
}

}  // namespace cvo::reports
