// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/write/dataset.h"

#include <gmock/gmock.h>
#include <stdlib.h>

#include <fstream>
#include <opencv2/core.hpp>

#include "core/files/images/image_file.h"
#include "synth/truth/truth.h"
#include "synth/write/render_cache.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"
#include "tests/synth/worlds.h"

namespace cvo::synth {
namespace {

namespace fs = std::filesystem;
using cvo::test::ReadFile;
using cvo::test::TempFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

// Draws the body as a block whose column follows its pose, and so depends on the frame.
Rendering Draw(const World& world, const View& view) {
  Rendering rendering = EmptyRendering(world);
  const int left = 40 - static_cast<int>(10.0 * view.world_from_body[0].translation().y());
  const cv::Rect block(left, 30, 20, 15);
  rendering.instances(block).setTo(1);
  rendering.depth.setTo(5.0);
  rendering.depth(block).setTo(4.0);
  rendering.left(block).setTo(cv::Scalar(10, 20, 30, 200));
  rendering.alone_px = {300};
  return rendering;
}

std::vector<std::string> FilesIn(const fs::path& folder) {
  std::vector<std::string> names;
  if (!fs::exists(folder)) return names;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_directory()) names.push_back(fs::relative(entry.path(), folder).string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class WriteDatasetTest : public testing::Test {
 protected:
  WriteDatasetTest() {
    UseCache("cache");
    source_.scene = "one_box";
    source_.description = {{"name", "one_box"}, {"seed", 3}};
    source_.render_key = "one box";
    source_.seed = 3;
    source_.detectors = ReadDetectors(Json::object(), "one_box", {});
    source_.version = {"gl", "renderer"};
    source_.build_world = [] { return OneBoxWorld(); };
    source_.open_tools = [this](const World& world) {
      return DrawingTools{[this, &world](const View& view) {
                            ++draws_;
                            return Draw(world, view);
                          },
                          [&world](const View& view, cv::Mat& left, cv::Mat& right) {
                            left = Draw(world, view).left;
                            right = left.clone();
                          }};
    };
    request_.hooks.notice = [this](const std::string& text) { notices_.push_back(text); };
  }
  ~WriteDatasetTest() override { ::unsetenv("CLUSTERVO_CACHE"); }

  void UseCache(const std::string& name) {
    ::setenv("CLUSTERVO_CACHE", (temp_.path() / name).c_str(), 1);
  }
  fs::path Write(const std::string& name) {
    WriteDataset(source_, request_, temp_.path() / name);
    return temp_.path() / name;
  }
  // The cache's only entry.
  fs::path CacheEntry() const { return fs::directory_iterator(temp_.path() / "cache")->path(); }

  TempFolder temp_;
  DatasetSource source_;
  RenderRequest request_;
  int draws_ = 0;
  std::vector<std::string> notices_;
};

TEST_F(WriteDatasetTest, FolderIsCompleteAndListedInItsManifest) {
  const fs::path set = Write("set");
  const std::vector<std::string> files = FilesIn(set);
  EXPECT_EQ(files.size(), 4U * 6U + 6U + 3U + 2U);
  const Manifest manifest = ReadManifest(set);
  std::vector<std::string> listed = {kManifestName};
  for (const FileRecord& file : manifest.files) listed.push_back(file.name);
  EXPECT_THAT(listed, testing::UnorderedElementsAreArray(files));
  TaskPool pool(1);
  EXPECT_EQ(FindDamage(set, manifest, pool), std::nullopt);
  EXPECT_EQ(manifest.seed, 3U);
  EXPECT_EQ(manifest.renderer.gl, "gl");
  EXPECT_THAT(ReadFile(set / "scene.json"), HasSubstr("\"seed\": 3"));
  EXPECT_THAT(ReadFile(set / "times.txt"), StartsWith("0.000000000\n0.100000000\n"));
  EXPECT_THAT(ReadFile(set / "poses.txt"), StartsWith("1 0 0 0 0 1 0 0 0 0 1 0\n"));
  EXPECT_THAT(ReadFile(set / "poses_right.txt"), StartsWith("1 0 0 0.2 0 1 0 0 0 0 1 0\n"));
  const std::string objects = ReadFile(set / "objects.csv");
  // The body is 4.5 m ahead; its velocity, to the left, is along the camera's -x.
  EXPECT_THAT(objects, HasSubstr("\n0,1,box_1,Block,0,0,4.5,"));
  EXPECT_THAT(objects, HasSubstr(",-1,0,0,0,0,0,1,2,1.5,300,300,1,0,40,30,59,44,24.5,"));
  EXPECT_THAT(ReadFile(set / "detections" / "oracle.txt"),
              StartsWith("0 -1 Block -1 -1 -10 40.00 30.00 59.00 44.00 "));
  EXPECT_THAT(ReadFile(set / "labels.txt"), StartsWith("0 1 Block 0.000000 0 "));
}

TEST_F(WriteDatasetTest, ImagesAgreeWithTheTruth) {
  source_.sensor = NoiselessSensor({});
  const fs::path set = Write("set");
  const auto read = [&](const char* name) {
    return ReadImageFile(set / name, cv::IMREAD_UNCHANGED);
  };
  const cv::Mat depth = read("depth_0/000005.tiff");
  ASSERT_EQ(depth.type(), CV_32FC1);
  EXPECT_EQ(depth.at<float>(35, 45), 4.0F);
  EXPECT_EQ(read("instance_0/000005.png").at<std::uint16_t>(35, 45), 1);
  const cv::Mat left = read("image_0/000000.png");
  ASSERT_EQ(left.type(), CV_8UC1);
  EXPECT_EQ(left.at<unsigned char>(0, 0), 100);
  EXPECT_EQ(left.at<unsigned char>(35, 45), 200);
  // Images without the effects of a sensor are those of the cache, which nobody may write.
  EXPECT_TRUE(fs::equivalent(set / "image_1/000000.png", CacheEntry() / "image_1/000000.png"));
  const auto permissions = fs::status(CacheEntry() / "depth_0/000000.tiff").permissions();
  EXPECT_EQ(permissions & fs::perms::all, fs::perms(0444));
}

TEST_F(WriteDatasetTest, AnotherSeedOrNumberOfThreadsGivesTheSameDrawing) {
  const fs::path first = Write("first");
  EXPECT_EQ(draws_, 6);
  std::vector<std::string> stages;
  request_.hooks.progress = [&](int, int, const std::string& stage) { stages.push_back(stage); };
  request_.seed = 0;
  const fs::path second = Write("second");
  EXPECT_EQ(draws_, 6);
  EXPECT_THAT(stages, testing::Not(testing::Contains("render")));
  EXPECT_NE(ReadFile(first / "image_0/000000.png"), ReadFile(second / "image_0/000000.png"));
  EXPECT_NE(ReadFile(first / "detections/good.txt"), ReadFile(second / "detections/good.txt"));
  EXPECT_TRUE(fs::equivalent(first / "depth_0/000000.tiff", second / "depth_0/000000.tiff"));
  EXPECT_EQ(ReadManifest(second).seed, 0U);
  request_.threads = 3;
  UseCache("other_cache");
  EXPECT_EQ(ReadFile(second / kManifestName), ReadFile(Write("three") / kManifestName));
  EXPECT_EQ(draws_, 12);
}

TEST_F(WriteDatasetTest, DamagedCacheIsRenderedAgain) {
  const std::string before = ReadFile(Write("set") / kManifestName);
  const fs::path file = CacheEntry() / "depth_0/000002.tiff";
  fs::permissions(file, fs::perms::owner_write, fs::perm_options::add);
  std::ofstream(file, std::ios::app) << "x";
  const fs::path set = Write("set");
  EXPECT_EQ(draws_, 12);
  ASSERT_EQ(notices_.size(), 1U);
  EXPECT_THAT(notices_[0], HasSubstr("depth_0/000002.tiff has "));
  EXPECT_EQ(before, ReadFile(set / kManifestName));
}

TEST_F(WriteDatasetTest, StoppedOrFailedRenderLeavesNothing) {
  request_.hooks.stop = [this] { return draws_ == 3; };
  EXPECT_THROW(Write("set"), Stopped);
  EXPECT_THAT(FilesIn(temp_.path()), ElementsAre());
  request_.hooks.stop = nullptr;
  source_.open_tools = [](const World& world) {
    return DrawingTools{[&world](const View& view) {
                          if (view.world_from_body[0].translation().y() > 0.25) {
                            throw Error("no more");
                          }
                          return Draw(world, view);
                        },
                        nullptr};
  };
  EXPECT_EQ(ErrorMessage([&] { Write("set"); }), "no more");
  EXPECT_THAT(FilesIn(temp_.path()), ElementsAre());
}

TEST_F(WriteDatasetTest, WrongRequestsAreRefusedBeforeRendering) {
  temp_.Write("mine/notes.txt", "precious");
  EXPECT_THAT(ErrorMessage([&] { Write("mine"); }), HasSubstr("mine: found other files in it"));
  temp_.Write("file", "precious");
  EXPECT_THAT(ErrorMessage([&] { Write("file"); }), HasSubstr("file: found a file"));
  EXPECT_THAT(ErrorMessage([&] { Write("file/set"); }), HasSubstr("file"));
  EXPECT_EQ(ReadFile(temp_.path() / "mine/notes.txt"), "precious");
  UseCache("file");
  EXPECT_THAT(ErrorMessage([&] { Write("set"); }), HasSubstr("file"));
  UseCache("cache");
  request_.frames = {2, 7};
  EXPECT_THAT(ErrorMessage([&] { Write("set"); }),
              HasSubstr("frames: found 2:7, expected a range within 0:6"));
  EXPECT_THAT(FilesIn(temp_.path()), ElementsAre("file", "mine/notes.txt"));
  EXPECT_EQ(draws_, 0);
}

TEST_F(WriteDatasetTest, FramesAreCountedFromZeroAndKeepTheirNoise) {
  const fs::path whole = Write("whole");
  request_.frames = {2, 5};
  const fs::path part = Write("part");
  EXPECT_EQ(ReadManifest(part).frames.first, 2);
  EXPECT_EQ(ReadFile(part / "image_1/000000.png"), ReadFile(whole / "image_1/000002.png"));
  EXPECT_EQ(ReadFile(part / "times.txt"), "0.000000000\n0.100000000\n0.200000000\n");
  EXPECT_THAT(ReadFile(part / "objects.csv"), HasSubstr("\n0,1,box_1,Block,-0.199999999999999"));
  Write("whole");  // replaces what it wrote itself
  EXPECT_FALSE(fs::exists(whole / "image_0/000003.png"));
}

// The sub-frames have the body at -15, -5, 5 and 15 cm: one in four covers column 39.
TEST_F(WriteDatasetTest, MotionBlurIsTheMeanOverTheExposure) {
  source_.sensor = NoiselessSensor({});
  source_.sensor.motion_blur = {4, 0.4};
  const fs::path set = Write("set");
  const cv::Mat left = ReadImageFile(set / "image_0/000000.png", cv::IMREAD_UNCHANGED);
  EXPECT_EQ(left.at<unsigned char>(35, 50), 200);
  EXPECT_EQ(left.at<unsigned char>(35, 30), 100);
  EXPECT_EQ(left.at<unsigned char>(35, 39), 125);
}

TEST(CacheFolder, FollowsTheEnvironment) {
  ::setenv("CLUSTERVO_CACHE", "/a", 1);
  EXPECT_EQ(CacheFolder(), "/a");
  ::unsetenv("CLUSTERVO_CACHE");
  ::setenv("XDG_CACHE_HOME", "/b", 1);
  EXPECT_EQ(CacheFolder(), "/b/clustervo");
  ::unsetenv("XDG_CACHE_HOME");
}

// The first frame of `tiny`, drawn by the real renderer.
TEST(WriteScene, TruthAgreesWithWhatIsDrawn) {
  const std::string missing = ErrorMessage([] { FindRendererVersion(); });
  if (!missing.empty()) GTEST_SKIP() << missing;
  const cvo::test::TempFolder temp;
  ::setenv("CLUSTERVO_CACHE", (temp.path() / "cache").c_str(), 1);
  RenderRequest request;
  request.frames = {0, 1};
  request.detector_levels = {"oracle"};
  const auto set = temp.path() / "set";
  WriteDataset(SceneDescription::Load("tiny", {}), request, set);
  ::unsetenv("CLUSTERVO_CACHE");

  const ObjectTable table = ReadObjectTable(set / "objects.csv", {0.0});
  ASSERT_FALSE(table.frames[0].bodies.empty());
  const cv::Mat depth = ReadImageFile(set / "depth_0/000000.tiff", cv::IMREAD_UNCHANGED);
  const cv::Mat mask = ReadImageFile(set / "instance_0/000000.png", cv::IMREAD_UNCHANGED);
  for (const BodyTruth& body : table.frames[0].bodies) {
    ASSERT_TRUE(body.visible_box && body.amodal_box);
    // Where nothing occludes its rim, a mask ends within a pixel of the projected mesh.
    EXPECT_GE(body.visible_box->left_px, body.amodal_box->left_px - 0.1);
    EXPECT_LE(body.visible_box->right_px, body.amodal_box->right_px + 0.1);
    EXPECT_NEAR(body.visible_box->top_px, body.amodal_box->top_px, 1.1);
    const double radius_m = table.sizes_m[static_cast<std::size_t>(body.id - 1)].norm() / 2.0;
    double nearest_m = 0.0, farthest_m = 0.0;
    cv::minMaxLoc(depth, &nearest_m, &farthest_m, nullptr, nullptr, mask == body.id);
    const double middle_m = body.state.world_from_body.translation().z();
    EXPECT_GT(nearest_m, middle_m - radius_m);
    EXPECT_LT(farthest_m, middle_m + radius_m);
  }
}

}  // namespace
}  // namespace cvo::synth
