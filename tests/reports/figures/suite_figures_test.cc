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

TEST(Ablation, DrawsDifferencesWithIntervals) {
  const TwoVariants suite;
  const Figure figure = test::FindFigure(Draw(suite.Written()), "ablation");
  EXPECT_THAT(figure.title, HasSubstr("Paired difference from full."));
  ASSERT_THAT(figure.chart.panels, SizeIs(3)) << "one scene has no interval of the camera's ATE";
  const Panel& ate = figure.chart.panels[1];
  EXPECT_EQ(ate.title, "object ATE (cm)");
  EXPECT_THAT(ate.y.categories, ElementsAre("2d"));
  // Errors in common frames double in all seven bodies.
  const Series points = test::SeriesNamed(figure.chart, "worse").at(1);
  EXPECT_NEAR(points.data.at(0).x, 2.0, 1e-9);
  EXPECT_EQ(points.data[0].tip, "2d: 4 cm against 2 cm, 7 pairs");
}

TEST(Ablation, NeedsAReference) {
  TwoVariants suite;
  suite.table["reference"] = "";
  const SuiteFigures drawing = Draw(suite.Written());
  EXPECT_EQ(test::FindFigure(drawing, "ablation").name, "");
  EXPECT_THAT(drawing.not_drawn, Contains(HasSubstr("names no reference")));
}

TEST(SuiteFigures, ReportMissingResults) {
  SuiteResults suite;
  suite.table["reference"] = "full";
  suite.Plan("room", "full");
  suite.Plan("room", "2d");
  const SuiteFigures drawing = Draw(suite.Written());
  EXPECT_THAT(drawing.figures, IsEmpty());
  EXPECT_THAT(drawing.not_drawn, Contains(HasSubstr("Differences from the reference")));
}

TEST(SuiteFigures, NameEachMissingFileOnce) {
  const TwoVariants suite;
  const SuiteFigures drawing = Draw(suite.Written());
  std::size_t named = 0;
  for (const std::string& reason : drawing.not_drawn) {
    named += reason.find("frames") != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(named, 1U) << "the frames of these results cannot be read";
  SuiteResults readable;
  Json result = Result();
  result["frames"] = test::RunFiles().result["frames"];
  readable.Add(result, "full");
  readable.Add(result, "2d");
  EXPECT_THAT(Draw(readable.Written()).not_drawn,
              Contains("truth.json: no such file (2011_09_26_drive_0001 full seed 0 and 1 more "
                       "run)."));
}

TEST(SuiteFigures, DrawTheFirstRunOfAVariant) {
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
  EXPECT_EQ(data.drawn[0].job, "job0");
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
