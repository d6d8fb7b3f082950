// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/figures/suite/suite_parts.h"
#include "tests/reports/figures/drawn_suite.h"

namespace cvo::reports {
namespace {

using test::Json;
using testing::IsEmpty;

// Frames 10 to 15 with a temporal track of two frames. The spatial track holds frame 10 at frames
// 12 and 13, and frame 12 at frame 15. Frame 14 is lost.
SuiteData Managed() {
  SuiteData data = test::DrawnSuite({"full"});
  std::vector<CameraFrame>& frames = data.drawn[0].detail.camera;
  frames.assign(6, CameraFrame());
  for (int i = 0; i < 6; ++i) {
    frames[i].frame = 10 + i;
    frames[i].window_frames = i == 0 ? 1 : i == 1 ? 2 : 3;
  }
  frames[2].spatial_ages = {2};
  frames[3].spatial_ages = {3};
  frames[4].window_frames = 0;
  frames[5].spatial_ages = {3};
  return data;
}

TEST(FrameTracks, ShowWhenEachFrameWasInEachTrack) {
  SuiteDrawing drawing;
  DrawFrameTracks(Managed(), drawing);
  const Json plotly = Json::parse(test::FindFigure(drawing, "frame-tracks").plotly);
  const Json spatial = test::TracesNamed(plotly, "spatial track").at(0);
  EXPECT_EQ(spatial["x"], Json::parse("[12, 13, null, 15, 15, null]"));
  EXPECT_EQ(spatial["y"], Json::parse("[10, 10, null, 12, 12, null]"));
  const Json newest = test::TracesNamed(plotly, "temporal track").at(0);
  EXPECT_EQ(newest["x"], Json::parse("[10, 11, 12, 13, 15]"));
  EXPECT_EQ(newest["y"], newest["x"]);
  EXPECT_EQ(plotly["data"][0]["y"], Json::parse("[10, 10, 11, 12, 13]")) << "its oldest frame";
}

TEST(FrameTracks, AreNotDrawnForOlderResults) {
  SuiteDrawing drawing;
  DrawFrameTracks(test::DrawnSuite({"full"}), drawing);
  EXPECT_THAT(drawing.figures, IsEmpty());
}

}  // namespace
}  // namespace cvo::reports
