// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "reports/figures/suite/suite_parts.h"
#include "tests/reports/figures/drawn_suite.h"

namespace cvo::reports {
namespace {

using test::Json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

SuiteDrawing Draw(const SuiteData& data) {
  SuiteDrawing drawing;
  DrawSensitivity(data, drawing);
  return drawing;
}

TEST(Sensitivity, DrawsErrorAboveCoverageOverTheOption) {
  SuiteData data = test::SweptSuite("window.spatial", {3, 1, 2});
  data.table.provenance.options = {{"window.spatial", "2", {"1", "3"}}};
  const SuiteDrawing drawing = Draw(data);
  ASSERT_THAT(drawing.figures, SizeIs(1));
  const Figure& figure = drawing.figures[0];
  EXPECT_EQ(figure.id, "sensitivity-window-spatial-object-errors");
  EXPECT_EQ(figure.title,
            "Object errors over window.spatial. Object ATE: aligned by SE(3) over positions");
  const Json plotly = Json::parse(figure.plotly);
  const auto curves = test::TracesNamed(plotly, "full");
  ASSERT_THAT(curves, SizeIs(2));
  EXPECT_EQ(curves[0]["x"], Json({1.0, 2.0, 3.0}));
  EXPECT_EQ(curves[0]["y"], Json({0.2, 0.3, 0.1}));
  EXPECT_EQ(curves[0]["yaxis"], "y");
  EXPECT_EQ(curves[1]["y"], Json({50.0, 50.0, 50.0}));
  EXPECT_EQ(curves[1]["yaxis"], "y2");
  const Json& layout = plotly["layout"];
  EXPECT_EQ(layout["yaxis"]["title"]["text"], "object ATE<br>(m)");
  EXPECT_EQ(layout["yaxis2"]["title"]["text"], "object coverage<br>(%)");
  EXPECT_EQ(layout["yaxis2"]["title"]["font"]["size"], 11);
  EXPECT_EQ(layout["xaxis"]["title"]["text"], "window.spatial");
  EXPECT_EQ(layout["xaxis"]["anchor"], "y2") << "the lower panel carries the axis of both";
  EXPECT_GT(layout["yaxis"]["domain"][0], layout["yaxis2"]["domain"][1]);
  EXPECT_FALSE(layout.contains("title"));
  EXPECT_FALSE(layout.contains("paper_bgcolor"));
}

TEST(Sensitivity, DrawsIntervalsAsABandAndMarksTheDefault) {
  SuiteData data = test::SweptSuite("a.b", {1, 2});
  data.table.provenance.options = {{"a.b", "2", {"1"}}};
  const Figure figure = Draw(data).figures.at(0);
  const Json plotly = Json::parse(figure.plotly);
  const Json& band = plotly["data"][0];
  EXPECT_EQ(band["fill"], "toself");
  EXPECT_EQ(band["x"], Json({1.0, 2.0, 2.0, 1.0}));
  EXPECT_EQ(band["y"], Json({0.05, 0.15, 0.25, 0.15}));
  ASSERT_THAT(plotly["layout"]["shapes"], SizeIs(2));
  EXPECT_EQ(plotly["layout"]["shapes"][0]["x0"], 2.0);
  EXPECT_EQ(plotly["layout"]["annotations"][0]["text"], "default 2");
  EXPECT_THAT(figure.caption, AllOf(HasSubstr("95 %, by hand"), HasSubstr("the default, 2")));
}

TEST(Sensitivity, OmitsOverlappingTickLabels) {
  const SuiteData data = test::SweptSuite("q", {0.01, 0.011, 0.1, 1, 1.2, 10, 100});
  const Json layout = Json::parse(Draw(data).figures.at(0).plotly)["layout"];
  EXPECT_EQ(layout["xaxis"]["tickvals"].size(), 7U);
  EXPECT_EQ(layout["xaxis"]["ticktext"], Json({"0.01", "", "0.1", "1", "", "10", "100"}));
}

TEST(Sensitivity, HasALogAxisForLogSpacedValues) {
  SuiteData data = test::SweptSuite("q", {0.01, 1, 100});
  data.table.provenance.options = {{"q", "10", {}}};
  const Json layout = Json::parse(Draw(data).figures.at(0).plotly)["layout"];
  EXPECT_EQ(layout["xaxis"]["type"], "log");
  EXPECT_EQ(layout["xaxis"]["ticktext"], Json({"0.01", "1", "100"}));
  EXPECT_EQ(layout["shapes"][0]["x0"], 10.0);
  EXPECT_EQ(layout["annotations"][0]["x"], 1.0) << "annotations are placed by their logarithm";
  EXPECT_FALSE(
      Json::parse(Draw(test::SweptSuite("q", {1, 2, 3})).figures.at(0).plotly)["layout"]["xaxis"]
          .contains("type"));
}

TEST(Sensitivity, DescribesItsNumbersInWords) {
  const Figure figure = Draw(test::SweptSuite("a", {1, 2, 4})).figures.at(0);
  EXPECT_THAT(figure.alt, HasSubstr("Curves over a, 3 values from 1 to 4."));
  EXPECT_THAT(figure.alt,
              HasSubstr("Object ATE of full: 0.1 m (0.05 to 0.15) at 1, 0.3 m (0.25 to 0.35) at 4; "
                        "best 0.1 m (0.05 to 0.15) at 1."));
  EXPECT_THAT(figure.caption, HasSubstr("default of this option is not known"));
}

TEST(Sensitivity, LeavesAGapWhereARowHasNoValue) {
  SuiteData data = test::SweptSuite("a", {1, 2, 4});
  data.table.rows[1].cells[0] = {};
  const Json plotly = Json::parse(Draw(data).figures.at(0).plotly);
  EXPECT_EQ(test::TracesNamed(plotly, "full")[0]["y"], Json({0.1, nullptr, 0.3}));
}

TEST(Sensitivity, ReportsMissingCoverage) {
  SuiteData data = test::SweptSuite("a", {1, 2, 4});
  data.table.columns.pop_back();
  for (Row& row : data.table.rows) row.cells.pop_back();
  EXPECT_THAT(Draw(data).figures.at(0).caption, HasSubstr("no coverage for these metrics"));
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
  const SuiteDrawing drawing = Draw(data);
  ASSERT_THAT(drawing.figures, SizeIs(2));
  const Json first = Json::parse(drawing.figures[0].plotly);
  const Json second = Json::parse(drawing.figures[1].plotly);
  EXPECT_EQ(test::TracesNamed(first, "full")[0]["x"], Json({1.0, 2.0}));
  EXPECT_EQ(test::TracesNamed(second, "full")[0]["x"], Json({7.0, 8.0}));
}

TEST(Sensitivity, DrawsOneLinePerValueOfOtherOptionsInAFullGrid) {
  SuiteData data = test::SweptSuite("a", {1, 2, 1, 2});
  data.table.keys = {"a", "b"};
  for (std::size_t i = 0; i < 4; ++i) data.table.rows[i].keys.emplace_back(i < 2 ? "7" : "8");
  const Json plotly = Json::parse(Draw(data).figures.at(0).plotly);
  EXPECT_EQ(test::TracesNamed(plotly, "b 7")[0]["y"], Json({0.1, 0.2}));
  EXPECT_EQ(test::TracesNamed(plotly, "b 8")[0]["y"], Json({0.3, 0.4}));
}

TEST(Sensitivity, ReportsWhyNothingIsDrawn) {
  SuiteData pooled = test::SweptSuite("a", {1, 2});
  pooled.table.keys = {"variant"};
  for (Row& row : pooled.table.rows) row.keys = {"full"};
  const SuiteDrawing over = Draw(pooled);
  EXPECT_THAT(over.figures, IsEmpty());
  EXPECT_THAT(over.not_drawn, ElementsAre(AllOf(HasSubstr("Sensitivity to a"),
                                                HasSubstr("no rows by this option"))));
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

TEST(Sensitivity, EscapesHostileNames) {
  SuiteData data = test::SweptSuite("<img src=x>", {1, 2});
  data.table.columns[0].label = "<b>ATE";
  const Figure figure = Draw(data).figures.at(0);
  EXPECT_THAT(figure.plotly, testing::Not(HasSubstr("<")));
  const Json layout = Json::parse(figure.plotly)["layout"];
  EXPECT_EQ(layout["xaxis"]["title"]["text"], "&lt;img src=x&gt;");
  EXPECT_EQ(layout["yaxis"]["title"]["text"], "&lt;b&gt;ATE<br>(m)");
  EXPECT_EQ(figure.id, "sensitivity-img-src-x-object-errors");
}

}  // namespace
}  // namespace cvo::reports
