// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "reports/figures/palette.h"
#include "reports/figures/suite/suite_parts.h"
#include "tests/reports/figures/drawn_suite.h"

namespace cvo::reports {
namespace {

using test::DrawnSuite;
using test::Json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

template <typename DrawFigures>
SuiteDrawing Drawn(DrawFigures draw, const SuiteData& data) {
  SuiteDrawing drawing;
  draw(data, drawing);
  return drawing;
}

// Returns the first trace whose `part` has this value at `key`, except traces without data. Null if
// there is none.
Json TraceLike(const Json& plotly, const char* part, const char* key, const std::string& value) {
  for (const Json& trace : plotly["data"]) {
    if (trace["x"][0].is_null() || !trace.contains(part)) continue;
    if (trace[part].value(key, "") == value) return trace;
  }
  return nullptr;
}

TEST(ErrorOverTime, DrawsEstimatedAndPredictedErrorsPerBody) {
  const SuiteDrawing drawing = Drawn(DrawErrorOverTime, DrawnSuite({"full"}));
  ASSERT_THAT(drawing.figures, SizeIs(1));
  const Figure& figure = drawing.figures[0];
  EXPECT_EQ(figure.id, "error-over-time-room");
  EXPECT_THAT(figure.title,
              AllOf(HasSubstr("on room, seed 1"), HasSubstr("aligned by the camera")));
  const Json plotly = Json::parse(figure.plotly);
  const Json estimated = TraceLike(plotly, "line", "dash", "solid");
  EXPECT_EQ(estimated["x"], Json({0, 1, 2, 4, 4})) << "broken where a frame is missing";
  EXPECT_EQ(estimated["y"], Json({1.0, 2.0, 3.0, nullptr, 5.0}));
  const Json predicted = TraceLike(plotly, "line", "dash", "dot");
  EXPECT_EQ(predicted["x"], Json({3}));
  EXPECT_EQ(predicted["y"], Json({4.0}));
  EXPECT_EQ(plotly["layout"]["yaxis"]["title"]["text"], "ball<br>error (cm)");
  EXPECT_EQ(plotly["layout"]["xaxis"]["title"]["text"], "frame");
}

TEST(ErrorOverTime, MarksBirthsSwitchesAndHiddenFrames) {
  const Figure figure = Drawn(DrawErrorOverTime, DrawnSuite({"full"})).figures.at(0);
  const Json plotly = Json::parse(figure.plotly);
  const Json birth = TraceLike(plotly, "marker", "symbol", "triangle-up-open");
  EXPECT_EQ(birth["x"], Json({1}));
  EXPECT_EQ(birth["y"], Json({2.0}));
  const Json change = TraceLike(plotly, "marker", "symbol", "x-thin-open");
  EXPECT_EQ(change["x"], Json({2}));
  EXPECT_EQ(change["y"], Json({3.0}));
  ASSERT_THAT(plotly["layout"]["shapes"], SizeIs(1));
  EXPECT_EQ(plotly["layout"]["shapes"][0]["x0"], 2.5);
  EXPECT_EQ(plotly["layout"]["shapes"][0]["x1"], 3.5);
  for (const char* entry : {"full", "predicted", "cluster begins", "identity switch"}) {
    EXPECT_THAT(test::TracesNamed(plotly, entry), SizeIs(1)) << entry;
  }
  EXPECT_THAT(figure.caption, HasSubstr("Shaded: the body is not visible"));
}

TEST(ErrorOverTime, DescribesTheErrorOfEachBodyAndVariant) {
  SuiteData data = DrawnSuite({"full", "static"});
  data.drawn[1].detail.bodies[0].estimated.clear();
  data.drawn[1].detail.bodies[0].predicted.clear();
  const Figure figure = Drawn(DrawErrorOverTime, data).figures.at(0);
  // sqrt((1 + 4 + 9 + 25) / 4) = 3.12
  EXPECT_THAT(figure.alt, HasSubstr("Ball, visible in 4 frames: full 3.1 cm root mean square, at "
                                    "most 5, in 4 frames and 1 predicted; static no estimate."));
  EXPECT_THAT(figure.caption, HasSubstr("Without an estimate of these bodies: static."));
  EXPECT_THAT(test::TracesNamed(Json::parse(figure.plotly), "static"), IsEmpty());
}

TEST(ErrorOverTime, IsLogarithmicWhereErrorsAreFarApart) {
  SuiteData data = DrawnSuite({"full", "2d"});
  EXPECT_FALSE(
      Json::parse(Drawn(DrawErrorOverTime, data).figures.at(0).plotly)["layout"]["yaxis"].contains(
          "type"));
  for (BodyPosition& position : data.drawn[1].detail.bodies[0].estimated) position.error_m *= 500.0;
  data.drawn[0].detail.bodies[0].estimated[0].error_m = 0.0;
  const Figure figure = Drawn(DrawErrorOverTime, data).figures.at(0);
  const Json plotly = Json::parse(figure.plotly);
  EXPECT_EQ(plotly["layout"]["yaxis"]["type"], "log");
  EXPECT_EQ(TraceLike(plotly, "line", "dash", "solid")["y"][0], 0.01) << "zero has no logarithm";
  EXPECT_THAT(figure.caption, HasSubstr("logarithmic"));
}

TEST(ErrorOverTime, ReportsUnknownData) {
  SuiteData data = DrawnSuite({"full"});
  data.drawn[0].switches.reset();
  EXPECT_THAT(Drawn(DrawErrorOverTime, data).figures.at(0).caption,
              HasSubstr("Identity switches not known, no landmarks.csv: full."));
  data.drawn[0].detail.bodies.clear();
  const SuiteDrawing none = Drawn(DrawErrorOverTime, data);
  EXPECT_THAT(none.figures, IsEmpty());
  EXPECT_THAT(none.not_drawn, ElementsAre(HasSubstr("Error over time on room: no moving body")));
}

TEST(Trajectories, AreSeenFromAboveWithOneScale) {
  const SuiteDrawing drawing = Drawn(DrawTrajectories, DrawnSuite({"full", "2d"}));
  ASSERT_THAT(drawing.figures, SizeIs(1));
  const Json plotly = Json::parse(drawing.figures[0].plotly);
  const Json& layout = plotly["layout"];
  EXPECT_EQ(layout["xaxis"]["title"]["text"], "x, right (m)");
  EXPECT_EQ(layout["yaxis"]["title"]["text"], "z, ahead (m)");
  EXPECT_EQ(layout["yaxis"]["scaleanchor"], "x");
  EXPECT_EQ(layout["yaxis2"]["matches"], "y") << "and with it the scale";
  EXPECT_FALSE(layout["yaxis2"].contains("scaleanchor")) << "Plotly warns of both";
  const Json truth = TraceLike(plotly, "line", "color", kTruthColour);
  EXPECT_EQ(truth["y"], Json({0.05, 0.25, 0.45, 0.65, 0.85})) << "z, not the height";
  const Json camera = TraceLike(plotly, "line", "color", Palette({"full"}).Of("full").colour);
  EXPECT_EQ(camera["x"], Json({0.0, 0.1, 0.2, 0.3, 0.4}));
  EXPECT_EQ(camera["y"], Json({0.0, 0.2, 0.4, 0.6, 0.8}));
  const Json starts = TraceLike(plotly, "marker", "symbol", "circle");
  EXPECT_EQ(starts["x"], Json({0.0, 1.0}));
  EXPECT_EQ(starts["y"], Json({0.05, 3.0}));
}

TEST(Trajectories, DescribeTheirErrors) {
  const Figure figure = Drawn(DrawTrajectories, DrawnSuite({"full"})).figures.at(0);
  EXPECT_THAT(figure.alt, HasSubstr("full: camera ends 5 cm from the truth; ball 2.8 cm off on "
                                    "average."));  // (1 + 2 + 3 + 5) / 4
}

TEST(Trajectories, ADriftingEstimateDoesNotChangeTheScale) {
  SuiteData data = DrawnSuite({"full"});
  data.drawn[0].detail.camera[4].world_from_camera[0] = 1000.0;
  const Figure figure = Drawn(DrawTrajectories, data).figures.at(0);
  EXPECT_LT(Json::parse(figure.plotly)["layout"]["xaxis"]["range"][1], 2.0);
  EXPECT_THAT(figure.caption, HasSubstr("leaves the part shown: full."));
  data.drawn[0].detail.camera.clear();
  data.drawn[0].detail.bodies.clear();
  EXPECT_THAT(Drawn(DrawTrajectories, data).not_drawn,
              ElementsAre("Trajectories on room: no poses."));
}

TEST(StageTimes, AreBarsWithTheMachineInTheCaption) {
  const SuiteDrawing drawing = Drawn(DrawStageTimes, DrawnSuite({"full", "2d"}));
  ASSERT_THAT(drawing.figures, SizeIs(1));
  const Figure& figure = drawing.figures[0];
  const Json plotly = Json::parse(figure.plotly);
  const auto front_end = test::TracesNamed(plotly, "front end, all variants");
  ASSERT_THAT(front_end, SizeIs(1));
  EXPECT_EQ(front_end[0]["x"], Json({20.0}));
  EXPECT_EQ(front_end[0]["error_x"]["array"], Json({10.0}));
  const auto full = test::TracesNamed(plotly, "full");
  ASSERT_THAT(full, SizeIs(1));
  EXPECT_EQ(full[0]["y"], Json({"track"}));
  EXPECT_EQ(full[0]["x"], Json({2.0}));
  EXPECT_FALSE(plotly["layout"].contains("xaxis2")) << "one axis for both panels";
  EXPECT_EQ(plotly["layout"]["xaxis"]["title"]["text"], "time per frame (ms)");
  EXPECT_THAT(figure.caption, HasSubstr("Measured on one of 3 GHz (here)."));
  EXPECT_THAT(figure.alt, HasSubstr("Full: track 2 ms."));
}

TEST(StageTimes, UseRunsThatComputeFeaturesOnlyAsAFallback) {
  SuiteData data = DrawnSuite({"full", "2d", "2d"});
  data.drawn[1].detail.stages = {{"track", 4.0, 4.0, 5.0}, {"frame", 9.0, 9.0, 9.0}};
  const Figure figure = Drawn(DrawStageTimes, data).figures.at(0);
  const Json plotly = Json::parse(figure.plotly);
  EXPECT_EQ(test::TracesNamed(plotly, "2d")[0]["x"], Json({4.0}));
  EXPECT_THAT(figure.caption, HasSubstr("Pale: all runs of full computed features"));
  EXPECT_THAT(figure.plotly, Not(HasSubstr("whole frame")));
}

TEST(StageTimes, DoNotMixMachines) {
  SuiteData data = DrawnSuite({"full", "2d", "2d3d"});
  data.drawn[1].detail.host = "there";
  const Figure figure = Drawn(DrawStageTimes, data).figures.at(0);
  EXPECT_THAT(test::TracesNamed(Json::parse(figure.plotly), "2d"), IsEmpty());
  EXPECT_THAT(figure.caption, HasSubstr("Runs on 1 other machines are left out."));
  for (DrawnRun& run : data.drawn) run.detail.stages.clear();
  EXPECT_THAT(Drawn(DrawStageTimes, data).not_drawn, ElementsAre(HasSubstr("timing.json")));
}

TEST(RunFigures, EscapeHostileNames) {
  const SuiteData data = DrawnSuite({"<i>v"}, "</script><img src=x onerror=alert(1)>");
  for (const auto& draw : {DrawErrorOverTime, DrawTrajectories, DrawStageTimes}) {
    const Figure figure = Drawn(draw, data).figures.at(0);
    EXPECT_THAT(figure.plotly, Not(HasSubstr("<")));
    EXPECT_THAT(Json::parse(figure.plotly).dump(), Not(HasSubstr("<i")));
    EXPECT_THAT(Json::parse(figure.plotly).dump(), Not(HasSubstr("<img")));
  }
}

}  // namespace
}  // namespace cvo::reports
