// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <sstream>

#include "core/base/error.h"
#include "core/files/text_file.h"
#include "experiments/datasets/body_truth.h"
#include "experiments/datasets/formats/image_format.h"
#include "tests/experiments/datasets/layouts/written_scene.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::virtual_kitti_test {
namespace {

namespace fs = std::filesystem;
using test::NumbersText;
using test::WrittenScene;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// Far from the origin, as in the data set.
const RigidTransform kDataFromWorld(ExpSo3({0.1, -2.0, 0.05}), Eigen::Vector3d(53.0, -106.0, 80.0));

std::string Digits5(std::size_t frame, const char* ending) { return StrCat("0000", frame, ending); }

// Returns the angles about y, x and z, in rad, of the rotation Ry Rx Rz.
std::vector<double> Angles(const Eigen::Matrix3d& r) {
  return {std::atan2(r(0, 2), r(2, 2)), std::asin(-r(1, 2)), std::atan2(r(1, 0), r(1, 1))};
}

// Converts from our object frame, with z up and its origin at the centre, to that of the data set,
// with y down and its origin at the bottom.
RigidTransform BottomOf(const RigidTransform& world_from_object, const Eigen::Vector3d& size_m) {
  Eigen::Matrix3d turn;
  turn << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return world_from_object * RigidTransform(turn, Eigen::Vector3d(0.0, 0.0, -0.5 * size_m.z()));
}

std::string PlaceText(const RigidTransform& pose) {
  const Eigen::Vector3d t = pose.translation();
  return NumbersText({t.x(), t.y(), t.z()}, " ") + " " +
         NumbersText(Angles(pose.RotationMatrix()), " ");
}

struct Tables {
  std::string extrinsic = "frame cameraID r1,1 r1,2 r1,3 t1\n";
  std::string intrinsic = "frame cameraID K[0,0] K[1,1] K[0,2] K[1,2]\n";
  std::string pose = "frame cameraID trackID alpha width height length\n";
  std::string bbox = "frame cameraID trackID left right top bottom number_pixels\n";
  std::string info = "trackID label model color\n";
};

int PixelsOf(const cv::Mat& mask, int id) { return cv::countNonZero(mask == id); }

void AddBodies(const WrittenScene& scene, std::size_t k, int camera,
               const RigidTransform& camera_from_data, Tables& tables) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const WrittenScene::Body& body = scene.bodies[i];
    const RigidTransform data_from_object =
        kDataFromWorld * BottomOf(body.world_from_object[k], body.size_m);
    const std::string place = StrCat(k, " ", camera, " ", i, " ");
    tables.pose +=
        place + NumbersText({0.5, body.size_m.y(), body.size_m.z(), body.size_m.x()}, " ") + " " +
        PlaceText(data_from_object) + " " + PlaceText(camera_from_data * data_from_object) + "\n";
    tables.bbox += place + StrCat("4 27 4 27 ", PixelsOf(scene.masks[k], static_cast<int>(i) + 1),
                                  " 0 0.9 True\n");
  }
}

// Writes the three archives side by side: <root>/vkitti_{rgb,textgt,instanceSegmentation}.
fs::path WriteVirtualKitti(const test::TempFolder& root, const WrittenScene& scene) {
  const fs::path below = "Scene01/clone";
  const StereoCamera& c = scene.camera;
  Tables tables;
  for (std::size_t k = 0; k < scene.frames(); ++k) {
    for (int side = 0; side < 2; ++side) {
      const RigidTransform side_from_left(Eigen::Quaterniond::Identity(),
                                          Eigen::Vector3d(-side * c.baseline_m, 0.0, 0.0));
      const RigidTransform camera_from_data =
          side_from_left * (kDataFromWorld * scene.world_from_left[k]).Inverse();
      const std::string place = StrCat(k, " ", side, " ");
      tables.extrinsic += place + test::MatrixText(camera_from_data, " ") + "\n";
      tables.intrinsic += place + NumbersText({c.fx, c.fy, c.cx, c.cy}, " ") + "\n";
      AddBodies(scene, k, side, camera_from_data, tables);
      test::WriteImage(root.path() / "vkitti_rgb" / below / "frames/rgb" / StrCat("Camera_", side) /
                           ("rgb_" + Digits5(k, ".jpg")),
                       scene.images[k][static_cast<std::size_t>(side)]);
    }
    cv::Mat mask;
    scene.masks[k].convertTo(mask, CV_8UC1);
    test::WriteImage(root.path() / "vkitti_instanceSegmentation" / below /
                         "frames/instanceSegmentation/Camera_0" /
                         ("instancegt_" + Digits5(k, ".png")),
                     mask);
  }
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    tables.info += StrCat(i, " Car Model", i, " Red\n");
  }
  const fs::path text = "vkitti_textgt" / below;
  root.Write(text / "extrinsic.txt", tables.extrinsic);
  root.Write(text / "intrinsic.txt", tables.intrinsic);
  root.Write(text / "pose.txt", tables.pose);
  root.Write(text / "bbox.txt", tables.bbox);
  root.Write(text / "info.txt", tables.info);
  return root.path() / "vkitti_rgb" / below;
}

TEST(VirtualKitti, GivesTheSameErrorsAsOurOwnLayout) {
  const test::TempFolder own_folder, folder;
  test::OwnScene own(own_folder.path() / "scene");
  const Sequence sequence = OpenSequence({.folder = WriteVirtualKitti(folder, own.written()),
                                          .detections_file = own.detections(),
                                          .layout = {{"mover_travel_m", 0.2}}});
  own.CompressImages();
  EXPECT_EQ(sequence.type, "virtual-kitti");
  EXPECT_EQ(sequence.name, "Scene01_clone");
  EXPECT_EQ(sequence.dataset, "other");
  EXPECT_THAT(sequence.missing, IsEmpty());
  test::ExpectSameSequence(own.Open(), sequence);
  test::ExpectSameErrors(own.Open(), sequence, true, true);
}

class VirtualKittiFiles : public testing::Test {
 protected:
  VirtualKittiFiles() {
    WrittenScene scene = test::SmallScene();
    scene.masks[1] = cv::Scalar(0);  // a body of 399 px does not count as visible
    scene.masks[1](cv::Rect(0, 0, 21, 19)) = cv::Scalar(1);
    images_ = WriteVirtualKitti(folder_, scene);
    text_ = folder_.path() / "vkitti_textgt/Scene01/clone";
  }
  Sequence Open() const { return OpenSequence({.folder = images_}); }
  std::string Refused() const {
    return ErrorMessage([&] { Open(); });
  }

  test::TempFolder folder_;
  fs::path images_;
  fs::path text_;
};

TEST_F(VirtualKittiFiles, BoxesBecomeLabelsWithTracks) {
  const Sequence sequence = Open();
  ASSERT_EQ(sequence.labels.size(), 6U);
  EXPECT_EQ(sequence.labels[1].track, 1);
  EXPECT_EQ(sequence.labels[1].right_px, 27.0);
  EXPECT_EQ(sequence.labels[1].top_px, 4.0);
  const auto truth = ReadBodyTruth(sequence);
  EXPECT_EQ(truth->BodyOfTrack(1), 2);
  EXPECT_EQ(truth->BodyOfTrack(2), -1);
  EXPECT_TRUE(truth->objects().bodies[0].frames[0]->visible);
  EXPECT_FALSE(truth->objects().bodies[0].frames[1]->visible);
  EXPECT_EQ(truth->Find(0, {16, 16}, {0, 0, 2}).body, 1);
  EXPECT_EQ(OpenSequence({.folder = images_, .detections_file = "labels"}).detections.size(), 6U);
}

TEST_F(VirtualKittiFiles, MasksArePartOfItsIdentity) {
  const auto name = [](const fs::path& file) { return file.filename().string(); };
  EXPECT_THAT(Open().other_files,
              testing::Contains(testing::ResultOf(name, "instancegt_00001.png")));
}

TEST_F(VirtualKittiFiles, ReportsMissingInput) {
  fs::remove_all(folder_.path() / "vkitti_instanceSegmentation");
  EXPECT_THAT(Open().missing, ElementsAre(HasSubstr("no masks")));
  fs::remove(text_ / "pose.txt");
  EXPECT_THAT(Open().missing, ElementsAre(HasSubstr("pose.txt: no poses of bodies")));
  fs::remove(text_ / "extrinsic.txt");
  EXPECT_THAT(Refused(), HasSubstr("extrinsic.txt"));
}

// Swaps the numbers of the cameras, the second cell of each row.
void SwapCameras(const fs::path& file) {
  const TextFile lines(file);
  std::string text = lines.line(0) + "\n";
  for (std::size_t i = 1; i < lines.size(); ++i) {
    std::string line = lines.line(i);
    line[2] = line[2] == '0' ? '1' : '0';
    text += line + "\n";
  }
  WriteFileBytes(file, text);
}

TEST_F(VirtualKittiFiles, BadRowsAreRefusedWithFileAndRow) {
  const std::string extrinsic = "extrinsic.txt";
  const std::string pose = "pose.txt";
  std::vector<std::string> cells;
  std::istringstream row(TextFile(text_ / pose).line(1));
  for (std::string cell; row >> cell;) cells.push_back(cell);
  const std::string elsewhere = "9" + cells[13].substr(cells[13].starts_with('-') ? 1 : 0);
  const auto expect = [&](const std::string& file, const test::Edit& edit,
                          const std::string& says) {
    test::ExpectRefused({.folder = images_}, text_ / file, edit, says);
  };
  expect(extrinsic, test::RepeatRow(3), "extrinsic.txt:4: found frame 0, camera 1 a second time");
  expect(extrinsic, test::DropRow(7), "extrinsic.txt: found no row of frame 2, camera 1");
  expect(extrinsic, SwapCameras,
         "extrinsic.txt:2: found camera 1 at -0.1 | to the right of camera 0");
  expect("intrinsic.txt", test::Replace("1 0 40", "1 0 41"),
         "intrinsic.txt:4: found 41 | 40, as in");
  expect(pose, test::RepeatRow(2), "pose.txt:3: found frame 0, track 0 a second time");
  expect(pose, test::CutEnd(60), "pose.txt:13: found | columns");
  expect(pose, test::Replace("0 0 1 0.5", "0 0 7 0.5"), "pose.txt:3: found track 7 | info.txt");
  expect(pose, test::Replace(cells[13], elsewhere), "pose.txt:2: found a place | extrinsic.txt");
  expect(pose, test::Replace(cells[16], "0.7"), "pose.txt:2: found turns | Ry Rx Rz");
}

TEST_F(VirtualKittiFiles, DamagedOrMissingImagesAreRefused) {
  const fs::path image = images_ / "frames/rgb/Camera_1/rgb_00001.jpg";
  test::WriteImage(image, cv::Mat(32, 40, CV_8UC1, cv::Scalar(5)));
  EXPECT_THAT(Refused(), AllOf(HasSubstr("rgb_00001.jpg: found 40x32"), HasSubstr("48x32")));
  WriteFileBytes(image, "no image");
  EXPECT_THAT(Refused(), HasSubstr("rgb_00001.jpg: found a file without the header of a JPEG"));
  fs::remove(image);
  EXPECT_THAT(Refused(), HasSubstr("Camera_1: found 2 files without number 1"));
}

// A 4 x 2 px image with the indexes 0 1 2 2 and 2 1 0 1 into a palette of black, red and green.
TEST(PaletteIndexes, AreReadAsIndexes) {
  constexpr std::string_view kHex =
      "89504e470d0a1a0a0000000d494844520000000400000002080300000048768d5100000009504c5445000000c80a"
      "1e"
      "0ac81e7015a8e7000000124944415478da6360606462626062646004000038000a208fc48e0000000049454e44ae"
      "42"
      "6082";
  std::string bytes;
  for (std::size_t i = 0; i < kHex.size(); i += 2) {
    bytes += static_cast<char>(std::stoi(std::string(kHex.substr(i, 2)), nullptr, 16));
  }
  const test::TempFolder folder;
  const fs::path path = folder.Write("mask.png", bytes);
  const cv::Mat indexes = ReadPaletteIndexes(path, {4, 2});
  const std::vector<std::uint16_t> expected = {0, 1, 2, 2, 2, 1, 0, 1};
  EXPECT_EQ(
      std::vector<std::uint16_t>(indexes.begin<std::uint16_t>(), indexes.end<std::uint16_t>()),
      expected);
  EXPECT_THAT(ErrorMessage([&] { ReadPaletteIndexes(path, {4, 3}); }), HasSubstr("4x2 pixels"));
  folder.Write("mask.png", bytes.substr(0, 60));
  EXPECT_THAT(ErrorMessage([&] { ReadPaletteIndexes(path, {4, 2}); }), HasSubstr("cut short"));
}

}  // namespace
}  // namespace cvo::virtual_kitti_test
