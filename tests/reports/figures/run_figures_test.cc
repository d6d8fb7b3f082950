// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Figures about what single runs estimate frame by frame.
#include <gmock/gmock.h>

#include "reports/figures/suite_figures.h"
#include "tests/reports/figures/drawn_suite.h"

namespace cvo::reports {
namespace {

using test::DrawnSuite;
using test::SeriesNamed;
using test::XsOf;
using test::YsOf;
using testing::AllOf;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pointwise;
using testing::SizeIs;

template <typename AddFigures>
SuiteFigures Drawn(AddFigures add, const SuiteData& data) {
  SuiteFigures figures;
  add(data, figures);
  return figures;
}

TEST(ErrorOverTime, DrawsEstimatedAndPredictedErrorsPerBody) {
  const SuiteFigures drawn = Drawn(AddErrorOverTime, DrawnSuite({"full"}));
  ASSERT_THAT(drawn.figures, SizeIs(1));
  const Figure& figure = drawn.figures[0];
  EXPECT_EQ(figure.name, "error-over-time-room");
  EXPECT_THAT(figure.title,
              AllOf(HasSubstr("on room, seed 1."), HasSubstr("aligned by the camera")));
  const Series estimated = SeriesNamed(figure.chart, "full").at(0);
  EXPECT_THAT(XsOf(estimated), ElementsAre(0, 1, 2, -1, 4)) << "broken where a frame is missing";
  EXPECT_THAT(YsOf(estimated), Pointwise(DoubleEq(), {1.0, 2.0, 3.0, -1.0, 5.0}));
  // sqrt((1 + 4 + 9 + 25) / 4) = 3.12
  EXPECT_EQ(estimated.tip, "full: 3.1 cm root mean square in 4 frames");
  const Series& predicted = figure.chart.panels[0].series.at(1);
  EXPECT_EQ(predicted.look.dash, 4);
  EXPECT_THAT(XsOf(predicted), ElementsAre(3));
  EXPECT_THAT(YsOf(predicted), ElementsAre(4.0));
  EXPECT_EQ(figure.chart.panels[0].y.title, "ball error (cm)");
  EXPECT_EQ(figure.chart.panels[0].x.title, "frame");
}

TEST(ErrorOverTime, MarksHiddenFrames) {
  const Figure figure = Drawn(AddErrorOverTime, DrawnSuite({"full"})).figures.at(0);
  const std::vector<Shade>& shades = figure.chart.panels[0].shades;
  ASSERT_THAT(shades, SizeIs(1));
  EXPECT_EQ(shades[0].low, 2.5);
  EXPECT_EQ(shades[0].high, 3.5);
  EXPECT_THAT(ChartSvg(figure.chart), HasSubstr(">full<"));
  EXPECT_THAT(figure.caption, HasSubstr("Shaded: the body is not visible"));
}

TEST(ErrorOverTime, IsLogarithmicWhereErrorsAreFarApart) {
  SuiteData data = DrawnSuite({"full", "2d"});
  const auto scale = [&] {
    return Drawn(AddErrorOverTime, data).figures.at(0).chart.panels[0].y.scale;
  };
  EXPECT_EQ(scale(), AxisScale::kLinear);
  for (BodyPosition& position : data.drawn[1].detail.bodies[0].estimated) position.error_m *= 500.0;
  data.drawn[0].detail.bodies[0].estimated[0].error_m = 0.0;
  EXPECT_EQ(scale(), AxisScale::kLog);
  const Figure figure = Drawn(AddErrorOverTime, data).figures.at(0);
  EXPECT_EQ(YsOf(SeriesNamed(figure.chart, "full").at(0))[0], 0.01) << "zero has no logarithm";
  EXPECT_THAT(figure.caption, HasSubstr("logarithmic"));
}

TEST(ErrorOverTime, NeedsATrueBodyThatIsEstimated) {
  SuiteData data = DrawnSuite({"full"});
  data.drawn[0].detail.bodies.clear();
  const SuiteFigures none = Drawn(AddErrorOverTime, data);
  EXPECT_THAT(none.figures, IsEmpty());
  EXPECT_THAT(none.not_drawn, ElementsAre(HasSubstr("Error over time on room: no moving body")));
}

TEST(Trajectories, AreSeenFromAboveWithOneScale) {
  const SuiteFigures drawn = Drawn(AddTrajectories, DrawnSuite({"full", "2d"}));
  ASSERT_THAT(drawn.figures, SizeIs(1));
  const Chart& chart = drawn.figures[0].chart;
  ASSERT_THAT(chart.panels, SizeIs(2));
  const Panel& panel = chart.panels[0];
  EXPECT_EQ(panel.x.title, "x, right (m)");
  EXPECT_EQ(panel.y.title, "z, ahead (m)");
  EXPECT_TRUE(panel.equal_scale);
  EXPECT_TRUE(chart.share_x && chart.share_y);
  const Series truth = SeriesNamed(chart, "truth (camera bold)").at(0);
  EXPECT_THAT(YsOf(truth), Pointwise(DoubleEq(), {0.05, 0.25, 0.45, 0.65, 0.85}))
      << "z, not the height";
  EXPECT_EQ(panel.series[1].look.colour, PaletteOf(SuitePlan(), {"full"}).Line("full").colour);
  EXPECT_THAT(XsOf(panel.series[1]), Pointwise(DoubleEq(), {0.0, 0.1, 0.2, 0.3, 0.4}));
  const std::vector<Series> starts = SeriesNamed(chart, "start");
  EXPECT_THAT(XsOf(starts.at(1)), ElementsAre(1.0));
  EXPECT_THAT(YsOf(starts.at(1)), ElementsAre(3.0));
  EXPECT_EQ(starts.at(0).data[0].text, "camera");
  EXPECT_EQ(starts.at(1).data[0].text, "ball");
}

TEST(Trajectories, ADriftingEstimateDoesNotChangeTheScale) {
  SuiteData data = DrawnSuite({"full"});
  data.drawn[0].detail.camera[4].world_from_camera[0] = 1000.0;
  const Figure figure = Drawn(AddTrajectories, data).figures.at(0);
  EXPECT_LT(figure.chart.panels[0].x.high.value(), 2.0);
  data.drawn[0].detail.camera.clear();
  data.drawn[0].detail.bodies.clear();
  EXPECT_THAT(Drawn(AddTrajectories, data).not_drawn,
              ElementsAre("Trajectories on room: no poses."));
}

}  // namespace
}  // namespace cvo::reports
