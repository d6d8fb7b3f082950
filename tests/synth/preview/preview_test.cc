// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/preview/preview.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <set>

#include "synth/preview/path_map.h"
#include "tests/synth/write/test_scene.h"

namespace cvo::synth {
namespace {

// The body's mask is the left half of the image.
Rendering DrawHalf(const World& world) {
  Rendering rendering = test::EmptyRendering(world);
  rendering.instances(cv::Rect(0, 0, 50, 80)).setTo(1);
  rendering.alone_px = {4000};
  return rendering;
}

DrawingTools Tools(const World& world, int& draws) {
  return {[&world, &draws](const View&) {
            ++draws;
            return DrawHalf(world);
          },
          nullptr, nullptr};
}

TEST(MakeContactSheet, HasElevenFramesWithTintedMasksAndAMap) {
  const World world = test::OneBoxWorld();
  int draws = 0;
  const cv::Mat sheet = MakeContactSheet(world, 0, world.frames, Tools(world, draws), {});
  EXPECT_EQ(draws, 11);
  ASSERT_EQ(sheet.type(), CV_8UC3);
  // Cells of 480 x 384 px in four columns. The image has the RGB colour (90, 100, 110), blended
  // with a quarter of the body's blue over the mask.
  EXPECT_EQ(sheet.cols, 4 * 488 + 8);
  EXPECT_EQ(sheet.at<cv::Vec3b>(54 + 300, 8 + 400), cv::Vec3b(110, 100, 90));
  EXPECT_EQ(sheet.at<cv::Vec3b>(54 + 300, 8 + 60), cv::Vec3b(130, 105, 73));
}

TEST(MakeContactSheet, StopsOnRequest) {
  const World world = test::OneBoxWorld();
  int draws = 0;
  WorkHooks hooks;
  hooks.stop = [&] { return draws == 2; };
  EXPECT_THROW(MakeContactSheet(world, 0, world.frames, Tools(world, draws), hooks), Stopped);
}

// The body moves to the left (world y, up in the map) by half a metre at 4.5 m from the camera.
TEST(DrawPathMap, DrawsPathsAtTheirPositions) {
  const World world = test::OneBoxWorld();
  const std::vector<cv::Scalar> colours = BodyColours(1);
  cv::Mat map(400, 480, CV_8UC3);
  DrawPathMap(world, 0, world.frames, colours, map);
  cv::Mat body;
  cv::inRange(map, colours[0], colours[0], body);
  const cv::Rect box = cv::boundingRect(body);
  // The camera is at x = 0 and the body's box ends at 5 m, which is 420 px away. The path is 2 px
  // wide and ends in a dot of 7 px.
  EXPECT_NEAR(box.x + box.width / 2.0, 30 + 4.5 * 84, 1.5);
  EXPECT_NEAR(box.height, 0.5 * 84 + 5, 2);
}

TEST(BodyColours, AreAllDifferent) {
  std::set<std::array<double, 3>> different;
  for (const cv::Scalar& colour : BodyColours(30)) {
    different.insert({colour[0], colour[1], colour[2]});
  }
  EXPECT_EQ(different.size(), 30U);
}

}  // namespace
}  // namespace cvo::synth
