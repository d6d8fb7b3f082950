// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figures/suite/suite_figures.h"

#include <gmock/gmock.h>

#include <set>

#include "reports/figures/suite/error_reduction.h"
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
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

SuiteDrawing Draw(const std::filesystem::path& folder) {
  return SuiteFigures(ReadSuiteData(folder, MakeTable(folder, {}, "")));
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

TEST(ErrorReduction, IsInPercentOfTheReferenceError) {
  Cell cell = test::CellOf(0.2, 0.1, 0.3);
  const Column ate = test::ColumnOf("object_ate", "object ATE", "m");
  EXPECT_FALSE(ErrorReduction(cell, ate));
  cell.difference = Difference{"full", 0.3, 0.4, -0.1, {}, {}, {}, {}, {}, {}, true, 7, ""};
  EXPECT_NEAR(*ErrorReduction(cell, ate), 25.0, 1e-9);
  cell.difference->reference_value = 0.0;
  EXPECT_FALSE(ErrorReduction(cell, ate)) << "of no error nothing can be reduced";
}

TEST(ErrorReduction, OfAShareIsRelativeToItsComplement) {
  Cell cell = test::CellOf(0.9, 0.8, 1.0);
  const Column share = test::ColumnOf("object_success_10cm", "within 10 cm", "1");
  cell.difference = Difference{"full", 0.9, 0.8, 0.1, {}, {}, {}, {}, {}, {}, true, 7, ""};
  EXPECT_NEAR(*ErrorReduction(cell, share), 50.0, 1e-9);  // misses: from 0.2 to 0.1
  cell.difference->difference = -0.2;
  EXPECT_NEAR(*ErrorReduction(cell, share), -100.0, 1e-9);
}

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
    data.table.rows[row].keys = {row == 1 ? "clustervo_to_box_foot" : "full"};
    data.table.rows[row].cells[0].difference = difference;
  };
  step(1, -0.15, -0.05);
  step(2, -0.25, 0.05);
  const Figure figure = test::FindFigure(SuiteFigures(data), "waterfall");
  const Json plotly = Json::parse(figure.plotly);
  const Json better = test::TracesNamed(plotly, "better").at(0);
  EXPECT_EQ(better["x"], Json({"box_foot"}));
  EXPECT_EQ(better["base"], Json({0.1}));
  EXPECT_EQ(better["y"], Json({-0.1}));
  EXPECT_EQ(better["error_y"]["array"], Json({0.05}));
  EXPECT_EQ(test::TracesNamed(plotly, "interval contains 0").at(0)["x"], Json({"full"}));
  EXPECT_THAT(figure.alt, HasSubstr("Object ATE: better by box_foot; worse by none."));
  data.table.reference = "full";
  EXPECT_EQ(test::FindFigure(SuiteFigures(data), "waterfall").plotly, "");
}

TEST(ErrorReduction, IsAHeatMapOfSequencesAndMeasures) {
  const TwoVariants suite;
  const Figure figure = test::FindFigure(Draw(suite.Written()), "error-reduction");
  EXPECT_THAT(figure.title, HasSubstr("Change in error relative to full, in percent"));
  const Json plotly = Json::parse(figure.plotly);
  ASSERT_THAT(plotly["data"], SizeIs(1));
  const Json& map = plotly["data"][0];
  EXPECT_EQ(map["y"], Json({0}));
  const Json& rows = plotly["layout"]["yaxis"];
  EXPECT_EQ(rows["ticktext"], Json({"<b>2d</b>", "room"})) << "all sequences are this one";
  EXPECT_EQ(rows["tickvals"], Json({-1, 0}));
  EXPECT_EQ(rows["range"], Json({0.5, -1.5})) << "the name of the block is above its rows";
  EXPECT_EQ(map["x"], Json({0, 1, 2, 3}));
  EXPECT_EQ(plotly["layout"]["xaxis"]["ticktext"], Json({"camera<br>ATE", "1 − object<br>coverage",
                                                         "object<br>ATE", "not within<br>10 cm"}));
  // Coverage falls from 4/5 to 3/5: the uncovered share doubles. Errors in common frames double.
  EXPECT_EQ(map["z"], Json::parse("[[0.0,100.0,100.0,100.0]]"));
  EXPECT_EQ(map["text"][0][2], "<b>+100</b>") << "seven bodies, all alike: distinguishable";
  EXPECT_EQ(map["text"][0][0], "(0)") << "one scene cannot tell";
  EXPECT_EQ(plotly["layout"]["coloraxis"]["cmin"], -100.0);
  EXPECT_EQ(plotly["layout"]["coloraxis"]["cmax"], 100.0);
  EXPECT_EQ(plotly["layout"]["coloraxis"]["cmid"], 0);
  EXPECT_EQ(rows["title"]["text"], "");
  EXPECT_GE(figure.least_px, 4 * 40) << "numbers of a phone's columns would cover each other";
  EXPECT_LT(figure.least_px, figure.width_px);
  EXPECT_THAT(figure.alt, HasSubstr("2d: 3 of 4 cells are distinguishable, at most 100 % more"));
}

TEST(ErrorReduction, ShowsLargeIncreasesAsAFactor) {
  test::SuiteResults suite;
  suite.table["rows"] = {"variant"};
  suite.table["reference"] = "full";
  for (const auto& [variant, error_m] : {std::pair{"full", 0.02}, {"2d", 0.3}}) {
    suite.Add(WithBodies(Result("room"), Json::array({BodyOf(1, {error_m, error_m})})), variant, 1);
  }
  const Json plotly =
      Json::parse(test::FindFigure(Draw(suite.Written()), "error-reduction").plotly);
  const Json& map = plotly["data"][0];
  EXPECT_THAT(map["text"][0], testing::Contains("(×15)"));
  EXPECT_THAT(map["z"][0], testing::Contains(1400.0));
}

// Plotly merges categories of equal names into one column, which would move the columns after it
// under wrong names.
TEST(ErrorReduction, MetricsWithEqualLabelsHaveSeparateColumns) {
  const TwoVariants suite;
  SuiteData data = ReadSuiteData(suite.Written(), MakeTable(suite.Written(), {}, ""));
  for (Column& column : data.table.columns) {
    if (column.metric == "camera_ate") column.label = "object ATE";
  }
  const Figure figure = test::FindFigure(SuiteFigures(data), "error-reduction");
  const Json plotly = Json::parse(figure.plotly);
  EXPECT_EQ(plotly["data"][0]["x"], Json({0, 1, 2, 3}));
  const Json& names = plotly["layout"]["xaxis"]["ticktext"];
  EXPECT_EQ(names[0], "object ATE<br>(m)");
  EXPECT_EQ(names[2], "object ATE<br>(m)");
}

TEST(ErrorReduction, NeedsAReference) {
  TwoVariants suite;
  suite.table["reference"] = "";
  const SuiteDrawing drawing = Draw(suite.Written());
  EXPECT_EQ(test::FindFigure(drawing, "error-reduction").id, "");
  EXPECT_THAT(drawing.not_drawn, Contains(HasSubstr("names no reference")));
}

TEST(ErrorOverCoverage, HasAMarkPerVariantAndAFaintOnePerSequence) {
  const TwoVariants suite;
  const Figure figure = test::FindFigure(Draw(suite.Written()), "error-over-coverage-object-ate");
  const Json plotly = Json::parse(figure.plotly);
  ASSERT_THAT(plotly["data"], SizeIs(4));
  EXPECT_EQ(plotly["data"][0]["marker"]["opacity"], 0.35);
  EXPECT_EQ(plotly["data"][0]["text"], Json({"room"}));
  EXPECT_EQ(plotly["data"][3]["name"], "2d");
  EXPECT_EQ(plotly["data"][3]["x"], Json({60.0}));
  EXPECT_EQ(plotly["data"][3]["y"], Json({0.04}));
  EXPECT_EQ(plotly["layout"]["xaxis"]["title"]["text"], "object coverage (%)");
  EXPECT_EQ(plotly["layout"]["yaxis"]["title"]["text"], "object ATE (m)");
  EXPECT_THAT(figure.alt, HasSubstr("2d: 0.04 m (0.04 to 0.04) at 60 % (60 to 60) coverage."));
}

TEST(ErrorOverCoverage, FullCameraCoverageIsNotDrawn) {
  const TwoVariants suite;
  const SuiteDrawing drawing = Draw(suite.Written());
  EXPECT_EQ(test::FindFigure(drawing, "error-over-coverage-camera-ate").id, "");
  EXPECT_THAT(drawing.not_drawn, Contains(HasSubstr("coverage is 100 % in all rows")));
}

TEST(SuiteFigures, ReportMissingResults) {
  SuiteResults suite;
  suite.table["reference"] = "full";
  suite.Plan("room", "full");
  suite.Plan("room", "2d");
  const SuiteDrawing drawing = Draw(suite.Written());
  EXPECT_THAT(drawing.figures, IsEmpty());
  for (const char* what :
       {"Change in error", "Error over coverage of the object", "Time by stage"}) {
    EXPECT_THAT(drawing.not_drawn, Contains(HasSubstr(what))) << what;
  }
}

TEST(SuiteFigures, NameEachMissingFileOnce) {
  const TwoVariants suite;
  const SuiteDrawing drawing = Draw(suite.Written());
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
                       "runs)."));
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

TEST(SuiteFigures, AreReproducibleWithUniqueIds) {
  SuiteData data = test::DrawnSuite({"full", "2d"});
  data.drawn[1].sequence = "ROOM";  // same id up to an appended number
  const SuiteDrawing first = SuiteFigures(data);
  const SuiteDrawing again = SuiteFigures(data);
  ASSERT_EQ(first.figures.size(), again.figures.size());
  std::set<std::string> ids;
  for (std::size_t i = 0; i < first.figures.size(); ++i) {
    const Figure& figure = first.figures[i];
    EXPECT_EQ(figure.plotly, again.figures[i].plotly);
    EXPECT_TRUE(ids.insert(figure.id).second) << figure.id;
    EXPECT_GT(figure.width_px, 0);
    EXPECT_GT(figure.height_px, 0);
    EXPECT_FALSE(figure.alt.empty());
    EXPECT_FALSE(figure.caption.empty());
  }
  EXPECT_TRUE(ids.contains("trajectories-room-2"));
}

TEST(SuiteFigures, OmitPerSequenceFiguresForTooManySequences) {
  SuiteData data = test::DrawnSuite({"full"});
  for (int i = 0; i < 401; ++i) {
    data.runs.push_back({data.plan.runs[0], "not run", "", "", std::nullopt});
    data.runs.back().planned.keys["sequence"] = "room " + std::to_string(i);
  }
  EXPECT_THAT(SuiteFigures(data).not_drawn, Contains(HasSubstr("401 rows of the table")));
}

TEST(SuiteFigures, EscapeHostileNames) {
  const TwoVariants suite("<img src=x onerror=alert(1)>");
  const SuiteDrawing drawing = Draw(suite.Written());
  ASSERT_THAT(drawing.figures, Not(IsEmpty()));
  for (const Figure& figure : drawing.figures) {
    EXPECT_THAT(figure.plotly, Not(HasSubstr("<")));
    EXPECT_THAT(Json::parse(figure.plotly).dump(), Not(HasSubstr("<img"))) << figure.id;
  }
}

}  // namespace
}  // namespace cvo::reports
