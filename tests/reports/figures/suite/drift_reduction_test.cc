// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/figures/suite/suite_parts.h"
#include "tests/reports/figures/drawn_suite.h"

namespace cvo::reports {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

// One run of a sequence with published results of MVO. The camera and, in one direction, a block
// have half of the drift of MVO.
SuiteData HalfOfMvo(int frames) {
  SuiteData data;
  RunSummary run;
  run.sequence.name = "swinging_4_unconstrained";
  run.sequence.frames = frames;
  MetricValue camera;
  camera.name = "camera_max_drift_first25";
  camera.value = 0.105;
  run.metrics = {camera};
  BodyRow block;
  block.name = "bottom left";
  block.max_drift = MaxDrifts();
  block.max_drift->first_motions = {0.495, 0.04067, 0.22968, 0.05498};
  run.bodies = RunBodies{{block}, {}};
  PlannedRun planned;
  planned.job = "job";
  data.runs.push_back({planned, "ok", "", "", run});
  DrawnRun drawn;
  drawn.variant = "full";
  drawn.job = "job";
  data.drawn.push_back(drawn);
  return data;
}

TEST(DriftReduction, IsInPercentOfPublishedDrift) {
  SuiteDrawing drawing;
  DrawDriftReduction(HalfOfMvo(500), drawing);
  ASSERT_THAT(drawing.figures, SizeIs(3)) << "MVO by two sources, and ClusterVO";
  const Figure figure = test::FindFigure(drawing, "drift-reduction-mvo-mvo-2018");
  EXPECT_THAT(figure.caption, HasSubstr("sources disagree"));
  const test::Json trace = test::Json::parse(figure.plotly)["data"][0];
  EXPECT_THAT(trace["z"], SizeIs(5)) << "the camera and four blocks";
  EXPECT_EQ(trace["z"][0], test::Json::parse("[-50.0, null, null, null]"));
  EXPECT_EQ(trace["z"][1], test::Json::parse("[null, null, null, null]"));
  EXPECT_EQ(trace["z"][3], test::Json::parse("[-50.0, 0.0, 100.0, 0.0]"));
  EXPECT_THAT(figure.alt, HasSubstr("full: camera −50 none none none; top left none"));
}

TEST(DriftReduction, IsDrawnOnlyForTheSameFrames) {
  SuiteDrawing drawing;
  DrawDriftReduction(HalfOfMvo(40), drawing);
  EXPECT_THAT(drawing.figures, IsEmpty());
  ASSERT_THAT(drawing.not_drawn, SizeIs(3));
  EXPECT_THAT(drawing.not_drawn[0], HasSubstr("frames 0:500 alone"));
}

TEST(DriftReduction, IsNotDrawnForOtherSequences) {
  SuiteData data = HalfOfMvo(500);
  data.runs[0].run->sequence.name = "room";
  SuiteDrawing drawing;
  DrawDriftReduction(data, drawing);
  EXPECT_THAT(drawing.figures, IsEmpty());
  EXPECT_THAT(drawing.not_drawn, IsEmpty());
}

}  // namespace
}  // namespace cvo::reports
