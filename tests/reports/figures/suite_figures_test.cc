// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figures/suite_figures.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "reports/tables/make_table.h"
#include "tests/reports/figures/drawn_suite.h"
#include "tests/reports/results/result_files.h"
#include "tests/reports/results/run_folder.h"

namespace cvo::reports {
namespace {

using test::BodyOf;
using test::Json;
using test::Result;
using test::SuiteResults;
using test::WithBodies;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

SuiteFigures Draw(const std::filesystem::path& folder) {
  return MakeSuiteFigures(ReadSuiteData(folder, MakeTable(folder, {}, "")));
}

// One sequence under "full" and "2d". Under "2d" the errors of the bodies are twice as large, and
// each body is estimated in one frame fewer.
struct TwoVariants : SuiteResults {
  explicit TwoVariants(const std::string& sequence = "room") {
    table["rows"] = {"variant"};
    table["reference"] = "full";
    Json bodies = Json::array();
    Json worse = Json::array();
    for (int id = 1; id <= 7; ++id) {
      bodies.push_back(BodyOf(id, {0.02, 0.02, 0.02, 0.02, -1.0}));
      worse.push_back(BodyOf(id, {0.04, 0.04, 0.04, -1.0, -1.0}));
    }
    Add(WithBodies(Result(sequence), bodies), "full", 1);
    Add(WithBodies(Result(sequence), worse), "2d", 1);
  }
};

TEST(Waterfall, HasABarPerRowStartingAtTheRowAbove) {
  SuiteData data = test::SweptSuite("variant", {1, 2, 3});
  data.table.reference = kRowAbove;
  const auto step = [&](std::size_t row, double low, double high) {
    const double before = data.table.rows[row - 1].cells[0].value;
    Difference difference;
    difference.value = before - 0.1;
    difference.reference_value = before;
    difference.difference = -0.1;
    difference.interval = Interval{low, high, ""};
    data.table.rows[row].keys = {row == 1 ? "paper_to_box_foot" : "full"};
    data.table.rows[row].cells[0].difference = difference;
  };
  step(1, -0.15, -0.05);
  step(2, -0.25, 0.05);
  const Figure figure = test::FindFigure(MakeSuiteFigures(data), "waterfall");
  ASSERT_THAT(figure.chart.panels, SizeIs(1));
  EXPECT_THAT(figure.chart.panels[0].x.categories, testing::ElementsAre("1.0", "box_foot", "full"));
  const Datum better = test::SeriesNamed(figure.chart, "better").at(0).data.at(0);
  EXPECT_EQ(better.x, 1.0);
  EXPECT_NEAR(better.base, 0.1, 1e-12);
  EXPECT_NEAR(better.y, 0.0, 1e-12);
  EXPECT_NEAR(better.y_interval->high, 0.05, 1e-12);
  EXPECT_EQ(better.tip, "box_foot: 0.1 to 0");
  EXPECT_EQ(test::SeriesNamed(figure.chart, "interval contains 0").at(0).data.at(0).x, 2.0);
  data.table.reference = "full";
  EXPECT_EQ(test::FindFigure(MakeSuiteFigures(data), "waterfall").name, "");
}

TEST(ErrorReduction, IsAHeatMapOfSequencesAndMeasures) {
  const TwoVariants suite;
  const Figure figure = test::FindFigure(Draw(suite.Written()), "error-reduction");
  EXPECT_THAT(figure.title, HasSubstr("Change in error relative to full, in percent"));
  ASSERT_THAT(figure.chart.panels, SizeIs(1));
  const Panel& map = figure.chart.panels[0];
  EXPECT_EQ(map.title, "2d");
  EXPECT_THAT(map.y.categories, ElementsAre("room")) << "all sequences are this one";
  EXPECT_THAT(map.x.categories,
              ElementsAre("camera ATE", "1 − object coverage", "object ATE", "not within 10 cm"));
  // Coverage falls from 4/5 to 3/5: the uncovered share doubles. Errors in common frames double.
  // Seven bodies, all alike, are distinguishable; one scene is not.
  std::vector<std::string> texts;
  for (const HeatCell& cell : map.cells) texts.push_back(cell.text);
  EXPECT_THAT(texts, ElementsAre("(0)", "+100", "+100", "+100"));
  EXPECT_EQ(map.cells[0].value, 0.0);
  EXPECT_EQ(map.cells[2].value, 1.0);
  EXPECT_EQ(map.cells[2].tip, "room, 2d, object ATE: 0.04 m against 0.02 m, 7 pairs");
}

TEST(ErrorReduction, ShowsLargeIncreasesAsAFactorAndTellsEqualLabelsApart) {
  test::SuiteResults suite;
  suite.table["rows"] = {"variant"};
  suite.table["reference"] = "full";
  for (const auto& [variant, error_m] : {std::pair{"full", 0.02}, {"2d", 0.3}}) {
    suite.Add(WithBodies(Result("room"), Json::array({BodyOf(1, {error_m, error_m})})), variant, 1);
  }
  SuiteData data = ReadSuiteData(suite.Written(), MakeTable(suite.Written(), {}, ""));
  for (Column& column : data.table.columns) {
    if (column.metric == "camera_ate") column.label = "object ATE";
  }
  const Panel map = test::FindFigure(MakeSuiteFigures(data), "error-reduction").chart.panels.at(0);
  EXPECT_EQ(std::count(map.x.categories.begin(), map.x.categories.end(), "object ATE (m)"), 2);
  std::vector<std::string> texts;
  for (const HeatCell& cell : map.cells) texts.push_back(cell.text);
  EXPECT_THAT(texts, Contains("(×15)"));
}

TEST(ErrorReduction, NeedsAReference) {
  TwoVariants suite;
  suite.table["reference"] = "";
  const SuiteFigures drawing = Draw(suite.Written());
  EXPECT_EQ(test::FindFigure(drawing, "error-reduction").name, "");
  EXPECT_THAT(drawing.not_drawn, Contains(HasSubstr("names no reference")));
}

TEST(ErrorOverCoverage, HasAMarkPerVariantAndAFaintOnePerSequence) {
  const TwoVariants suite;
  const Figure figure = test::FindFigure(Draw(suite.Written()), "error-over-coverage-object-ate");
  const Panel& panel = figure.chart.panels.at(0);
  ASSERT_THAT(panel.series, SizeIs(4));
  EXPECT_EQ(panel.series[0].look.opacity, 0.35);
  EXPECT_EQ(panel.series[0].data.at(0).tip, "full, room: 0.02 m (0.02 to 0.02) at 80 % (80 to 80)");
  const Series& mean = panel.series[3];
  EXPECT_EQ(mean.name, "2d");
  EXPECT_NEAR(mean.data.at(0).x, 60.0, 1e-9);
  EXPECT_NEAR(mean.data.at(0).y, 0.04, 1e-12);
  EXPECT_TRUE(mean.data[0].x_interval && mean.data[0].y_interval);
  EXPECT_EQ(panel.x.title, "object coverage (%)");
  EXPECT_EQ(panel.y.title, "object ATE (m)");
}

TEST(ErrorOverCoverage, FullCameraCoverageIsNotDrawn) {
  const TwoVariants suite;
  const SuiteFigures drawing = Draw(suite.Written());
  EXPECT_EQ(test::FindFigure(drawing, "error-over-coverage-camera-ate").name, "");
  EXPECT_THAT(drawing.not_drawn, Contains(HasSubstr("coverage is 100 % in all rows")));
}

TEST(SuiteFigures, ReportMissingResults) {
  SuiteResults suite;
  suite.table["reference"] = "full";
  suite.Plan("room", "full");
  suite.Plan("room", "2d");
  const SuiteFigures drawing = Draw(suite.Written());
  EXPECT_THAT(drawing.figures, IsEmpty());
  for (const char* what :
       {"Change in error", "Error over coverage of the object", "Time by stage"}) {
    EXPECT_THAT(drawing.not_drawn, Contains(HasSubstr(what))) << what;
  }
}

TEST(SuiteFigures, NameEachMissingFileOnce) {
  const TwoVariants suite;
  const SuiteFigures drawing = Draw(suite.Written());
  std::size_t named = 0;
  for (const std::string& reason : drawing.not_drawn) {
    named += reason.find("frames") != std::string::npos ? 1 : 0;
  }
  EXPECT_GE(named, 1U) << "the frames of these results cannot be read";
  SuiteResults readable;
  Json result = Result();
  result["frames"] = test::RunFiles().result["frames"];
  readable.Add(result, "full");
  readable.Add(result, "2d");
  EXPECT_THAT(Draw(readable.Written()).not_drawn,
              Contains("truth.json: no such file (2011_09_26_drive_0001 full seed 0 and 1 more "
                       "run)."));
}

TEST(SuiteFigures, DrawTheFirstSeedAtTheDefaults) {
  SuiteResults suite;
  suite.table["rows"] = {"q"};
  for (const auto& [value, seed] : {std::pair{1, 5}, {2, 5}, {2, 6}}) {
    Json result = Result();
    result["frames"] = test::RunFiles().result["frames"];
    result["options"] = {{"q", value}};
    suite.Add(result, "full", seed)["parameters"] = {{"q", value}};
  }
  const std::filesystem::path folder = suite.Written();
  const SuiteData data = ReadSuiteData(folder, MakeTable(folder, {}, R"({"q": 2})"));
  ASSERT_THAT(data.drawn, SizeIs(1));
  EXPECT_EQ(data.drawn[0].job, "job1");
  EXPECT_EQ(data.drawn[0].seed, 5U);
}

TEST(SuiteFigures, AreReproducibleWithUniqueNames) {
  SuiteData data = test::DrawnSuite({"full", "2d"});
  data.drawn[1].sequence = "ROOM";  // same name up to an appended number
  const SuiteFigures first = MakeSuiteFigures(data);
  const SuiteFigures again = MakeSuiteFigures(data);
  ASSERT_EQ(first.figures.size(), again.figures.size());
  std::set<std::string> names;
  for (std::size_t i = 0; i < first.figures.size(); ++i) {
    const Figure& figure = first.figures[i];
    EXPECT_EQ(ChartSvg(figure.chart), ChartSvg(again.figures[i].chart));
    EXPECT_TRUE(names.insert(figure.name).second) << figure.name;
    EXPECT_FALSE(figure.title.empty());
    EXPECT_FALSE(figure.caption.empty());
  }
  EXPECT_TRUE(names.contains("trajectories-room-2"));
}

TEST(SuiteFigures, OmitPerSequenceFiguresForTooManySequences) {
  SuiteData data = test::DrawnSuite({"full"});
  for (int i = 0; i < 401; ++i) {
    data.runs.push_back({data.plan.runs[0], "not run", "", "", std::nullopt});
    data.runs.back().planned.keys["sequence"] = "room " + std::to_string(i);
  }
  EXPECT_THAT(MakeSuiteFigures(data).not_drawn, Contains(HasSubstr("401 rows of the table")));
}

TEST(SuiteFigures, EscapeHostileNames) {
  const TwoVariants suite("<img src=x onerror=alert(1)>");
  const SuiteFigures drawing = Draw(suite.Written());
  ASSERT_THAT(drawing.figures, Not(IsEmpty()));
  for (const Figure& figure : drawing.figures) {
    EXPECT_THAT(ChartSvg(figure.chart), Not(HasSubstr("<img"))) << figure.name;
  }
}

}  // namespace
}  // namespace cvo::reports
