// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/diversity/diversity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "core/files/text_file.h"
#include "synth/truth/labels.h"
#include "synth/truth/object_table.h"
#include "tests/support/error_message.h"
#include "tests/support/image_file.h"
#include "tests/support/temp_folder.h"
#include "tests/synth/write/test_scene.h"

namespace cvo::synth {
namespace {

using cvo::test::TempFolder;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;

// Three frames, 0.1 s apart, of a box 4.5 m ahead that is visible, hidden and visible again. Focal
// length times baseline is 20 px m.
void WriteOneBox(const std::filesystem::path& folder) {
  const World world = test::OneBoxWorld();
  std::string times, poses, objects = ObjectTableHeader();
  for (int i = 0; i < 3; ++i) {
    FrameTruth truth;
    truth.frame = i;
    truth.time_s = world.Time_s(i);
    truth.world_from_left = world.camera->At(truth.time_s).world_from_body;
    const bool hidden = i == 1;
    BodyTruth body;
    body.id = 1;
    body.state = world.bodies[0].motion->At(truth.time_s);
    body.alone_px = 300;
    body.visible_px = hidden ? 0 : 300 - i;
    body.visible_fraction = hidden ? 0.0 : 1.0;
    body.truncation = 0.0;
    body.amodal_box = PixelBox{10, 10, 29, 39};
    if (!hidden) body.visible_box = body.amodal_box;
    truth.bodies = {body};
    times += std::to_string(truth.time_s) + "\n";
    poses += FormatKittiPose(RigidTransform());
    objects += FormatObjectRows(world, truth, i, truth.world_from_left.Inverse());
  }
  std::filesystem::create_directories(folder / "image_0");
  std::filesystem::create_directories(folder / "instance_0");
  WriteFileBytes(folder / "times.txt", times);
  WriteFileBytes(folder / "poses.txt", poses);
  WriteFileBytes(folder / "objects.csv", objects);
  WriteFileBytes(
      folder / "scene.json",
      R"({"rig": {"focal_px": 100, "baseline_m": 0.2, "width_px": 100, "height_px": 80}})");
  cv::Mat image(80, 100, CV_8UC1, cv::Scalar(50));
  image.rowRange(20, 40).setTo(70);
  cv::Mat ids(80, 100, CV_16UC1, cv::Scalar(0));
  ids(cv::Rect(10, 10, 20, 20)).setTo(1);
  cvo::test::WriteImageFile(folder / "image_0" / "000000.png", image);
  cvo::test::WriteImageFile(folder / "instance_0" / "000000.png", ids);
}

TEST(Diversity, MeasuresABodyThatIsHiddenOnce) {
  const TempFolder temp;
  WriteOneBox(temp.path());
  Diversity found;
  AddSequence(temp.path(), found);
  EXPECT_EQ(found.scenes, 1);
  EXPECT_THAT(found.speed_mps, ElementsAre(DoubleNear(1.0, 1e-6)));
  EXPECT_THAT(found.size_px, ElementsAre(DoubleNear(30.0, 1e-6)));
  EXPECT_THAT(found.visible_s, ElementsAre(DoubleNear(0.2, 1e-6)));
  EXPECT_THAT(found.hidden_s, ElementsAre(DoubleNear(0.1, 1e-6)));
  EXPECT_THAT(found.contrast, ElementsAre(DoubleNear(10.0, 1e-6)));
  EXPECT_THAT(found.disparity_px, ElementsAre(DoubleNear(20.0 / 4.5, 1e-6)));
  EXPECT_THAT(found.moving_part, ElementsAre(300.0 / 8000, 0.0, 298.0 / 8000));
}

TEST(Diversity, NamesMissingData) {
  const TempFolder temp;
  Diversity found;
  EXPECT_THAT(ErrorMessage([&] { AddSequence(temp.path(), found); }), HasSubstr("times.txt"));
  WriteOneBox(temp.path());
  WriteFileBytes(temp.path() / "scene.json", R"({"rig": {"focal_px": 100, "baseline_m": 0.2}})");
  EXPECT_THAT(ErrorMessage([&] { AddSequence(temp.path(), found); }), HasSubstr("no image size"));
}

TEST(Quantile, IsLinearBetweenValues) {
  EXPECT_EQ(Quantile({3.0, 1.0, 2.0}, 0.5), 2.0);
  EXPECT_EQ(Quantile({0.0, 10.0}, 0.1), 1.0);
  EXPECT_EQ(Quantile({4.0}, 0.9), 4.0);
}

}  // namespace
}  // namespace cvo::synth
