// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests drawings on a uniform image pixel by pixel.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "reports/overlays/drawing/text_plate.h"
#include "reports/overlays/encode.h"
#include "reports/overlays/overlay_run.h"
#include "reports/overlays/sheet.h"
#include "tests/reports/overlays/overlay_scene.h"
#include "tests/support/error_message.h"

namespace cvo::reports {
namespace {

using test::ColorAt;
using test::CountColor;
using test::Cube;
using test::FlatCamera;
using test::FlatImage;
using test::PlainStyle;
using test::SameImage;
using testing::HasSubstr;

const Rgb kBackground{test::kGrey, test::kGrey, test::kGrey};

cv::Mat Draw(const OverlayFrame& frame, const OverlayStyle& style = PlainStyle()) {
  return DrawOverlay(FlatImage(), frame, FlatCamera(), style);
}

TEST(DrawOverlay, AnEmptyFrameIsTheImage) {
  EXPECT_EQ(CountColor(Draw({}), kBackground), 320 * 240);
}

TEST(DrawOverlay, ALandmarkHasTheColorOfItsCluster) {
  OverlayFrame frame;
  frame.landmarks = {{50.0F, 60.0F, 2}, {90.0F, 60.0F, 3}, {130.0F, 60.0F, 2}};
  const cv::Mat picture = Draw(frame);
  EXPECT_EQ(ColorAt(picture, 50, 60), ClusterColor(2));
  EXPECT_EQ(ColorAt(picture, 90, 60), ClusterColor(3));
  EXPECT_EQ(ColorAt(picture, 130, 60), ClusterColor(2));
  EXPECT_EQ(ColorAt(picture, 70, 60), kBackground);
}

TEST(DrawOverlay, StaticLandmarksAreSmallAndOutliersSmaller) {
  const auto touched = [](std::int64_t label) {
    OverlayFrame frame;
    frame.landmarks = {{50.0F, 60.0F, label}};
    return 320 * 240 - CountColor(Draw(frame), kBackground);
  };
  EXPECT_EQ(touched(kOutlierLabel), 5);  // one pixel, and its smoothed edge in four neighbours
  EXPECT_GT(touched(kStaticLabel), touched(kOutlierLabel));
  EXPECT_GT(touched(4), touched(kStaticLabel));
}

TEST(DrawOverlay, ScalesPositionsWithTheImage) {
  OverlayFrame frame;
  frame.landmarks = {{49.5F, 59.5F, 2}};  // pixel centres at integers: the corner of four pixels
  OverlayStyle style = PlainStyle();
  style.scale = 2.0;
  const cv::Mat picture = Draw(frame, style);
  EXPECT_EQ(picture.size(), cv::Size(640, 480));
  EXPECT_EQ(ColorAt(picture, 99, 119), ClusterColor(2));
  EXPECT_EQ(ColorAt(picture, 100, 120), ClusterColor(2));
}

TEST(DrawOverlay, BoxEdgesAreAtTheirProjections) {
  OverlayFrame frame;
  frame.clusters = {Cube(2)};
  const cv::Mat picture = Draw(frame);
  // Near face: 0.5 m at 2 m depth is 50 px from the centre. Far face: 0.5 / 3 * 200 px.
  EXPECT_EQ(ColorAt(picture, 110, 120), ClusterColor(2));
  EXPECT_EQ(ColorAt(picture, 210, 120), ClusterColor(2));
  EXPECT_EQ(ColorAt(picture, 160, 170), ClusterColor(2));
  EXPECT_EQ(ColorAt(picture, 160, 120), kBackground);
  EXPECT_EQ(ColorAt(picture, 100, 120), kBackground);
}

TEST(DrawOverlay, AGhostIsDashedAndTranslucent) {
  OverlayFrame frame;
  frame.clusters = {Cube(2)};
  OverlayStyle style = PlainStyle();
  style.names = false;
  const cv::Mat tracked = Draw(frame, style);
  frame.clusters[0].predicted = true;
  const cv::Mat ghost = Draw(frame, style);
  int solid = 0;
  int dashed = 0;
  for (int v = 75; v < 165; ++v) {
    // The edges of dashes are smoothed, so pixels of nearly the colour count too.
    const int blue = ClusterColor(2).blue;
    solid += std::abs(ColorAt(tracked, 110, v).blue - blue) < 30 ? 1 : 0;
    dashed += std::abs(ColorAt(ghost, 110, v).blue - blue) < 30 ? 1 : 0;
  }
  EXPECT_EQ(solid, 90);
  EXPECT_GT(dashed, 30);
  EXPECT_LT(dashed, 70);
  // The cluster's colour over the background, 28 % opaque.
  const Rgb inside = ColorAt(ghost, 160, 120);
  EXPECT_NEAR(inside.green, 0.72 * test::kGrey + 0.28 * ClusterColor(2).green, 1.5);
  EXPECT_NEAR(inside.blue, 0.72 * test::kGrey + 0.28 * ClusterColor(2).blue, 1.5);
  EXPECT_EQ(ColorAt(tracked, 160, 120), kBackground);
}

TEST(DrawOverlay, ClustersBehindTheCameraAreNotDrawn) {
  OverlayFrame frame;
  frame.clusters = {Cube(2, 0.0, -4.0)};
  frame.clusters[0].ahead = {0.0, 0.0, -1.0};
  frame.clusters[0].trail = {{0.0, 0.0, 3.0}, {0.0, 0.0, 1.0}};
  EXPECT_TRUE(SameImage(Draw(frame), Draw({})));
  frame.clusters[0].predicted = true;
  EXPECT_TRUE(SameImage(Draw(frame), Draw({})));
}

TEST(DrawOverlay, BoxAroundTheCameraIsClippedAtTheNearPlane) {
  OverlayFrame frame;
  frame.clusters = {Cube(2, 0.45, -0.5)};
  frame.clusters[0].predicted = true;
  const cv::Mat picture = Draw(frame);
  EXPECT_EQ(picture.size(), cv::Size(320, 240));
  EXPECT_FALSE(SameImage(picture, Draw({})));
}

TEST(DrawOverlay, ArrowPointsInTheDirectionOfMotion) {
  OverlayFrame frame;
  frame.clusters = {Cube(2, 0.0, 1.5)};  // centre at 2 m
  frame.clusters[0].ahead = {0.8, 0.0, 2.0};
  OverlayStyle style = PlainStyle();
  style.names = false;
  const cv::Mat picture = Draw(frame, style);
  EXPECT_EQ(ColorAt(picture, 190, 120), ClusterColor(2));
  EXPECT_EQ(ColorAt(picture, 230, 120), ClusterColor(2));
  EXPECT_EQ(ColorAt(picture, 130, 120), kBackground);
  EXPECT_EQ(ColorAt(picture, 260, 120), kBackground);
}

TEST(DrawOverlay, TrailShowsPastPositions) {
  OverlayFrame frame;
  frame.clusters = {Cube(2, 0.0, 1.5)};
  frame.clusters[0].trail = {{-0.9, 0.0, 2.0}, {-0.3, 0.0, 2.0}};
  const cv::Mat picture = Draw(frame);
  EXPECT_EQ(ColorAt(picture, 130, 120), ClusterColor(2));
  EXPECT_EQ(ColorAt(picture, 70, 120), ClusterColor(2));
}

TEST(DrawOverlay, DetectionIsAThinWhiteRectangle) {
  OverlayFrame frame;
  frame.detections = {{40.2, 50.4, 80.0, 90.0}};
  const cv::Mat picture = Draw(frame);
  EXPECT_EQ(ColorAt(picture, 40, 70), kDetectionColor);
  EXPECT_EQ(ColorAt(picture, 60, 50), kDetectionColor);
  EXPECT_EQ(ColorAt(picture, 60, 70), kBackground);
}

TEST(DrawOverlay, WrongLabelsHaveARingIfRequested) {
  OverlayFrame frame;
  frame.landmarks = {{50.0F, 60.0F, 2, 0, true}, {90.0F, 60.0F, 2, 5, false}};
  OverlayStyle style = PlainStyle();
  style.wrong = true;
  const cv::Mat picture = Draw(frame, style);
  EXPECT_EQ(ColorAt(picture, 50, 60), ClusterColor(2));
  const Rgb white{255, 255, 255};
  EXPECT_GT(CountColor(picture, white), 4);
  EXPECT_EQ(CountColor(Draw(frame), white), 0);
}

TEST(DrawOverlay, ColorIdsReplaceClusterIds) {
  OverlayFrame frame;
  frame.landmarks = {{50.0F, 60.0F, 2}};
  frame.color_ids = {{2, 5}};
  EXPECT_EQ(ColorAt(Draw(frame), 50, 60), ClusterColor(5));
}

TEST(DrawOverlay, HandlesNonFiniteAndHugeInput) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kHuge = 1e300;
  OverlayFrame frame;
  frame.landmarks = {{1e9F, -1e9F, 2}, {std::nanf(""), 4.0F, 0}, {-2.0F, 241.0F, 3}};
  frame.detections = {{-1e9, -1e9, 1e9, 1e9}, {kNan, 0.0, 4.0, 4.0}};
  for (const double x : {kNan, kHuge, -kHuge, 1e6, -1.7}) {
    frame.clusters.push_back(Cube(static_cast<std::int64_t>(frame.clusters.size()), x));
    frame.clusters.back().predicted = frame.clusters.size() % 2 == 0;
    frame.clusters.back().ahead = {kHuge, kNan, 1.0};
    frame.clusters.back().trail = {{x, x, 1.0}};
    frame.clusters.back().category =
        std::string("\x01<b>\n\xF0\x9F\x9A\x97") + std::string(999, 'W');
  }
  frame.clusters.back().id = std::numeric_limits<std::int64_t>::min();
  frame.status = std::string(5000, 'x');
  OverlayStyle style = PlainStyle();
  style.status = true;
  const cv::Mat picture = Draw(frame, style);
  EXPECT_EQ(picture.size(), cv::Size(320, 240 + BarHeight(style.text_px, 1)));
}

TEST(DrawOverlay, RefusesAnImageOfAnotherSize) {
  const cv::Mat small(24, 32, CV_8UC1, cv::Scalar(0));
  EXPECT_THAT(ErrorMessage([&] { DrawOverlay(small, {}, FlatCamera(), PlainStyle()); }),
              testing::AllOf(HasSubstr("32x24"), HasSubstr("expected 320x240")));
  const cv::Mat deep(240, 320, CV_16UC1, cv::Scalar(0));
  EXPECT_THAT(ErrorMessage([&] { DrawOverlay(deep, {}, FlatCamera(), PlainStyle()); }),
              HasSubstr("1 x 16 bits"));
}

TEST(DrawOverlay, IsReproducible) {
  OverlayFrame frame;
  frame.clusters = {Cube(2), Cube(3, 0.8)};
  frame.landmarks = {{50.0F, 60.0F, 2}};
  const OverlayStyle style = StyleFor(FlatCamera(), 320);
  EXPECT_EQ(PngBytes(Draw(frame, style)), PngBytes(Draw(frame, style)));
  EXPECT_EQ(JpegBytes(Draw(frame, style), 60), JpegBytes(Draw(frame, style), 60));
}

TEST(StatusWords, CountWhatIsDrawn) {
  OverlayFrame frame;
  frame.frame = 12;
  frame.time_s = 0.4;
  frame.status = "tracked";
  frame.run = "full, seed 1";
  frame.has_landmarks = frame.has_clusters = true;
  frame.landmarks = {{1, 1, 0}, {1, 1, 0}, {1, 1, 7}, {1, 1, kOutlierLabel}};
  frame.clusters = {Cube(2), Cube(3, 0.0, -9.0)};
  frame.clusters[1].predicted = true;
  EXPECT_THAT(StatusWords(frame, FlatCamera()),
              testing::ElementsAre("frame 12", "0.40 s", "camera tracked",
                                   "bodies 1 + 1 predicted (1 out of view)",
                                   "landmarks 2 static, 1 on bodies, 1 outliers", "full, seed 1"));
  frame.has_landmarks = frame.has_clusters = false;
  EXPECT_THAT(StatusWords(frame, FlatCamera()),
              testing::IsSupersetOf({"bodies not recorded", "landmarks not recorded"}));
}

TEST(DrawableText, ReplacesCharactersTheFontLacks) {
  EXPECT_EQ(DrawableText("Car", 16), "Car");
  EXPECT_EQ(DrawableText("a\tb\x7F", 16), "a?b?");
  EXPECT_EQ(DrawableText("Stra\xC3\x9F"
                         "e",
                         16),
            "Stra?e");
  EXPECT_EQ(DrawableText("abcdefgh", 6), "abcd..");
  EXPECT_EQ(DrawableText("", 6), "");
}

TEST(ClusterColor, IsFixedPerIdAndDistinctBetweenIds) {
  EXPECT_EQ(ClusterColor(5), ClusterColor(5));
  constexpr auto kCount = static_cast<std::int64_t>(kClusterColors);
  for (std::int64_t a = 1; a <= kCount; ++a) {
    const Rgb x = ClusterColor(a);
    EXPECT_GT(std::max({x.red, x.green, x.blue}) - std::min({x.red, x.green, x.blue}), 60)
        << "grey, as images are: " << a;
    for (std::int64_t b = 1; b < a; ++b) {
      const Rgb y = ClusterColor(b);
      const int apart =
          std::abs(x.red - y.red) + std::abs(x.green - y.green) + std::abs(x.blue - y.blue);
      EXPECT_GT(apart, 80) << a << " and " << b;
    }
  }
  EXPECT_EQ(ClusterColor(1), ClusterColor(1 + kCount));
  EXPECT_EQ(TextColorOn({255, 255, 0}), (Rgb{0, 0, 0}));
  EXPECT_EQ(TextColorOn({20, 20, 20}), (Rgb{255, 255, 255}));
}

TEST(DrawNames, AvoidLandmarksAndEachOther) {
  OverlayFrame frame;
  frame.clusters = {Cube(2)};
  const OverlayStyle style = PlainStyle();
  const cv::Size size = PlateSize("2 Crate", style.text_px);
  const cv::Rect usual(110, 70 - size.height, size.width, size.height);  // above the box
  const auto covered = [&](const cv::Mat& picture) {
    return CountColor(picture(usual), ClusterColor(2));
  };
  EXPECT_GT(covered(Draw(frame, style)), usual.area() / 2);
  for (int i = 0; i < 12; ++i) {
    frame.landmarks.push_back({112.0F + 5.0F * static_cast<float>(i), 62.0F, 3});
  }
  EXPECT_LT(covered(Draw(frame, style)), usual.area() / 4);
  OverlayFrame two;
  two.clusters = {Cube(2), Cube(3)};
  const cv::Mat picture = Draw(two, style);
  EXPECT_GT(CountColor(picture, ClusterColor(2)), size.area() / 2) << "not covered by the other";
  EXPECT_GT(CountColor(picture, ClusterColor(3)), size.area() / 2);
}

TEST(Legend, HasEveryMarkOfTheStyleAndOneSizeForAllFrames) {
  OverlayStyle style = PlainStyle();
  style.legend = true;
  OverlayFrame frame;
  const cv::Mat empty = Draw(frame, style);
  EXPECT_GT(empty.rows, 240);
  frame.clusters = {Cube(2)};
  EXPECT_EQ(Draw(frame, style).size(), empty.size());
  const Rgb mark = ClusterColor(2);
  const int with_boxes = CountColor(LegendBar(style, 320), mark);
  style.boxes = false;
  EXPECT_LT(CountColor(LegendBar(style, 320), mark), with_boxes / 2);
  EXPECT_LT(LegendBar(style, 320).rows, LegendBar(PlainStyle(), 320).rows);
  EXPECT_GT(LegendBar(style, 100).rows, LegendBar(style, 800).rows) << "in rows";
}

// At the image size of KITTI, a busy frame needs two status rows, so every frame has two.
TEST(StatusLine, HasRoomForTheLandmarksOfWideImages) {
  const CameraInfo kitti{1242, 375, 720.0, 720.0, 610.0, 170.0};
  const OverlayStyle style = StyleFor(kitti, 1242);
  EXPECT_EQ(style.status_rows, 2);
  EXPECT_EQ(StyleFor(kitti, 320).status_rows, 1);
  OverlayFrame frame;
  frame.has_clusters = frame.has_landmarks = true;
  for (int i = 0; i < 1000; ++i) frame.landmarks.push_back({1.0F, 1.0F, kStaticLabel});
  const cv::Mat image(375, 1242, CV_8UC1, cv::Scalar(test::kGrey));
  const cv::Mat picture = DrawOverlay(image, frame, kitti, style);
  EXPECT_EQ(picture.rows, 375 + BarHeight(style.text_px, 2) + LegendBar(style, 1242).rows);
}

TEST(Legend, OmitsMarksThatNoRunHas) {
  OverlayStyle style = StyleFor({640, 480, 400.0, 400.0, 320.0, 240.0}, 640);
  EXPECT_TRUE(style.inset);
  const cv::Mat whole = LegendBar(style, 2000);
  OverlayRun run;
  run.landmarks[0] = {{1.0F, 1.0F, kStaticLabel}};
  LimitTo({run}, style);
  EXPECT_FALSE(style.inset);
  EXPECT_LT(CountColor(LegendBar(style, 2000), ClusterColor(2)), 1);
  EXPECT_GT(CountColor(whole, ClusterColor(2)), 1);
  LimitTo({OverlayRun()}, style);
  EXPECT_TRUE(LegendBar(style, 2000).empty());
}

TEST(ContactSheet, EmptyCellsAreDark) {
  const cv::Mat white(10, 10, CV_8UC3, cv::Scalar(255, 255, 255));
  const cv::Mat sheet = ContactSheet({white, white, white}, 2);
  EXPECT_EQ(CountColor(sheet(cv::Rect(14, 14, 10, 10)), {255, 255, 255}), 0);
}

TEST(BirdsEye, ShowsClustersFromAbove) {
  OverlayFrame frame;
  frame.clusters = {Cube(2, -0.8, 3.0), Cube(5, 0.8, 1.2)};
  cv::Mat map(300, 300, CV_8UC3, cv::Scalar(0));
  DrawBirdsEye(frame, FlatCamera(), PlainStyle(), map);
  const auto seen = [&](std::int64_t id, cv::Rect part) {
    return CountColor(map(part), ClusterColor(id));
  };
  const cv::Rect far_left(0, 0, 150, 200);
  const cv::Rect near_right(150, 150, 150, 150);
  EXPECT_GT(seen(2, far_left), 40);
  EXPECT_EQ(seen(2, near_right), 0);
  EXPECT_GT(seen(5, near_right), 40);
  EXPECT_EQ(seen(5, far_left), 0);
  OverlayStyle style = PlainStyle();
  const cv::Mat without = Draw(frame, style);
  style.inset = true;
  const cv::Rect left(0, 0, 60, 60);
  const cv::Rect right(260, 180, 60, 60);
  EXPECT_FALSE(SameImage(Draw(frame, style)(left), without(left)));
  style.inset_corner = Corner::kBottomRight;
  EXPECT_TRUE(SameImage(Draw(frame, style)(left), without(left)));
  EXPECT_FALSE(SameImage(Draw(frame, style)(right), without(right)));
}

}  // namespace
}  // namespace cvo::reports
