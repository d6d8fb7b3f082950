// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Figures about the values of the table over those of an option.
#include <gmock/gmock.h>

#include "reports/figures/suite_figures.h"
#include "tests/reports/figures/drawn_suite.h"

namespace cvo::reports {
namespace {

using test::XsOf;
using test::YsOf;
using testing::AllOf;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pointwise;
using testing::SizeIs;

SuiteFigures Draw(const SuiteData& data) {
  SuiteFigures figures;
  AddSensitivity(data, figures);
  return figures;
}

std::vector<Series> CurvesOf(const Figure& figure, const std::string& name) {
  return test::SeriesNamed(figure.chart, name);
}

TEST(Sensitivity, DrawsErrorAboveCoverageOverTheOption) {
  SuiteData data = test::SweptSuite("window.spatial", {3, 1, 2});
  data.table.provenance.options = {{"window.spatial", "2", {"1", "3"}}};
  const SuiteFigures drawn = Draw(data);
  ASSERT_THAT(drawn.figures, SizeIs(1));
  const Figure& figure = drawn.figures[0];
  EXPECT_EQ(figure.name, "sensitivity-window-spatial");
  EXPECT_EQ(figure.title,
            "Metrics over window.spatial. Object ATE: aligned by SE(3) over positions");
  const std::vector<Series> curves = CurvesOf(figure, "full");
  ASSERT_THAT(curves, SizeIs(2));
  EXPECT_THAT(XsOf(curves[0]), ElementsAre(1.0, 2.0, 3.0));
  EXPECT_THAT(YsOf(curves[0]), Pointwise(DoubleEq(), {20.0, 10.0 * 3, 10.0}));
  EXPECT_EQ(curves[0].data[0].tip, "full, 1: 20 cm (15 to 25)");
  EXPECT_THAT(YsOf(curves[1]), ElementsAre(50.0, 50.0, 50.0));
  EXPECT_EQ(figure.chart.panels[0].y.title, "object ATE (cm)");
  EXPECT_EQ(figure.chart.panels[1].y.title, "object coverage (%)");
  EXPECT_EQ(figure.chart.panels[1].x.title, "window.spatial");
  EXPECT_TRUE(figure.chart.share_x);
}

TEST(Sensitivity, DrawsIntervalsAsABandAndMarksTheDefault) {
  SuiteData data = test::SweptSuite("a.b", {1, 2});
  data.table.provenance.options = {{"a.b", "2", {"1"}}};
  const Figure figure = Draw(data).figures.at(0);
  const Panel& panel = figure.chart.panels[0];
  EXPECT_EQ(panel.series[0].kind, SeriesKind::kBand);
  EXPECT_NEAR(panel.series[0].data[1].y_interval->low, 15.0, 1e-9);
  EXPECT_NEAR(panel.series[0].data[1].y_interval->high, 25.0, 1e-9);
  EXPECT_EQ(panel.rule, 2.0);
  EXPECT_EQ(panel.rule_text, "default 2");
  EXPECT_THAT(figure.caption, AllOf(HasSubstr("95 %, bootstrap"), HasSubstr("the default, 2")));
  data.table.provenance.options.clear();
  EXPECT_THAT(Draw(data).figures.at(0).caption, HasSubstr("default of this option is not known"));
}

TEST(Sensitivity, HasALogAxisForLogSpacedValues) {
  const auto is_log = [](const std::vector<double>& values) {
    return Draw(test::SweptSuite("q", values)).figures.at(0).chart.panels[0].x.scale ==
           AxisScale::kLog;
  };
  EXPECT_TRUE(is_log({0.01, 0.1, 1, 10}));
  EXPECT_TRUE(is_log({1, 2, 3, 5, 8, 12}));
  EXPECT_FALSE(is_log({0, 1, 10, 100})) << "zero has no logarithm";
  EXPECT_FALSE(is_log({5, 10, 15, 20, 30, 40}));
  EXPECT_FALSE(is_log({0.5, 0.7, 0.9})) << "less than a decade";
  EXPECT_FALSE(is_log({1, 10}));
}

TEST(Sensitivity, DrawsErrorOverMeasuredCpuTime) {
  SuiteData data = test::SweptSuite("orb.features", {1000, 2000});
  data.table.columns.push_back(test::ColumnOf(kFrameCpu, kFrameCpu, "ms"));
  data.table.rows[0].cells.push_back(test::CellOf(30.0, 29.0, 31.0));
  data.table.rows[1].cells.push_back(test::CellOf(50.0, 49.0, 51.0));
  const Figure figure = Draw(data).figures.at(0);
  EXPECT_EQ(figure.name, "pareto");
  ASSERT_THAT(figure.chart.panels, SizeIs(2));
  const Panel& panel = figure.chart.panels[0];
  EXPECT_EQ(panel.x.title, "CPU per frame (ms)");
  EXPECT_EQ(panel.y.title, "object ATE (cm)");
  EXPECT_THAT(XsOf(panel.series.at(0)), ElementsAre(30.0, 50.0));
  EXPECT_THAT(YsOf(panel.series.at(0)), Pointwise(DoubleEq(), {10.0, 20.0}));
  EXPECT_EQ(panel.series[0].data[1].tip, "orb.features 2000");
}

TEST(Sensitivity, LeavesAGapWhereARowHasNoValue) {
  SuiteData data = test::SweptSuite("a", {1, 2, 4});
  data.table.rows[1].cells[0] = {};
  EXPECT_THAT(YsOf(CurvesOf(Draw(data).figures.at(0), "full").at(0)),
              Pointwise(DoubleEq(), {10.0, -1.0, 10.0 * 3}));
}

TEST(Sensitivity, DrawsNoSeriesOfOnePoint) {
  SuiteData data = test::SweptSuite("a.b_px", {1, 2, 3});
  data.table.keys = {"a.b_px", "variant"};
  for (std::size_t i = 0; i < 3; ++i) data.table.rows[i].keys.emplace_back(i < 2 ? "full" : "2d");
  const Figure figure = Draw(data).figures.at(0);
  EXPECT_THAT(CurvesOf(figure, "full"), SizeIs(2));
  EXPECT_THAT(CurvesOf(figure, "2d"), IsEmpty());
  EXPECT_EQ(figure.chart.panels[0].x.title, "a.b (px)");
}

TEST(Sensitivity, UsesDefaultsOfOtherOptionsWhenOneIsVariedAtATime) {
  SuiteData data = test::SweptSuite("a", {1, 2});
  data.table.keys = {"a", "b"};
  for (Row& row : data.table.rows) row.keys.emplace_back("default");
  Row other = data.table.rows[0];
  other.keys = {"default", "7"};
  data.table.rows.push_back(other);
  other.keys = {"default", "8"};
  data.table.rows.push_back(other);
  const SuiteFigures drawing = Draw(data);
  ASSERT_THAT(drawing.figures, SizeIs(2));
  EXPECT_THAT(XsOf(CurvesOf(drawing.figures[0], "full").at(0)), ElementsAre(1.0, 2.0));
  EXPECT_THAT(XsOf(CurvesOf(drawing.figures[1], "full").at(0)), ElementsAre(7.0, 8.0));
}

TEST(Sensitivity, DrawsOneLinePerValueOfOtherOptionsInAFullGrid) {
  SuiteData data = test::SweptSuite("a", {1, 2, 1, 2});
  data.table.keys = {"a", "b"};
  for (std::size_t i = 0; i < 4; ++i) data.table.rows[i].keys.emplace_back(i < 2 ? "7" : "8");
  const Figure figure = Draw(data).figures.at(0);
  EXPECT_THAT(YsOf(CurvesOf(figure, "b 7").at(0)), Pointwise(DoubleEq(), {10.0, 20.0}));
  EXPECT_THAT(YsOf(CurvesOf(figure, "b 8").at(0)), Pointwise(DoubleEq(), {10.0 * 3, 40.0}));
}

TEST(Sensitivity, ReportsWhyNothingIsDrawn) {
  EXPECT_THAT(Draw(test::SweptSuite("a", {1})).not_drawn, ElementsAre(HasSubstr("at least 2")));
  SuiteData many = test::SweptSuite("a", {1, 2});
  many.table.keys = {"a", "sequence"};
  const Row row = many.table.rows[0];
  many.table.rows.clear();
  for (int i = 0; i < 26; ++i) {
    many.table.rows.push_back(row);
    many.table.rows.back().keys = {i % 2 == 0 ? "1" : "2", "room " + std::to_string(i / 2)};
  }
  EXPECT_THAT(Draw(many).not_drawn, ElementsAre(HasSubstr("13 curves")));
}

}  // namespace
}  // namespace cvo::reports
