// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/figures/suite/suite_parts.h"
#include "tests/reports/figures/drawn_suite.h"

namespace cvo::reports {
namespace {

using test::Json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

// Frames 10 to 13; the first has no estimate. Of the variants, only `full` estimates anything.
SuiteData Calibrated() {
  SuiteData data = test::DrawnSuite({"clustervo", "full"});
  for (DrawnRun& run : data.drawn) {
    std::vector<CameraFrame>& frames = run.detail.camera;
    frames.assign(4, CameraFrame());
    for (int i = 0; i < 4; ++i) {
      frames[i].frame = 10 + i;
      if (i == 0 || run.variant != "full") continue;
      frames[i].calibration = CalibrationState{{0.1 * i, 9.0}, {0.04, 9.0}};
    }
  }
  return data;
}

TEST(CalibrationFigure, ShowsTheMeanWithItsDeviation) {
  const SuiteData data = Calibrated();
  SuiteDrawing drawing;
  DrawCalibration(data, drawing);
  const Figure& figure = test::FindFigure(drawing, "calibration");
  const std::vector<Json> traces = test::TracesNamed(Json::parse(figure.plotly), "full");
  ASSERT_THAT(traces, SizeIs(3));
  EXPECT_EQ(traces[0]["y"], Json::parse("[0.06, 0.16, 0.26]"));
  EXPECT_EQ(traces[1]["y"], Json::parse("[0.14, 0.24, 0.34]"));
  EXPECT_EQ(traces[1]["fill"], "tonexty");
  EXPECT_EQ(traces[2]["x"], Json::parse("[11, 12, 13]"));
  EXPECT_EQ(traces[2]["y"], Json::parse("[0.1, 0.2, 0.3]"));
  EXPECT_THAT(figure.plotly, HasSubstr(data.drawn[0].sequence));
  EXPECT_THAT(figure.alt, HasSubstr("full 0.3 +- 0.04 px in the last frame."));
  EXPECT_THAT(figure.plotly, testing::Not(HasSubstr("clustervo")));
}

TEST(CalibrationFigure, IsNotDrawnWithoutAnEstimate) {
  SuiteDrawing drawing;
  DrawCalibration(test::DrawnSuite({"clustervo"}), drawing);
  EXPECT_THAT(drawing.figures, IsEmpty());
}

TEST(CalibrationFigure, SaysHowManySequencesAreLeftOut) {
  SuiteData data = Calibrated();
  const DrawnRun run = data.drawn.back();
  for (int i = 0; i < 7; ++i) {
    data.drawn.push_back(run);
    data.drawn.back().sequence = "room_" + std::to_string(i);
  }
  SuiteDrawing drawing;
  DrawCalibration(data, drawing);
  EXPECT_THAT(test::FindFigure(drawing, "calibration").caption,
              HasSubstr("Only the first 6 of 8 sequences are shown."));
}

}  // namespace
}  // namespace cvo::reports
