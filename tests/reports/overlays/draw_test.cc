// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests drawings on a uniform image pixel by pixel, and how pictures are combined and written.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <opencv2/core.hpp>

#include "core/files/images/image_file.h"
#include "reports/overlays/canvas.h"
#include "reports/overlays/draw_overlay.h"
#include "tests/support/error_message.h"

namespace cvo::reports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::uint8_t kGrey = 90;

// A uniform image and its camera: a point at (x, y, 2) m is 100 x px right of the centre.
CameraInfo FlatCamera() { return {320, 240, 200.0, 200.0, 160.0, 120.0}; }
cv::Mat FlatImage() { return cv::Mat(240, 320, CV_8UC1, cv::Scalar(kGrey)); }

// Nothing below the image.
OverlayStyle PlainStyle() {
  OverlayStyle style;
  style.line_px = 3;
  style.status = false;
  return style;
}

// A static cube of 1 m edge length, with its near face at depth `near_z` and its centre 0.5 m
// behind that.
ClusterShape Cube(std::int64_t id, double x = 0.0, double near_z = 2.0) {
  ClusterShape cube;
  cube.id = id;
  cube.category = "Crate";
  for (std::size_t i = 0; i < 8; ++i) {
    cube.corners[i] = {x + ((i & 1U) != 0 ? 0.5 : -0.5), (i & 2U) != 0 ? 0.5 : -0.5,
                       near_z + ((i & 4U) != 0 ? 1.0 : 0.0)};
  }
  cube.tail = {Eigen::Vector3d(x, 0.0, near_z + 0.5)};
  return cube;
}

Rgb ColorAt(const cv::Mat& picture, int u, int v) {
  const auto& bgr = picture.at<cv::Vec3b>(v, u);
  return {bgr[2], bgr[1], bgr[0]};
}

// Number of pixels of exactly this colour.
int CountColor(const cv::Mat& picture, Rgb color) {
  int count = 0;
  for (int v = 0; v < picture.rows; ++v) {
    for (int u = 0; u < picture.cols; ++u) count += ColorAt(picture, u, v) == color ? 1 : 0;
  }
  return count;
}

bool SameImage(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}

const Rgb kBackground{kGrey, kGrey, kGrey};

cv::Mat Draw(const OverlayFrame& frame, const OverlayStyle& style = PlainStyle()) {
  return DrawOverlay(FlatImage(), frame, FlatCamera(), style);
}

TEST(DrawOverlay, AnEmptyFrameIsTheImage) {
  EXPECT_EQ(CountColor(Draw({}), kBackground), 320 * 240);
}

TEST(DrawOverlay, StaticLandmarksAreSmallAndOutliersSmaller) {
  const auto touched = [](std::int64_t label) {
    OverlayFrame frame;
    frame.landmarks = {{50.0F, 60.0F, label}};
    return 320 * 240 - CountColor(Draw(frame), kBackground);
  };
  EXPECT_GT(touched(kOutlierLabel), 0);
  EXPECT_GT(touched(kStaticLabel), touched(kOutlierLabel));
  EXPECT_GT(touched(4), touched(kStaticLabel));
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

TEST(DrawOverlay, APredictedBoxIsDashed) {
  OverlayFrame frame;
  frame.clusters = {Cube(2)};
  OverlayStyle style = PlainStyle();
  const auto drawn = [&](bool predicted) {
    frame.clusters[0].predicted = predicted;
    return CountColor(Draw(frame, style)(cv::Rect(110, 75, 1, 90)), ClusterColor(2));
  };
  EXPECT_EQ(drawn(false), 90);
  EXPECT_GT(drawn(true), 30);
  EXPECT_LT(drawn(true), 70);
}

TEST(DrawOverlay, ClustersBehindTheCameraAreNotDrawn) {
  OverlayFrame frame;
  frame.clusters = {Cube(2, 0.0, -4.0)};
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

TEST(DrawOverlay, TailShowsPastPositions) {
  OverlayFrame frame;
  frame.clusters = {Cube(2, 0.0, 1.5)};  // centre at 2 m
  frame.clusters[0].tail = {{-0.9, 0.0, 2.0}, {-0.3, 0.0, 2.0}, {0.0, 0.0, 2.0}};
  const cv::Mat picture = Draw(frame);
  EXPECT_EQ(ColorAt(picture, 130, 120), ClusterColor(2));
  EXPECT_EQ(ColorAt(picture, 75, 120), ClusterColor(2));
  EXPECT_EQ(ColorAt(picture, 60, 120), kBackground);
  EXPECT_EQ(ColorAt(picture, 190, 120), kBackground);
}

TEST(DrawOverlay, TheNameIsAboveTheTopLeftCornerOfTheBox) {
  OverlayFrame frame;
  frame.clusters = {Cube(2)};
  OverlayStyle style = PlainStyle();
  const auto filled = [&](const cv::Rect& part) {
    return CountColor(Draw(frame, style)(part), ClusterColor(2));
  };
  const cv::Size size = Font(style.text_px).SizeOf("2 Crate");
  const cv::Rect above(cv::Point(110, 70 - size.height), size);
  EXPECT_GT(filled(above), above.area() / 2);
  style.names = false;
  EXPECT_LT(filled(above), above.area() / 2) << "the id alone";
  frame.clusters = {Cube(2, 0.0, 0.6)};
  style.names = true;
  EXPECT_GT(filled(cv::Rect({0, 0}, size)), above.area() / 2) << "within the image";
}

TEST(DrawOverlay, AsSvgHasMarksOverTheImageAndInertText) {
  OverlayFrame frame;
  frame.clusters = {Cube(2)};
  frame.clusters[0].category = "<b>";
  frame.landmarks = {{100.0, 60.0, 2}};
  const std::string svg = OverlaySvg(FlatImage(), frame, FlatCamera(), PlainStyle());
  EXPECT_THAT(svg, testing::MatchesRegex("<svg [^>]*viewBox=\"0 0 320 240\"(.|\n)*</svg>\n"));
  EXPECT_THAT(svg, HasSubstr("<image width=\"320\" height=\"240\" href=\"data:image/png;base64,"));
  EXPECT_THAT(svg, HasSubstr("<circle transform=\"translate(100.50 60.50)\" r=\"2.60\""));
  EXPECT_THAT(svg, HasSubstr("<path d=\"M110.50 70.50L210.50 70.50\"")) << "an edge";
  EXPECT_THAT(svg, HasSubstr(">2 &lt;b&gt;</text>"));
}

TEST(DrawOverlay, DetectionIsAThinWhiteRectangle) {
  OverlayFrame frame;
  frame.detections = {{40.2, 50.4, 80.0, 90.0}};
  const cv::Mat picture = Draw(frame);
  EXPECT_GT(ColorAt(picture, 40, 70).red, 190);
  EXPECT_GT(ColorAt(picture, 60, 50).red, 190);
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

TEST(DrawOverlay, HandlesNonFiniteAndHugeInput) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kHuge = 1e300;
  OverlayFrame frame;
  frame.landmarks = {{1e9F, -1e9F, 2}, {std::nanf(""), 4.0F, 0}, {-2.0F, 241.0F, 3}};
  frame.detections = {{-1e9, -1e9, 1e9, 1e9}, {kNan, 0.0, 4.0, 4.0}};
  for (const double x : {kNan, kHuge, -kHuge, 1e6, -1.7}) {
    frame.clusters.push_back(Cube(static_cast<std::int64_t>(frame.clusters.size()), x));
    frame.clusters.back().predicted = frame.clusters.size() % 2 == 0;
    frame.clusters.back().tail.insert(frame.clusters.back().tail.begin(),
                                      Eigen::Vector3d(kHuge, kNan, 1.0));
    frame.clusters.back().category =
        std::string("\x01<b>\n\xF0\x9F\x9A\x97") + std::string(999, 'W');
  }
  frame.clusters.back().id = std::numeric_limits<std::int64_t>::min();
  frame.status = std::string(5000, 'x');
  OverlayStyle style = PlainStyle();
  style.status = style.inset = true;
  EXPECT_EQ(Draw(frame, style).size(), cv::Size(320, 240 + StatusHeight(style)));
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
  OverlayStyle style = StyleFor(FlatCamera(), 320);
  style.inset = true;
  EXPECT_EQ(PngBytes(Draw(frame, style)), PngBytes(Draw(frame, style)));
  EXPECT_EQ(JpegBytes(Draw(frame, style), 60), JpegBytes(Draw(frame, style), 60));
}

TEST(StatusText, CountsWhatIsDrawn) {
  OverlayFrame frame;
  frame.frame = 12;
  frame.time_s = 0.4;
  frame.status = "tracked";
  frame.run = "full, seed 1";
  frame.landmarks = {{1, 1, 0}, {1, 1, 7, 0, true}};
  frame.clusters = {Cube(2)};
  EXPECT_EQ(StatusText(frame), "full, seed 1  frame 12  0.40 s  tracked  1 body  2 landmarks");
  frame.has_truth = true;
  EXPECT_THAT(StatusText(frame), testing::EndsWith("2 landmarks, 1 wrong"));
  frame.landmarks.clear();
  EXPECT_THAT(StatusText(frame), testing::EndsWith("1 body")) << "none were written";
}

TEST(ClusterColor, IsFixedPerIdAndDistinctBetweenIds) {
  EXPECT_EQ(ClusterColor(5), ClusterColor(5));
  constexpr std::int64_t kCount = 16;
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
}

TEST(BirdsEye, ShowsClustersFromAbove) {
  OverlayFrame frame;
  frame.clusters = {Cube(2, -0.8, 3.0), Cube(5, 0.8, 1.2)};
  frame.range_m = 4.5;
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
  const cv::Mat with = Draw(frame, style);
  EXPECT_FALSE(SameImage(with(cv::Rect(0, 0, 60, 60)), without(cv::Rect(0, 0, 60, 60))));
  const cv::Rect rest(90, 0, 230, 240);
  EXPECT_TRUE(SameImage(with(rest), without(rest)));
}

cv::Mat Filled(int width, int height, Rgb color) {
  return cv::Mat(height, width, CV_8UC3, cv::Scalar(color.blue, color.green, color.red));
}

TEST(EvenlySpaced, FromTheFirstToTheLast) {
  EXPECT_THAT(EvenlySpaced(10, 4), ElementsAre(0, 3, 6, 9));
  EXPECT_THAT(EvenlySpaced(3, 24), ElementsAre(0, 1, 2));
  EXPECT_THAT(EvenlySpaced(5, 1), ElementsAre(0));
  EXPECT_THAT(EvenlySpaced(0, 5), IsEmpty());
}

TEST(Grid, FillsRowsFromTheTopLeft) {
  const cv::Mat sheet =
      Grid({Filled(40, 30, {10, 0, 0}), Filled(40, 30, {20, 0, 0}), Filled(40, 30, {30, 0, 0})}, 2);
  EXPECT_EQ(sheet.size(), cv::Size(84, 64));
  EXPECT_EQ(ColorAt(sheet, 0, 0).red, 10);
  EXPECT_EQ(ColorAt(sheet, 44, 0).red, 20);
  EXPECT_EQ(ColorAt(sheet, 39, 34).red, 30);
  EXPECT_EQ(ColorAt(sheet, 44, 34), kDark);
  EXPECT_EQ(Grid({Filled(40, 30, {})}, 4).size(), cv::Size(40, 30));
  EXPECT_THAT(ErrorMessage([] {
                Grid({Filled(40, 30, {}), Filled(41, 30, {})}, 2);
              }),
              HasSubstr("41x30"));
}

TEST(Encode, GivesBackTheImage) {
  const cv::Mat image = Filled(40, 30, {200, 100, 50});
  EXPECT_TRUE(SameImage(DecodeImage(PngBytes(image), cv::IMREAD_COLOR), image));
  EXPECT_LT(JpegBytes(image, 20).size(), JpegBytes(image, 95).size() + 1);
  EXPECT_THAT(ErrorMessage([] { PngBytes(cv::Mat()); }), HasSubstr(".png"));
}

}  // namespace
}  // namespace cvo::reports
