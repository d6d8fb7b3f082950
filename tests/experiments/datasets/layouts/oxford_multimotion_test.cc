// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/files/text_file.h"
#include "tests/experiments/datasets/layouts/written_scene.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::oxford_multimotion_test {
namespace {

namespace fs = std::filesystem;
using test::NumbersText;
using test::WrittenScene;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::int64_t kStart_ns = 1'560'510'000'000'000'000;
constexpr double kClockOffset_s = 0.75;  // the clock of Vicon is ahead

const RigidTransform kApparatusFromLeft(ExpSo3({-1.2, 0.4, 1.1}), Eigen::Vector3d(0.1, 0.2, -0.05));
const RigidTransform kViconFromWorld(ExpSo3({1.5, 0.1, 0.7}), Eigen::Vector3d(2.0, -1.0, 1.4));

std::string KalibrCamera(const StereoCamera& c, const std::string& side) {
  return StrCat("  camera_model: pinhole\n  distortion_coeffs: [0.0, 0.0, 0.0, 0.0]\n",
                "  distortion_model: radtan\n  intrinsics: [",
                NumbersText({c.fx, c.fy, c.cx, c.cy}, ", "), "]\n  resolution: [", c.width_px, ", ",
                c.height_px, "]\n  rostopic: /bumblebee/", side, "/image_raw\n");
}

std::string Rows(const RigidTransform& matrix) {
  std::string text;
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector4d row = matrix.Matrix().row(i);
    text += "  - [" + NumbersText({row[0], row[1], row[2], row[3]}, ", ") + "]\n";
  }
  return text;
}

std::string ViconRow(std::int64_t time_ns, const std::string& object, const RigidTransform& pose) {
  const auto q = pose.rotation();
  const auto t = pose.translation();
  return StrCat(time_ns / 1'000'000'000, ",", time_ns % 1'000'000'000, ",", object, ",") +
         NumbersText({q.x(), q.y(), q.z(), q.w(), t.x(), t.y(), t.z()}, ",") + "," +
         test::MatrixText(pose, ",") + "\n";
}

// Writes <root>/swinging_4, with the calibrations beside it.
fs::path WriteMultimotion(const test::TempFolder& root, const WrittenScene& scene) {
  const std::string segment = "swinging_4/";
  std::string images = "frame_num,time_sec,time_nsec\n", vicon;
  vicon =
      "time_sec,time_nsec,object,x,y,z,w,tx,ty,tz,m11,m12,m13,m14,m21,m22,m23,m24,m31,m32,m33,"
      "m34,m41,m42,m43,m44\n";
  for (std::size_t k = 0; k < scene.frames(); ++k) {
    const std::int64_t time_ns = kStart_ns + scene.times_ns[k];
    images += StrCat(k, ",", time_ns / 1'000'000'000, ",", time_ns % 1'000'000'000, "\n");
    for (int side = 0; side < 2; ++side) {
      test::WriteImage(root.path() / segment / "stereo" /
                           StrCat("00000", k, side == 0 ? "_left.png" : "_right.png"),
                       scene.images[k][static_cast<std::size_t>(side)]);
    }
    const std::int64_t vicon_ns = time_ns + static_cast<std::int64_t>(1e9 * kClockOffset_s);
    for (const WrittenScene::Body& body : scene.bodies) {
      vicon += ViconRow(vicon_ns, body.name, kViconFromWorld * body.world_from_object[k]);
    }
    vicon += ViconRow(vicon_ns, "sensor_payload",
                      kViconFromWorld * scene.world_from_left[k] * kApparatusFromLeft.Inverse());
  }
  root.Write(segment + "stereo/stereo.csv", images);
  root.Write(segment + "vicon.csv", vicon);
  const RigidTransform right_from_left(Eigen::Quaterniond::Identity(),
                                       Eigen::Vector3d(-scene.camera.baseline_m, 0.0, 0.0));
  root.Write("kalibr_2019_06_14.yaml", "cam0:\n" + KalibrCamera(scene.camera, "left") +
                                           "cam1:\n  T_cn_cnm1:\n" + Rows(right_from_left) +
                                           KalibrCamera(scene.camera, "right"));
  root.Write("vicon_2019_06_14.yaml", "T_apparatus_left:\n" + Rows(kApparatusFromLeft));
  return root.path() / "swinging_4";
}

Json Settings(const WrittenScene& scene) {
  Json bodies = Json::object();
  for (const WrittenScene::Body& body : scene.bodies) {
    bodies[body.name] = {{"size_m", {body.size_m.x(), body.size_m.y(), body.size_m.z()}}};
  }
  return {{"clock_offset_s", kClockOffset_s}, {"bodies", bodies}};
}

TEST(OxfordMultimotion, GivesTheSameErrorsAsOurOwnLayout) {
  const test::TempFolder own_folder, folder;
  const test::OwnScene own(own_folder.path() / "scene");
  const Sequence sequence = OpenSequence({.folder = WriteMultimotion(folder, own.written()),
                                          .detections_file = own.detections(),
                                          .layout = Settings(own.written())});
  EXPECT_EQ(sequence.type, "oxford-multimotion");
  EXPECT_EQ(sequence.name, "swinging_4");
  EXPECT_THAT(sequence.missing, IsEmpty());
  test::ExpectSameSequence(own.Open(), sequence);
  test::ExpectSameErrors(own.Open(), sequence, false, false);
}

class MultimotionFiles : public testing::Test {
 protected:
  MultimotionFiles() : scene_(test::SmallScene()), segment_(WriteMultimotion(folder_, scene_)) {
    settings_ = Settings(scene_);
  }
  Sequence Open() const { return OpenSequence({.folder = segment_, .layout = settings_}); }
  std::string Refused() const {
    return ErrorMessage([&] { Open(); });
  }

  test::TempFolder folder_;
  WrittenScene scene_;
  fs::path segment_;
  Json settings_;
};

TEST_F(MultimotionFiles, TakesBodiesFromTheSettingsOrAllButTheApparatus) {
  settings_["bodies"] = {{"box2", {{"name", "bottom left"}}}};
  const Sequence named = Open();
  ASSERT_EQ(named.bodies->objects.bodies.size(), 1U);
  EXPECT_EQ(named.bodies->objects.bodies[0].name, "bottom left");
  settings_.erase("bodies");
  EXPECT_EQ(Open().bodies->objects.bodies.size(), 2U);
  settings_["bodies"] = {{"tower", Json::object()}};
  EXPECT_THAT(Refused(), AllOf(HasSubstr("vicon.csv: found box1, box2, sensor_payload"),
                               HasSubstr("object \"tower\"")));
  settings_["bodys"] = 1;
  EXPECT_THAT(Refused(), HasSubstr("did you mean bodies?"));
}

// With this offset, each image lies between two rows of Vicon.
TEST_F(MultimotionFiles, InterpolatesPosesWithTheClockOffset) {
  settings_["clock_offset_s"] = kClockOffset_s + 0.05;
  const Sequence sequence = Open();
  const RigidTransform half = *sequence.groundtruth_world_from_camera[1];
  EXPECT_GT(half.translation().norm(), 0.0);
  EXPECT_FALSE(sequence.groundtruth_world_from_camera[2]);
  EXPECT_THAT(sequence.missing, ElementsAre(HasSubstr("Vicon starts later or ends earlier")));
  settings_.erase("clock_offset_s");
  EXPECT_EQ(Open().groundtruth, "none");
}

// The track has the clock of the images and the axes of the camera, in an arbitrary world frame.
TEST_F(MultimotionFiles, CameraTrackMatchesVicon) {
  const Sequence sequence = Open();
  ASSERT_EQ(sequence.truth_track.size(), sequence.timestamps_ns.size());
  const RigidTransform first = sequence.truth_track[0].world_from_camera.Inverse();
  for (std::size_t i = 0; i < sequence.truth_track.size(); ++i) {
    const TimedPose& pose = sequence.truth_track[i];
    EXPECT_EQ(pose.timestamp_ns, sequence.timestamps_ns[i]);
    EXPECT_LT(
        (first * pose.world_from_camera).Minus(*sequence.groundtruth_world_from_camera[i]).norm(),
        1e-9);
  }
}

TEST_F(MultimotionFiles, BodiesAreVisibleIfTheirCentreIsInTheImage) {
  const Sequence sequence = Open();
  EXPECT_TRUE(sequence.bodies->objects.bodies[0].frames[0]->visible);
  WrittenScene moved = scene_;
  moved.bodies[0].world_from_object[0] = RigidTransform(Eigen::Quaterniond::Identity(), {0, 0, -2});
  WriteMultimotion(folder_, moved);
  EXPECT_FALSE(Open().bodies->objects.bodies[0].frames[0]->visible);
}

TEST_F(MultimotionFiles, BadRowsAreRefusedWithFileAndRow) {
  const RigidTransform first = kViconFromWorld * scene_.bodies[0].world_from_object[0];
  const Eigen::Quaterniond q(first.rotation());
  const std::string list = "swinging_4/stereo/stereo.csv";
  const std::string vicon = "swinging_4/vicon.csv";
  const std::string calibration = "kalibr_2019_06_14.yaml";
  const auto expect = [&](const std::string& file, const test::Edit& edit,
                          const std::string& says) {
    test::ExpectRefused({.folder = segment_, .layout = settings_}, folder_.path() / file, edit,
                        says);
  };
  expect(vicon, test::RepeatRow(3), "vicon.csv:4: found time | of box2");
  expect(vicon, test::CutEnd(40), "vicon.csv:10: found | columns, expected 26");
  // Quaternions with w first contradict the matrices.
  expect(vicon,
         test::Replace(NumbersText({q.x(), q.y(), q.z(), q.w()}, ","),
                       NumbersText({q.w(), q.x(), q.y(), q.z()}, ",")),
         "vicon.csv:2: found a quaternion | x y z w");
  expect(list, test::DropRow(3), "stereo.csv:3: found frame 2 | frame 1");
  expect(list, test::Replace("1,1560510001,100000000", "1,1560510001,000000000"),
         "stereo.csv:3: found time | one after");
  expect(
      "swinging_4/stereo/000001_right.png",
      [](const fs::path& file) { test::WriteImage(file, cv::Mat(30, 48, CV_8UC1, cv::Scalar(9))); },
      "000001_right.png: found 48x30 | 48x32");
  expect(calibration, test::Replace(", -0.1]", ", 0.1]"), "left and right may be swapped");
  settings_["right"] = "cam2";
  EXPECT_THAT(Refused(), HasSubstr("a chain states each camera by the one before"));
}

TEST_F(MultimotionFiles, APartOfTheImagesHasTheirTimes) {
  fs::remove(segment_ / "stereo/000002_left.png");
  EXPECT_THAT(Refused(), HasSubstr("000002_left.png"));
  fs::remove(segment_ / "stereo/000002_right.png");
  EXPECT_THAT(Open().notes, ElementsAre(HasSubstr("stereo.csv: times: 3 for 2 images")));
  fs::remove(segment_ / "stereo/000000_left.png");
  EXPECT_THAT(Refused(), HasSubstr("000000_left.png"));
}

TEST_F(MultimotionFiles, ReportsMissingInput) {
  fs::rename(folder_.path() / "vicon_2019_06_14.yaml", folder_.path() / "other.yaml");
  EXPECT_THAT(Refused(), AllOf(HasSubstr("no vicon*.yaml"), HasSubstr("two folders above")));
  settings_["vicon_calibration"] = "other.yaml";
  EXPECT_EQ(Refused(), "");
  fs::remove(segment_ / "vicon.csv");
  EXPECT_THAT(Open().missing, ElementsAre(HasSubstr("vicon.csv: no ground truth")));
  folder_.Write("kalibr_old.yaml", "");
  EXPECT_THAT(Refused(), HasSubstr("kalibr_2019_06_14.yaml and kalibr_old.yaml"));
}

}  // namespace
}  // namespace cvo::oxford_multimotion_test
