// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/formats/table_html.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files/text/utf8.h"
#include "tests/reports/tables/hostile_table.h"

namespace cvo::reports {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// Returns the first unescaped '<' within a tag or the first element that is not closed in order.
// Empty if there is neither.
std::string FirstFlaw(const std::string& html) {
  std::vector<std::string> open;
  std::size_t at = 0;
  while ((at = html.find('<', at)) != std::string::npos) {
    std::size_t end = at + 1;
    for (bool quoted = false; end < html.size() && (quoted || html[end] != '>'); ++end) {
      if (html[end] == '"') quoted = !quoted;
      if (!quoted && html[end] == '<') return "unescaped <: " + html.substr(at, 60);
    }
    const std::string tag = html.substr(at + 1, end - at - 1);
    const std::string name = tag.substr(0, tag.find_first_of(" >"));
    if (name[0] == '/') {
      if (open.empty() || open.back() != name.substr(1)) return "closes nothing: " + tag;
      open.pop_back();
    } else if (name != "meta" && name != "!DOCTYPE") {
      open.push_back(name);
    }
    at = end;
  }
  return open.empty() ? "" : "not closed: " + open.back();
}

// Returns the text from the first `begin` up to, without, the next `end`. Empty if there is no
// `begin`.
std::string Element(const std::string& html, const std::string& begin, const std::string& end) {
  const std::size_t at = html.find(begin);
  if (at == std::string::npos) return "";
  return html.substr(at, html.find(end, at) - at);
}

TEST(HtmlEscaped, LeavesNoMarkup) {
  EXPECT_EQ(HtmlEscaped("<a href=\"x\" b='y'>&amp;"),
            "&lt;a href=&quot;x&quot; b=&#39;y&#39;&gt;&amp;amp;");
}

TEST(TableHtml, IsWellFormedAndEscapesHostileNames) {
  const std::string html = TableHtml(test::HostileTable());
  EXPECT_EQ(FirstFlaw(html), "");
  EXPECT_THAT(html, AllOf(Not(HasSubstr("<script")), Not(HasSubstr("<b>")), Not(HasSubstr("<i>")),
                          HasSubstr("<th scope=\"row\">&lt;script&gt;alert(&quot;1&quot;)"),
                          HasSubstr("Suite &lt;b&gt;&amp;amp;&lt;/b&gt; 50 %"),
                          HasSubstr("killed &lt;i&gt;by&lt;/i&gt; signal 9")));
}

TEST(TableHtml, CellsHavePositionAndValueAttributes) {
  const std::string html = TableHtml(test::HostileTable());
  EXPECT_THAT(Element(html, "<td class=\"number best\" data-row=\"0\" data-column=\"3\"", "</td>"),
              AllOf(HasSubstr(" data-value=\"0.05761\""), HasSubstr(" data-low=\"0.034\""),
                    HasSubstr(" data-high=\"0.085\""),
                    HasSubstr("<strong><span class=\"value\">0.058</span></strong>"),
                    HasSubstr("<span class=\"interval\">0.034..0.085</span>"),
                    HasSubstr("<span class=\"n\">2 runs</span>")));
  EXPECT_THAT(html, AllOf(HasSubstr("<th scope=\"col\" class=\"number\" data-column=\"3\" "
                                    "data-metric=\"object_ate\" data-better=\"lower\">object ATE "
                                    "<span class=\"unit\">[m]</span></th>"),
                          HasSubstr("data-metric=\"object_coverage\" data-better=\"higher\"")));
  EXPECT_THAT(Element(html, "<td class=\"number distinguishable\" data-row=\"1\"", "</td>"),
              AllOf(HasSubstr("data-column=\"3\""), HasSubstr(">*</abbr>"),
                    HasSubstr("<span class=\"n\">11 bodies</span>")));
}

TEST(TableHtml, MissingCellsHaveAReasonAndNoNumber) {
  const std::string cell = Element(TableHtml(test::HostileTable()),
                                   "<td class=\"number missing\" data-row=\"1\"", "</td>");
  EXPECT_THAT(cell, AllOf(HasSubstr("<span class=\"value\">-</span>"), Not(HasSubstr("data-value")),
                          HasSubstr("<span class=\"reason\">no value in any run, &lt;i&gt;not")));
}

TEST(TableHtml, IncomparableReferenceFiguresAreGreyWithAReason) {
  const std::string html = TableHtml(test::HostileTable());
  EXPECT_THAT(
      Element(html, "<tr data-row=\"2\" data-reference=\"0\" class=\"reference\">", "</tr>"),
      AllOf(HasSubstr("Same &amp; co [a]"), HasSubstr("data-value=\"0.01\""),
            HasSubstr("data-match=\"matches\""), HasSubstr("inferred, not stated: poses")));
  EXPECT_THAT(
      Element(html, "<tr data-row=\"2\" data-reference=\"3\" class=\"reference grey\">", "</tr>"),
      AllOf(HasSubstr("class=\"number grey\""), HasSubstr("(0.04)"),
            HasSubstr("<span class=\"reason\">contract not stated: alignment</span>")));
  EXPECT_THAT(Element(html, "<tr data-row=\"2\" data-reference=\"4\"", "</tr>"),
              HasSubstr("<span class=\"reason\">alignment differs</span>"));
  EXPECT_THAT(Element(html, "<tr data-reference=\"0\" class=\"reference grey\">", "</tr>"),
              AllOf(HasSubstr("Rooms [b]"), HasSubstr("other scenes")));
  EXPECT_THAT(html, HasSubstr("<li>[a] a paper (CVPR &lt;2020&gt;) table_2; a caveat: 50 %"));
}

TEST(TableHtml, DifferencesAndDefinitionsFollow) {
  const std::string html = TableHtml(test::HostileTable(), "second");
  EXPECT_THAT(html, AllOf(HasSubstr("id=\"second-values\""), HasSubstr("id=\"second-differences\""),
                          HasSubstr("data-value=\"0.0467\""), HasSubstr("+0.047"),
                          HasSubstr("<li>camera ATE: root mean square of position errors</li>"),
                          HasSubstr("<li>object ATE: alignment world by the camera")));
}

}  // namespace
}  // namespace cvo::reports
