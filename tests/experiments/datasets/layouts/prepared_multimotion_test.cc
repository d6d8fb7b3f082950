// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "tests/experiments/datasets/layouts/written_scene.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::prepared_multimotion_test {
namespace {

namespace fs = std::filesystem;
using test::NumbersText;
using test::WrittenScene;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const RigidTransform kDataFromWorld(ExpSo3({1.4, 0.2, -0.3}), Eigen::Vector3d(0.5, 2.0, 1.0));

std::string MaskText(const cv::Mat& mask) {
  std::string text;
  for (int v = 0; v < mask.rows; ++v) {
    for (int u = 0; u < mask.cols; ++u) text += StrCat(mask.at<std::uint16_t>(v, u), " ");
    text += "\n";
  }
  return text;
}

fs::path WritePrepared(const test::TempFolder& root, const WrittenScene& scene) {
  const StereoCamera& c = scene.camera;
  std::string times, cameras, objects;
  for (std::size_t k = 0; k < scene.frames(); ++k) {
    times += FormatSecondsNs(scene.times_ns[k]) + "\n";
    cameras +=
        StrCat(k, " ") + test::MatrixText(kDataFromWorld * scene.world_from_left[k], " ") + "\n";
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const RigidTransform pose = kDataFromWorld * scene.bodies[i].world_from_object[k];
      const Eigen::Vector3d t = pose.translation(), r = LogSo3(pose.rotation());
      objects += StrCat(k, " ", i + 1, " ") +
                 NumbersText({t.x(), t.y(), t.z(), r.x(), r.y(), r.z()}, " ") + "\n";
    }
    for (int side = 0; side < 2; ++side) {
      test::WriteImage(root.path() / StrCat("omd/image_", side, "/00000", k, ".png"),
                       scene.images[k][static_cast<std::size_t>(side)]);
    }
    root.Write(StrCat("omd/semantic/00000", k, ".txt"), MaskText(scene.masks[k]));
  }
  root.Write("omd/times.txt", times);
  root.Write("omd/pose_gt.txt", cameras);
  root.Write("omd/object_pose.txt", objects);
  root.Write(
      "omd/oxford.yaml",
      StrCat("%YAML:1.0\nCamera.fx: ", FormatDouble(c.fx), "\nCamera.fy: ", FormatDouble(c.fy),
             "\nCamera.cx: ", FormatDouble(c.cx), "\nCamera.cy: ", FormatDouble(c.cy),
             "\nCamera.k1: 0.0\nCamera.width: ", c.width_px, "\nCamera.height: ", c.height_px,
             "\nCamera.baseline: ", FormatDouble(c.baseline_m), "\n"));
  return root.path() / "omd";
}

TEST(PreparedMultimotion, GivesTheSameErrorsAsOurOwnLayout) {
  const test::TempFolder own_folder, folder;
  const test::OwnScene own(own_folder.path() / "scene");
  Sequence sequence = OpenSequence(
      {.folder = WritePrepared(folder, own.written()), .detections_file = own.detections()});
  EXPECT_EQ(sequence.type, "prepared-multimotion");
  EXPECT_THAT(sequence.missing, IsEmpty());
  test::ExpectSameSequence(own.Open(), sequence);
  for (std::size_t i = 0; i < 2; ++i) {
    sequence.bodies->bodies[i].size_m = own.written().bodies[i].size_m;
  }
  test::ExpectSameErrors(own.Open(), sequence, true, true);
}

class PreparedFiles : public testing::Test {
 protected:
  PreparedFiles() : written_(WritePrepared(folder_, test::SmallScene())) {}
  Sequence Open() const { return OpenSequence({.folder = written_, .layout = settings_}); }
  std::string Refused() const {
    return ErrorMessage([&] { Open(); });
  }

  test::TempFolder folder_;
  fs::path written_;
  Json settings_ = Json::object();
};

TEST_F(PreparedFiles, NeedRightImages) {
  fs::remove_all(written_ / "image_1");
  EXPECT_THAT(Refused(), AllOf(HasSubstr("depth in place of right images"), HasSubstr("image_1")));
  EXPECT_THAT(FindSequences(written_), IsEmpty());
}

TEST_F(PreparedFiles, ObjectsAreNamedByTheSettings) {
  settings_ = {{"names", {{"2", "top right"}}}};
  EXPECT_EQ(Open().bodies->bodies[1].name, "top right");
  settings_ = {{"names", {{"5", "tower"}}}};
  EXPECT_THAT(Refused(), AllOf(HasSubstr("object_pose.txt: found no object 5")));
}

TEST_F(PreparedFiles, BadRowsAreRefusedWithFileAndRow) {
  test::RepeatRow(written_ / "object_pose.txt", 2);
  EXPECT_THAT(Refused(), HasSubstr("object_pose.txt:3: found frame 0, object 2 a second time"));
  test::DropRow(written_ / "object_pose.txt", 3);
  test::RepeatRow(written_ / "pose_gt.txt", 1);
  EXPECT_THAT(Refused(), HasSubstr("pose_gt.txt:2: found frame 0 a second time"));
  test::DropRow(written_ / "pose_gt.txt", 1);
  const std::string text = test::ReadFile(written_ / "pose_gt.txt");
  WriteFileBytes(written_ / "pose_gt.txt", text.substr(0, text.size() - 12));
  EXPECT_THAT(Refused(), HasSubstr("pose_gt.txt:3: found"));
  WriteFileBytes(written_ / "pose_gt.txt", text);
  test::RepeatRow(written_ / "times.txt", 1);
  EXPECT_THAT(Refused(), AllOf(HasSubstr("times.txt:2"), HasSubstr("after")));
}

TEST_F(PreparedFiles, MismatchedCalibrationsAreRefused) {
  test::ReplaceIn(written_ / "oxford.yaml", "Camera.width: 48", "Camera.width: 640");
  EXPECT_THAT(Refused(), AllOf(HasSubstr("Camera.width: found 640"), HasSubstr("48 px")));
  test::ReplaceIn(written_ / "oxford.yaml", "Camera.width: 640", "Camera.width: 48");
  test::ReplaceIn(written_ / "oxford.yaml", "Camera.k1: 0.0", "Camera.k1: 0.1");
  EXPECT_THAT(Refused(), AllOf(HasSubstr("Camera.k1: found 0.1"), HasSubstr("rectified")));
  folder_.Write("omd/other.yaml", "");
  EXPECT_THAT(Refused(), HasSubstr("2 YAML files"));
}

TEST_F(PreparedFiles, MasksArePartOfItsIdentity) {
  EXPECT_THAT(Open().other_files, testing::Contains(written_ / "semantic/000001.txt"));
}

TEST_F(PreparedFiles, ReportsMissingRows) {
  test::DropRow(written_ / "pose_gt.txt", 2);
  fs::remove_all(written_ / "semantic");
  EXPECT_THAT(Open().missing, ElementsAre(HasSubstr("no masks"), HasSubstr("1 of 3 frames")));
  fs::remove(written_ / "object_pose.txt");
  EXPECT_THAT(Open().missing,
              ElementsAre(HasSubstr("object_pose.txt: no poses"), HasSubstr("1 of")));
}

}  // namespace
}  // namespace cvo::prepared_multimotion_test
