// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "core/base/error.h"
#include "core/files/text_file.h"
#include "experiments/datasets/images.h"
#include "tests/experiments/datasets/layouts/written_scene.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::euroc_test {
namespace {

namespace fs = std::filesystem;
using test::NumbersText;
using test::WrittenScene;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::int64_t kStart_ns = 1'403'636'579'000'000'000;

struct Lens {
  std::vector<double> intrinsics;
  std::string coefficients = "0, 0, 0, 0";
  std::string body_from_camera;  // 16 numbers
};

std::string SensorText(const Lens& lens, int width_px, int height_px) {
  return StrCat("#Default VI sensor cam\nsensor_type: camera\ncomment: VI-Sensor\n\n", "T_BS:\n",
                "  cols: 4\n  rows: 4\n  data: [", lens.body_from_camera, "]\n\nrate_hz: 20\n",
                "resolution: [", width_px, ", ", height_px, "]\ncamera_model: pinhole\n",
                "intrinsics: [", NumbersText(lens.intrinsics, ", "), "] #fu, fv, cu, cv\n",
                "distortion_model: radial-tangential\ndistortion_coefficients: [",
                lens.coefficients, "]\n");
}

const RigidTransform kBodyFromLeft(ExpSo3({0.3, -1.2, 0.5}), Eigen::Vector3d(-0.02, 0.06, 0.01));

// As in EuRoC, poses are those of a body frame that is not the camera.
void WriteEuroc(const test::TempFolder& root, const WrittenScene& scene) {
  const StereoCamera& c = scene.camera;
  std::string list = "#timestamp [ns],filename\r\n";
  std::string truth =
      "#timestamp, p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x []\n";
  for (std::size_t k = 0; k < scene.frames(); ++k) {
    const std::string name = StrCat(kStart_ns + scene.times_ns[k], ".png");
    list += StrCat(kStart_ns + scene.times_ns[k], ",", name, "\r\n");
    for (int side = 0; side < 2; ++side) {
      test::WriteImage(root.path() / StrCat("mav0/cam", side, "/data/", name),
                       scene.images[k][static_cast<std::size_t>(side)]);
    }
    const RigidTransform body =
        RigidTransform(ExpSo3({0.2, 0.1, 3.0}), Eigen::Vector3d(4.0, -2.0, 1.0)) *
        scene.world_from_left[k] * kBodyFromLeft.Inverse();
    const auto q = body.rotation();
    const auto t = body.translation();
    truth +=
        StrCat(kStart_ns + scene.times_ns[k], ",") +
        NumbersText({t.x(), t.y(), t.z(), q.w(), q.x(), q.y(), q.z(), 0.1, 0, 0, 0, 0, 0, 0, 0, 0},
                    ",") +
        "\n";
  }
  for (int side = 0; side < 2; ++side) {
    const RigidTransform at(Eigen::Quaterniond::Identity(),
                            Eigen::Vector3d(side * c.baseline_m, 0.0, 0.0));
    root.Write(StrCat("mav0/cam", side, "/data.csv"), list);
    root.Write(
        StrCat("mav0/cam", side, "/sensor.yaml"),
        SensorText(
            {{c.fx, c.fy, c.cx, c.cy}, "0, 0, 0, 0", test::MatrixText(kBodyFromLeft * at, ", ")},
            c.width_px, c.height_px));
  }
  root.Write("mav0/state_groundtruth_estimate0/data.csv", truth);
}

TEST(Euroc, GivesTheSameSequenceAsOurOwnLayout) {
  const test::TempFolder own_folder, folder;
  const test::OwnScene own(own_folder.path() / "scene");
  WriteEuroc(folder, own.written());
  const Sequence sequence =
      OpenSequence({.folder = folder.path(), .detections_file = own.detections()});
  EXPECT_EQ(sequence.type, "euroc");
  EXPECT_EQ(sequence.pair, "grey");
  EXPECT_EQ(sequence.timestamps_ns[0], kStart_ns + own.written().times_ns[0]);
  EXPECT_EQ(sequence.rectification, nullptr);
  EXPECT_THAT(sequence.missing, IsEmpty());
  test::ExpectSameSequence(own.Open(), sequence);
}

class EurocFiles : public testing::Test {
 protected:
  EurocFiles() { WriteEuroc(folder_, test::SmallScene()); }
  std::string Refused() const {
    return ErrorMessage([&] { OpenSequence({.folder = folder_.path()}); });
  }
  fs::path File(const std::string& name) const { return folder_.path() / "mav0" / name; }

  test::TempFolder folder_;
};

// Images with lens distortion are rectified (the result is tested in rectification_test.cc), and
// the poses of the left camera are rotated accordingly.
TEST_F(EurocFiles, RectifiesDistortedImages) {
  const RigidTransform before =
      *OpenSequence({.folder = folder_.path()}).groundtruth_world_from_camera[2];
  test::Replace("coefficients: [0, 0, 0, 0]",
                "coefficients: [-0.1, 0.01, 0.0002, 0.00002]")(File("cam0/sensor.yaml"));
  const Sequence sequence = OpenSequence({.folder = folder_.path()});
  ASSERT_NE(sequence.rectification, nullptr);
  EXPECT_NEAR(sequence.camera.baseline_m, 0.1, 1e-9);
  const RigidTransform turn(sequence.rectification->rectified_from_left(), Eigen::Vector3d::Zero());
  const RigidTransform expected = turn * before * turn.Inverse();
  EXPECT_LT((expected.Inverse() * *sequence.groundtruth_world_from_camera[2]).translation().norm(),
            1e-9);
  const LoadedImage raw = LoadGrey(sequence.images[0].left);
  const LoadedImage image = LoadFrameImage(sequence, 0, 0);
  ASSERT_TRUE(image.ok());
  EXPECT_EQ(image.grey.size(), raw.grey.size());
  EXPECT_GT(cv::norm(image.grey, raw.grey, cv::NORM_L1), 0.0);
}

TEST_F(EurocFiles, ImagesArePairedByTime) {
  test::DropRow(2)(File("cam1/data.csv"));
  const Sequence sequence = OpenSequence({.folder = folder_.path() / "mav0"});
  EXPECT_EQ(sequence.images.size(), 2U);
  EXPECT_EQ(sequence.images[0].left.filename(), sequence.images[0].right.filename());
  EXPECT_THAT(sequence.missing, ElementsAre(HasSubstr("left out: 1 left, 0 right")));
  EXPECT_EQ(sequence.name, folder_.path().filename());
}

TEST_F(EurocFiles, FramesBeyondTheTruthHaveNoPose) {
  test::DropRow(4)(File("state_groundtruth_estimate0/data.csv"));
  const Sequence sequence = OpenSequence({.folder = folder_.path()});
  EXPECT_FALSE(sequence.groundtruth_world_from_camera[2]);
  EXPECT_THAT(sequence.missing, ElementsAre(HasSubstr("1 of 3 frames")));
  fs::remove(File("state_groundtruth_estimate0/data.csv"));
  EXPECT_THAT(OpenSequence({.folder = folder_.path()}).missing,
              ElementsAre(HasSubstr("data.csv: no ground truth")));
}

// TUM-VI names its ground truth otherwise, and has it only where the motion capture saw the camera.
TEST_F(EurocFiles, MotionCaptureHasGaps) {
  fs::rename(File("state_groundtruth_estimate0"), File("mocap0"));
  EXPECT_THAT(OpenSequence({.folder = folder_.path()}).missing, IsEmpty());
  test::DropRow(3)(File("mocap0/data.csv"));
  EXPECT_TRUE(OpenSequence({.folder = folder_.path()}).groundtruth_world_from_camera[1]);
  for (const char* list : {"cam0/data.csv", "cam1/data.csv", "mocap0/data.csv"}) {
    test::Replace("1403636580200000000,", "1403636580900000000,")(File(list));
  }
  const Sequence sequence = OpenSequence({.folder = folder_.path()});
  EXPECT_FALSE(sequence.groundtruth_world_from_camera[1]);
  EXPECT_TRUE(sequence.groundtruth_world_from_camera[2]);
  EXPECT_THAT(sequence.missing, ElementsAre(HasSubstr("1 of 3 frames")));
}

TEST_F(EurocFiles, RowsWithoutAnImageAreLeftOut) {
  const std::size_t all = OpenSequence({.folder = folder_.path()}).images.size();
  const fs::path images = folder_.path() / "mav0/cam0/data";
  fs::remove(images / "1403636580000000000.png");
  const Sequence sequence = OpenSequence({.folder = folder_.path()});
  EXPECT_EQ(sequence.images.size(), all - 1);
  EXPECT_THAT(sequence.notes, ElementsAre(HasSubstr("cam0/data.csv: 1 rows without an image")));
  fs::remove_all(images);
  fs::create_directory(images);
  EXPECT_THAT(Refused(), HasSubstr("cam0/data.csv:2: found no image in"));
}

TEST_F(EurocFiles, BadRowsAreRefusedWithFileAndRow) {
  const std::string list = "mav0/cam0/data.csv";
  const std::string truth = "mav0/state_groundtruth_estimate0/data.csv";
  const auto expect = [&](const std::string& file, const test::Edit& edit,
                          const std::string& says) {
    test::ExpectRefused({.folder = folder_.path()}, folder_.path() / file, edit, says);
  };
  expect(list, test::RepeatRow(2),
         "cam0/data.csv:3: found time 1403636580.0 | of cam0, expected one after");
  expect(list, test::CutEnd(28), "cam0/data.csv:4 | 1 columns");
  expect(truth, test::Replace("1403636580100000000,", "1403636580000000000,"),
         "state_groundtruth_estimate0/data.csv:3: found time");
  expect(truth, test::Replace("1403636580000000000,", "1403636580000000000,x"),
         "data.csv:2: found \"x | a finite number");
  expect("mav0/cam0/sensor.yaml", test::Replace("resolution: [48", "resolution: [752"),
         "a calibration of 752x32 | 48x32 px");
}

TEST_F(EurocFiles, MismatchedImagesAndCamerasAreRefused) {
  const fs::path image = OpenSequence({.folder = folder_.path()}).images[1].right;
  test::WriteImage(image, cv::Mat(32, 50, CV_8UC1, cv::Scalar(9)));
  EXPECT_THAT(Refused(), AllOf(HasSubstr("50x32 pixels"), HasSubstr("48x32")));
  test::WriteImage(image, cv::Mat(32, 48, CV_8UC1, cv::Scalar(9)));
  const fs::path left = File("cam0/sensor.yaml");
  fs::rename(left, File("other.yaml"));
  fs::rename(File("cam1/sensor.yaml"), left);
  fs::rename(File("other.yaml"), File("cam1/sensor.yaml"));
  EXPECT_THAT(Refused(), HasSubstr("left and right may be swapped"));
  EXPECT_THAT(ErrorMessage([&] {
                OpenSequence({.folder = folder_.path(), .layout = {{"offset", 1}}});
              }),
              AllOf(HasSubstr("key \"offset\""), HasSubstr("none for euroc")));
}

}  // namespace
}  // namespace cvo::euroc_test
