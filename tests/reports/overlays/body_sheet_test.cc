// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/body_sheet.h"

#include <gmock/gmock.h>

#include "reports/overlays/drawing/palette.h"
#include "tests/reports/overlays/overlay_scene.h"

namespace cvo::reports {
namespace {

// Two frames: in the first the body is detected and estimated, in the second it is lost.
BodyStory TwoFrames() {
  BodyStory story;
  story.body.cluster = 7;
  BodyFrame good;
  good.frame = 10;
  good.stage = BodyStage::kGood;
  good.error_m = 0.01;
  good.detected = true;
  good.landmarks = {{7, 5}};
  BodyFrame lost;
  lost.frame = 11;
  lost.stage = BodyStage::kLabel;
  lost.landmarks = {{0, 5}};
  story.frames = {good, lost};
  story.events = {{11, "lost"}};
  return story;
}

TEST(BodyTimeline, ColoursEachFrameByItsStage) {
  const cv::Mat timeline = BodyTimeline(TwoFrames(), 800, 9);
  EXPECT_EQ(timeline.cols, 800);
  EXPECT_GT(test::CountColor(timeline, ColorOf(BodyStage::kGood)), 3000);
  EXPECT_GT(test::CountColor(timeline, ColorOf(BodyStage::kLabel)), 3000);
  EXPECT_EQ(test::CountColor(timeline, ColorOf(BodyStage::kMotion)), 0);
}

TEST(BodyTimeline, SaysWhereBoxesAreNotKnown) {
  BodyStory story = TwoFrames();
  const cv::Mat known = BodyTimeline(story, 800, 9);
  story.frames[0].detected.reset();
  const cv::Mat unknown = BodyTimeline(story, 800, 9);
  constexpr Rgb kInk{190, 192, 198};
  EXPECT_GT(test::CountColor(unknown, kInk), test::CountColor(known, kInk) + 100);
}

TEST(BodySheet, ShowsAnEventAsTrueAndAsEstimated) {
  OverlayRun run;
  run.sequence.camera = test::FlatCamera();
  run.has_landmarks = true;
  run.detail.camera = {{10, 0, "tracked", {0, 0, 0, 0, 0, 0, 1}},
                       {11, 100'000'000, "tracked", {0, 0, 0, 0, 0, 0, 1}}};
  BodyDetail body;
  body.id = 3;
  body.cluster = 7;
  run.detail.bodies = {body};
  for (int i = 0; i < 5; ++i) {
    run.landmarks[11].push_back({100.0F + 10.0F * static_cast<float>(i), 100.0F, kStaticLabel, 3});
  }
  BodyStory story = TwoFrames();
  story.body = body;
  const cv::Mat sheet = BodySheet(run, story, {"why"}, {}, [](int) { return test::FlatImage(); });
  EXPECT_GT(sheet.rows, 400);
  // The landmarks belong to the cluster by their true body (left panel) only, not by their label.
  const cv::Mat left = sheet(cv::Rect(0, 200, sheet.cols / 2, sheet.rows - 200));
  const cv::Mat right = sheet(cv::Rect(sheet.cols / 2, 200, sheet.cols / 2, sheet.rows - 200));
  EXPECT_GT(test::CountColor(left, ClusterColor(7)), 20);
  EXPECT_EQ(test::CountColor(right, ClusterColor(7)), 0);
}

TEST(BodySheet, MarksTheTruePositionOfTheBody) {
  OverlayRun run;
  run.sequence.camera = test::FlatCamera();
  run.detail.camera = {{10, 0, "tracked", {0, 0, 0, 0, 0, 0, 1}},
                       {11, 100'000'000, "tracked", {0, 0, 0, 0, 0, 0, 1}}};
  BodyStory story = TwoFrames();
  const auto white = [&](const std::map<int, PixelBox>& boxes) {
    const cv::Mat sheet =
        BodySheet(run, story, {"why"}, boxes, [](int) { return test::FlatImage(); });
    return test::CountColor(sheet, {255, 255, 255});
  };
  const int without = white({});
  const int with_box = white({{11, {100, 80, 180, 140}}});
  EXPECT_GT(with_box, without + 500) << "in both panels";
  story.body.truth = {{11, {0, 0, 2, 0, 0, 0, 1}}};
  const int with_position = white({});
  EXPECT_GT(with_position, without + 100) << "a cross";
  EXPECT_LT(with_position, with_box);
}

TEST(DrawOverlay, BoxesWithoutAClusterAreDashed) {
  OverlayFrame frame;
  frame.detections = {{50, 50, 100, 100, 7}};
  OverlayStyle style = test::PlainStyle();
  style.associations = true;
  const cv::Mat owned = DrawOverlay(test::FlatImage(), frame, test::FlatCamera(), style);
  EXPECT_GT(test::CountColor(owned, ClusterColor(7)), 190);
  frame.detections[0].cluster = -1;
  const cv::Mat dashed = DrawOverlay(test::FlatImage(), frame, test::FlatCamera(), style);
  EXPECT_EQ(test::CountColor(dashed, ClusterColor(7)), 0);
  const int white = test::CountColor(dashed, kDetectionColor);
  EXPECT_GT(white, 50);
  EXPECT_LT(white, 150);
}

}  // namespace
}  // namespace cvo::reports
