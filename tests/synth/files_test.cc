// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/rng.h"
#include "core/files/images/image_file.h"
#include "synth/write/dataset.h"
#include "synth/write/render_cache.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"
#include "tests/synth/worlds.h"

namespace cvo::synth {
namespace {

namespace fs = std::filesystem;
using cvo::test::ReadFile;
using cvo::test::TempFolder;
using testing::HasSubstr;

cv::Mat Decode(const std::string& bytes) { return DecodeImage(bytes, cv::IMREAD_UNCHANGED); }

std::vector<std::string> NamesIn(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
  return names;
}

TEST(EncodeDepthTiff, IsLosslessAndSmall) {
  cv::Mat depth(480, 640, CV_32FC1);
  for (int v = 0; v < depth.rows; ++v) {
    for (int u = 0; u < depth.cols; ++u) {
      depth.at<float>(v, u) = v < 20 ? 0.0F : 3.0F / (1.0F + 0.001F * static_cast<float>(u));
    }
  }
  const std::string bytes = EncodeDepthTiff(depth);
  const cv::Mat read = Decode(bytes);
  ASSERT_EQ(read.type(), CV_32FC1);
  EXPECT_EQ(cv::norm(read, depth, cv::NORM_INF), 0.0);
  EXPECT_LT(bytes.size(), depth.total() * sizeof(float) / 4);
  EXPECT_EQ(bytes, EncodeDepthTiff(depth));
}

TEST(EncodePng, MasksAndImagesAreLossless) {
  cv::Mat mask(30, 40, CV_16UC1, cv::Scalar(0));
  mask(cv::Rect(5, 5, 10, 10)).setTo(300);
  EXPECT_EQ(cv::norm(Decode(EncodeMaskPng(mask)), mask, cv::NORM_INF), 0.0);
  cv::Mat grey(30, 40, CV_8UC1);
  Rng rng(1, "pixels");
  for (int i = 0; i < 1200; ++i) grey.data[i] = static_cast<unsigned char>(rng.UniformInt(256));
  const cv::Mat read = Decode(EncodePng(grey));
  ASSERT_EQ(read.type(), CV_8UC1);
  EXPECT_EQ(cv::norm(read, grey, cv::NORM_INF), 0.0);
}

TEST(FolderBuild, AppearsWithItsManifestOnlyWhenCommitted) {
  const TempFolder temp;
  {
    FolderBuild build(temp.path() / "set");
    build.Write("image_0/000000.png", "abc");
    EXPECT_FALSE(fs::exists(temp.path() / "set"));
    build.Commit({}, Existing::kReplace);
  }
  EXPECT_THAT(NamesIn(temp.path()), testing::ElementsAre("set"));
  const Manifest manifest = ReadManifest(temp.path() / "set");
  ASSERT_EQ(manifest.files.size(), 1U);
  EXPECT_EQ(manifest.files[0].name, "image_0/000000.png");
  EXPECT_EQ(manifest.files[0].size_bytes, 3);
  EXPECT_EQ(manifest.files[0].sha256,
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(FolderBuild, ReplacesOrKeepsAnExistingFolder) {
  const TempFolder temp;
  const auto commit = [&](const std::string& content, Existing existing) {
    FolderBuild build(temp.path() / "set");
    build.Write("a", content);
    build.Commit({}, existing);
  };
  commit("old", Existing::kReplace);
  commit("new", Existing::kKeep);
  EXPECT_EQ(ReadFile(temp.path() / "set" / "a"), "old");
  commit("new", Existing::kReplace);
  EXPECT_EQ(ReadFile(temp.path() / "set" / "a"), "new");
  EXPECT_THAT(NamesIn(temp.path()), testing::ElementsAre("set"));
}

// A file size limit simulates a full disk: writing fails midway.
TEST(FolderBuild, FailedWriteIsReportedAndLeavesNothing) {
  const TempFolder temp;
  rlimit before;
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  rlimit small = before;
  small.rlim_cur = 1000;
  auto* handler = ::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message =
      ErrorMessage([&] { FolderBuild(temp.path() / "set").Write("big", std::string(5000, 'x')); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, handler);
  EXPECT_THAT(message, HasSubstr("/big"));
  EXPECT_THAT(message, HasSubstr("File too large"));
  EXPECT_THAT(NamesIn(temp.path()), testing::IsEmpty());
}

class Damage : public testing::Test {
 protected:
  Damage() {
    FolderBuild build(folder_);
    build.Write("a", "abc");
    build.Write("b/c", "defg");
    build.Commit({}, Existing::kReplace);
  }
  std::string Found() {
    TaskPool pool(2);
    return FindDamage(folder_, ReadManifest(folder_), pool).value_or("");
  }

  TempFolder temp_;
  fs::path folder_ = temp_.path() / "set";
};

TEST_F(Damage, IsNamed) {
  EXPECT_EQ(Found(), "");
  temp_.Write("set/a", "abcd");
  EXPECT_THAT(Found(), HasSubstr("a has 4 bytes instead of 3"));
  temp_.Write("set/a", "abd");
  EXPECT_THAT(Found(), HasSubstr("a has changed since it was written"));
  fs::remove(folder_ / "a");
  EXPECT_THAT(Found(), HasSubstr("a is missing"));
}

TEST(ReadManifest, RefusesOtherJson) {
  const TempFolder temp;
  temp.Write("manifest.json", "{\"kind\": \"other\"}");
  EXPECT_THAT(ErrorMessage([&] { ReadManifest(temp.path()); }), HasSubstr("manifest.json"));
  temp.Write("manifest.json",
             "{\"kind\": \"clustervo synthetic sequence\", \"schema_version\": 1}");
  EXPECT_THAT(ErrorMessage([&] { ReadManifest(temp.path()); }), HasSubstr("manifest.json"));
  temp.Write("manifest.json", "{\"kind\": 5, \"schema_version\": [1]}");
  EXPECT_THAT(ErrorMessage([&] { ReadManifest(temp.path()); }),
              HasSubstr("found another JSON file"));
  temp.Write(
      "manifest.json",
      "{\"kind\": \"clustervo synthetic sequence\", \"schema_version\": 1, \"scene\": \"a\", "
      "\"seed\": null, \"frames\": {\"first\": 1e300, \"count\": 3}}");
  EXPECT_THAT(ErrorMessage([&] { ReadManifest(temp.path()); }),
              HasSubstr("manifest.json, frames, field first: found 1e+300"));
}

// The body's mask is the left half of the image.
Rendering DrawHalf(const World& world) {
  Rendering rendering = EmptyRendering(world);
  rendering.instances(cv::Rect(0, 0, 50, 80)).setTo(1);
  rendering.alone_px = {4000};
  return rendering;
}

DrawingTools Tools(const World& world, int& draws) {
  return {[&world, &draws](const View&) {
            ++draws;
            return DrawHalf(world);
          },
          nullptr};
}

TEST(MakeContactSheet, HasElevenFramesWithTintedMasksAndAMap) {
  const World world = OneBoxWorld();
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

// The body moves to the left (world y, up in the map) by half a metre at 4.5 m from the camera.
TEST(DrawPathMap, DrawsPathsAtTheirPositions) {
  const World world = OneBoxWorld();
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

}  // namespace
}  // namespace cvo::synth
