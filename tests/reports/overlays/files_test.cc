// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests the composition and encoding of drawings: contact sheets, panels, images and videos.
#include <gmock/gmock.h>

#include <fstream>

#include "core/files/images/image_codec.h"
#include "reports/overlays/encode.h"
#include "reports/overlays/sheet.h"
#include "reports/overlays/video.h"
#include "tests/reports/overlays/overlay_scene.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::reports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

cv::Mat Filled(int width, int height, Rgb color) {
  return cv::Mat(height, width, CV_8UC3, cv::Scalar(color.blue, color.green, color.red));
}

TEST(EvenlySpaced, FromTheFirstToTheLast) {
  EXPECT_THAT(EvenlySpaced(10, 4), ElementsAre(0, 3, 6, 9));
  EXPECT_THAT(EvenlySpaced(3, 24), ElementsAre(0, 1, 2));
  EXPECT_THAT(EvenlySpaced(5, 1), ElementsAre(0));
  EXPECT_THAT(EvenlySpaced(0, 5), IsEmpty());
}

TEST(ContactSheet, FillsRowsFromTheTopLeft) {
  const cv::Mat sheet = ContactSheet(
      {Filled(40, 30, {10, 0, 0}), Filled(40, 30, {20, 0, 0}), Filled(40, 30, {30, 0, 0})}, 2);
  EXPECT_EQ(sheet.size(), cv::Size(84, 64));
  EXPECT_EQ(test::ColorAt(sheet, 0, 0).red, 10);
  EXPECT_EQ(test::ColorAt(sheet, 44, 0).red, 20);
  EXPECT_EQ(test::ColorAt(sheet, 39, 34).red, 30);
  EXPECT_EQ(test::ColorAt(sheet, 44, 34), (Rgb{24, 24, 28}));
  EXPECT_THAT(ErrorMessage([] {
                ContactSheet({Filled(40, 30, {}), Filled(41, 30, {})}, 2);
              }),
              HasSubstr("41x30"));
}

TEST(Panels, WideImagesAreStacked) {
  const cv::Mat beside = Panels({{"2d", Filled(40, 30, {})}, {"full", Filled(40, 30, {})}}, 9);
  EXPECT_EQ(beside.cols, 84);
  const cv::Mat below = Panels({{"2d", Filled(90, 30, {})}, {"full", Filled(90, 30, {})}}, 9);
  EXPECT_EQ(below.cols, 90);
  EXPECT_GT(below.rows, 60);
}

TEST(Encode, GivesBackTheImage) {
  const cv::Mat image = Filled(40, 30, {200, 100, 50});
  EXPECT_TRUE(test::SameImage(DecodeImage(PngBytes(image), cv::IMREAD_COLOR), image));
  EXPECT_LT(JpegBytes(image, 20).size(), JpegBytes(image, 95).size() + 1);
  EXPECT_THAT(ErrorMessage([] { PngBytes(cv::Mat()); }), HasSubstr(".png"));
}

std::string VideoBytes(const std::filesystem::path& stem) {
  VideoFile video(stem, {65, 49}, 10.0);
  for (int i = 0; i < 5; ++i) {
    video.Add(Filled(65, 49, {static_cast<std::uint8_t>(50 * i), 100, 100}));
  }
  video.Close();
  return test::ReadFile(video.path());
}

TEST(VideoFile, WritesTheSameBytesEveryTime) {
  const test::TempFolder folder;
  const std::string bytes = VideoBytes(folder.path() / "a");
  EXPECT_GT(bytes.size(), 500U);
  EXPECT_EQ(bytes, VideoBytes(folder.path() / "b"));
}

TEST(VideoFile, ReportsWriteErrors) {
  const test::TempFolder folder;
  EXPECT_THAT(ErrorMessage([&] {
                VideoFile(folder.path() / "no" / "a", {64, 48}, 10.0);
              }),
              HasSubstr("writes no video"));
  VideoFile video(folder.path() / "a", {64, 48}, 10.0);
  EXPECT_THAT(ErrorMessage([&] { video.Add(Filled(32, 24, {})); }), HasSubstr("a frame of 32x24"));
}

}  // namespace
}  // namespace cvo::reports
