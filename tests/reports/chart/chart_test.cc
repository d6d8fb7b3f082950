// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/chart/chart.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <regex>

namespace cvo::reports {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();

Chart OnePanel(const Panel& panel) {
  Chart chart;
  chart.panels = {panel};
  return chart;
}

Panel LinePanel(const std::vector<Datum>& data) {
  Panel panel;
  panel.x.title = "frame";
  panel.y.title = "error (cm)";
  panel.series = {{SeriesKind::kLine, "full", {1}, data}};
  return panel;
}

// All texts that are drawn, in order.
std::vector<std::string> TextsOf(const std::string& svg) {
  std::vector<std::string> texts;
  const std::regex text("<text[^>]*>([^<]*)</text>");
  for (std::sregex_iterator it(svg.begin(), svg.end(), text), end; it != end; ++it) {
    texts.push_back((*it)[1]);
  }
  return texts;
}

std::size_t Count(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

TEST(Chart, IsAnSvgOfTheWidthAndFontGiven) {
  const Chart chart = OnePanel(LinePanel({{0, 0}, {1, 1}}));
  ChartStyle style;
  style.width_mm = 85;
  style.font = "Times \"New\"";
  style.font_size_pt = 7;
  const std::string svg = ChartSvg(chart, style);
  EXPECT_THAT(svg, AllOf(StartsWith("<svg xmlns=\"http://www.w3.org/2000/svg\""),
                         HasSubstr("width=\"85mm\""), HasSubstr("viewBox=\"0 0 240.94 "),
                         HasSubstr("font-family=\"Times &quot;New&quot;\" font-size=\"7\"")));
  EXPECT_EQ(svg, ChartSvg(chart, style)) << "the same bytes";
  EXPECT_EQ(Count(svg, "<g"), Count(svg, "</g>"));
  EXPECT_EQ(Count(svg, "<svg"), Count(svg, "</svg>"));
}

TEST(Chart, TakesColoursFromVariablesOfThePageAndElseFromItself) {
  const std::string svg = ChartSvg(OnePanel(LinePanel({{0, 0}, {1, 1}})));
  EXPECT_THAT(svg, AllOf(HasSubstr(".chart-s1{stroke:var(--chart-1,#0072b2)}"),
                         HasSubstr("class=\"chart-s1\" fill=\"none\" stroke=\"#0072b2\""),
                         HasSubstr("var(--chart-ink,#222222)"), Not(HasSubstr(" id="))));
  ChartStyle bare;
  bare.css = false;
  EXPECT_THAT(ChartSvg(OnePanel(LinePanel({{0, 0}, {1, 1}})), bare), Not(HasSubstr("<style")));
}

TEST(Chart, BreaksLinesAtGapsAndKeepsTheirEnds) {
  const std::string svg =
      ChartSvg(OnePanel(LinePanel({{0, 0}, {1, 1}, {kGap, kGap}, {3, 1}, {3.00001, 1}})));
  std::smatch path;
  ASSERT_TRUE(std::regex_search(svg, path, std::regex(" d=\"(M[^\"]*L[^\"]*M[^\"]*)\"")));
  EXPECT_EQ(Count(path[1], "M"), 2U);
}

TEST(Chart, LabelsNiceValues) {
  Panel panel = LinePanel({{0, 0}, {100, 0.3}});
  panel.x.low = 0.0;
  panel.x.high = 100.0;
  panel.y.from_zero = true;
  const auto texts = TextsOf(ChartSvg(OnePanel(panel)));
  EXPECT_THAT(texts, ElementsAre("full", "0", "20", "40", "60", "80", "100", "frame", "0.0", "0.1",
                                 "0.2", "0.3", "error (cm)"));
}

TEST(Chart, LabelsIntegersAtIntegers) {
  const auto texts = TextsOf(ChartSvg(OnePanel(LinePanel({{1, 0}, {2, 0.1}, {3, 0.2}}))));
  EXPECT_THAT(texts,
              AllOf(testing::IsSupersetOf({"1", "2", "3", "0.10"}), Not(testing::Contains("1.5"))));
}

TEST(Chart, HasLogarithmicAxesWithoutValuesThatHaveNoLogarithm) {
  Panel panel = LinePanel({{0.01, 0}, {1, 1}, {100, 2}});
  panel.x.scale = AxisScale::kLog;
  EXPECT_THAT(TextsOf(ChartSvg(OnePanel(panel))),
              testing::IsSupersetOf({"0.01", "0.1", "1", "10", "100"}));
  panel.x.ticks = {0.01, 0.011, 100};
  const auto texts = TextsOf(ChartSvg(OnePanel(panel)));
  EXPECT_THAT(texts, testing::IsSupersetOf({"0.01", "100"}));
  EXPECT_THAT(texts, Not(testing::Contains("0.011"))) << "it would cover 0.01";
  panel.series[0].data[0].x = 0.0;
  EXPECT_THAT(ChartSvg(OnePanel(panel)), Not(HasSubstr("nan")));
}

TEST(Chart, LowPanelsHaveTwoTicksAndWholeTitles) {
  Panel panel = LinePanel({{0, 3}, {1, 60}});
  panel.title = "a_variant_with_a_name_that_is_longer_than_a_panel";
  panel.y = {"within 10 cm (%)", AxisScale::kLog};
  panel.aspect = 0.01;
  Chart chart = OnePanel(panel);
  chart.panels.push_back(panel);
  chart.columns = 2;
  ChartStyle style;
  style.width_mm = 84.0;
  const std::string svg = ChartSvg(chart, style);
  EXPECT_THAT(TextsOf(svg), testing::IsSupersetOf({"within 10 cm", "(%)", "5", "10", "50"}));
  EXPECT_THAT(TextsOf(svg), Not(testing::Contains(panel.title)));
  std::smatch at;
  ASSERT_TRUE(std::regex_search(svg, at, std::regex("x=\"([-0-9.]+)\"[^>]*>within 10 cm<")));
  EXPECT_GT(std::stod(at[1]), 7.0) << "the line is not cut";
}

TEST(Chart, EscapesTextsAndWritesValuesAsTooltips) {
  Panel panel = LinePanel({{0, 0, "<b>1 & 2"}});
  panel.title = "</text><script>";
  const std::string svg = ChartSvg(OnePanel(panel));
  EXPECT_THAT(svg, AllOf(HasSubstr("<title>&lt;b&gt;1 &amp; 2</title>"),
                         HasSubstr("&lt;/text&gt;&lt;script&gt;"), Not(HasSubstr("<script"))));
}

TEST(Chart, DrawsIntervalsAsABandAndNamesCategories) {
  Panel panel;
  panel.y.scale = AxisScale::kCategory;
  panel.y.categories = {"a", "a longer name"};
  panel.series = {{SeriesKind::kBand, "band", {2}, {{0, 2}, {1, 1}}}};
  for (Datum& datum : panel.series[0].data) datum.y_interval = ValueRange{datum.y, datum.y + 1.0};
  const std::string svg = ChartSvg(OnePanel(panel));
  EXPECT_EQ(Count(svg, "fill=\"#d55e00\""), 1U);
  EXPECT_THAT(TextsOf(svg), testing::IsSupersetOf({"a", "a longer name"}));
}

TEST(Chart, PathsOfEqualScaleAreNotDistorted) {
  Panel panel = LinePanel({{0, 0}, {10, 0}, {10, 5}});
  panel.equal_scale = true;
  panel.aspect = 2.0;
  const std::string svg = ChartSvg(OnePanel(panel));
  std::smatch path;
  const std::string number = "([0-9.]+)";
  ASSERT_TRUE(std::regex_search(svg, path,
                                std::regex(" d=\"M" + number + " " + number + "L[0-9. ]+L" +
                                           number + " [0-9.]+L[0-9.]+ " + number)));
  const double across = std::stod(path[3]) - std::stod(path[1]);
  const double up = std::stod(path[2]) - std::stod(path[4]);
  EXPECT_NEAR(across / up, 2.0, 1e-3);
}

TEST(Chart, PanelsThatShareAnAxisAreLabelledOnce) {
  Chart chart = OnePanel(LinePanel({{0, 0}, {1, 1}}));
  chart.panels.push_back(LinePanel({{0, 0}, {4, 1}}));
  EXPECT_EQ(Count(ChartSvg(chart), ">frame<"), 2U);
  chart.share_x = true;
  EXPECT_EQ(Count(ChartSvg(chart), ">frame<"), 1U);
  EXPECT_EQ(Count(ChartSvg(chart), ">full</text>"), 1U) << "one entry in the legend";
}

TEST(Chart, TextsBesideMarksDoNotCoverEachOther) {
  Panel panel;
  panel.series = {{SeriesKind::kPoints, "", {1, Symbol::kCircle}, {}}};
  for (int i = 0; i < 9; ++i) panel.series[0].data.push_back({0.0, 1e-9 * i, "", "label"});
  panel.series[0].data.push_back({1.0, 1.0, "", "far"});
  const auto texts = TextsOf(ChartSvg(OnePanel(panel)));
  EXPECT_THAT(texts, testing::Contains("far"));
  EXPECT_LT(std::count(texts.begin(), texts.end(), "label"), 5);
}

TEST(Chart, DrawsTitleAndCaptionInLinesIfThereAreAny) {
  Chart chart = OnePanel(LinePanel({{0, 0}, {1, 1}}));
  chart.title = "What it is. How it is measured";
  for (int i = 0; i < 40; ++i) chart.caption += "many words ";
  const auto texts = TextsOf(ChartSvg(chart));
  EXPECT_THAT(texts, testing::IsSupersetOf({"What it is", "How it is measured"}));
  EXPECT_THAT(texts, testing::Contains(HasSubstr("many words")).Times(testing::Gt(1)));
}

TEST(Chart, AnEmptyChartHasAxes) {
  EXPECT_THAT(ChartSvg(OnePanel({})), AllOf(HasSubstr("chart-axis"), Not(HasSubstr("nan"))));
  EXPECT_THAT(ChartSvg({}), StartsWith("<svg"));
}

}  // namespace
}  // namespace cvo::reports
