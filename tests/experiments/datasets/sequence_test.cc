// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

// Well-formed folders of each KITTI layout.
#include "experiments/datasets/sequence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/datasets/folders.h"
#include "tests/support/error_message.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Sequences : public testing::Test {
 protected:
  test::TempFolder root_;
};

TEST_F(Sequences, OpensARawDrive) {
  const Sequence s = OpenSequence({.folder = WriteRawDrive(root_)});
  EXPECT_EQ(s.name, "2011_09_26_drive_0001");
  EXPECT_EQ(s.type, "kitti-raw");
  EXPECT_EQ(s.pair, "grey");
  EXPECT_EQ(s.total_frames, 3);
  EXPECT_EQ(s.first_frame, 0);
  EXPECT_EQ(s.camera.fx, 10.0);
  EXPECT_EQ(s.camera.cx, 6.0);
  EXPECT_EQ(s.camera.cy, 4.0);
  EXPECT_EQ(s.camera.baseline_m, 0.5);
  EXPECT_EQ(s.camera.width_px, kTestWidth_px);
  EXPECT_EQ(s.camera.height_px, kTestHeight_px);
  EXPECT_EQ(s.images[2].right.filename(), "0000000002.png");
  EXPECT_EQ(s.timestamps_ns[1] - s.timestamps_ns[0], 100'000'000);
  EXPECT_EQ(s.groundtruth, "devkit");
  ASSERT_EQ(s.groundtruth_world_from_camera.size(), 3u);
  // The vehicle drives east, which is camera z.
  EXPECT_NEAR(s.groundtruth_world_from_camera[2]->translation().z(), 2.0, 1e-4);
  EXPECT_NEAR(s.groundtruth_world_from_camera[2]->translation().head<2>().norm(), 0.0, 1e-4);
  EXPECT_THAT(s.missing, IsEmpty());
}

TEST_F(Sequences, RawDriveListsEveryTextFileThatWasRead) {
  const Sequence s = OpenSequence({.folder = WriteRawDrive(root_)});
  std::vector<std::string> names;
  for (const fs::path& path : s.other_files) {
    names.push_back(path.lexically_relative(s.folder).string());
  }
  EXPECT_THAT(names, ElementsAre("../calib_cam_to_cam.txt", "image_00/timestamps.txt",
                                 "oxts/data/0000000000.txt", "oxts/data/0000000001.txt",
                                 "oxts/data/0000000002.txt", "../calib_velo_to_cam.txt",
                                 "../calib_imu_to_velo.txt"));
}

TEST_F(Sequences, ScenesAndImportsInItsLayoutAreNotOfKitti) {
  const fs::path folder = WriteOdometrySequence(root_);
  EXPECT_EQ(OpenSequence({.folder = folder}).name, "odometry_06");
  EXPECT_EQ(OpenSequence({.folder = folder}).dataset, "kitti");
  for (const char* name : {"scene.json", "import.json"}) {
    const fs::path file = root_.Write("sequences/06/" + std::string(name), "{}");
    EXPECT_EQ(OpenSequence({.folder = folder}).name, "06") << name;
    EXPECT_EQ(OpenSequence({.folder = folder}).dataset, "other") << name;
    fs::remove(file);
  }
}

// The calibration of odometry 04 to 12.
constexpr const char* kKitti06 =
    "P0: 707.0912 0 601.8873 0 0 707.0912 183.1104 0 0 0 1 0\n"
    "P1: 707.0912 0 601.8873 -379.8145 0 707.0912 183.1104 0 0 0 1 0\n";

TEST_F(Sequences, RefusesAnImpossibleCamera) {
  const fs::path there = WriteOdometrySequence(root_);
  root_.Write("sequences/06/calib.txt", kKitti06);
  EXPECT_THAT(
      ErrorMessage([&] { OpenSequence({.folder = there}); }),
      testing::EndsWith("06, calibration: found cx 601.8873, cy 183.1104, expected a centre "
                        "within the images of 12x8 px"));
}

TEST_F(Sequences, ColourTruthTurnsAboutTheColourCamera) {
  // When camera 0 rotates in place by 90 degrees, camera 2 moves along an arc.
  const fs::path folder = WriteRawDrive(root_, 2);
  const std::string drive = folder.lexically_relative(root_.path()).string();
  std::string turned = OxtsPacketText(0.0);
  turned.replace(turned.find(" 100 0 0 0"), 10, " 100 0 0 1.5707963267948966");
  root_.Write(drive + "/oxts/data/0000000001.txt", turned);
  for (const std::string image : {"/image_02", "/image_03"}) {
    WriteImages(root_, drive + image + "/data", 2, 10);
    root_.Write(drive + image + "/timestamps.txt", DateTimeRow(0) + DateTimeRow(1));
  }
  const Sequence grey = OpenSequence({.folder = folder, .pair = "grey"});
  const Sequence colour = OpenSequence({.folder = folder, .pair = "colour"});
  EXPECT_NEAR(grey.groundtruth_world_from_camera[1]->translation().norm(), 0.0, 1e-9);
  // Camera 2 is 6 cm to the left of camera 0, so turning left moves it back and to the right.
  const Eigen::Vector3d moved = colour.groundtruth_world_from_camera[1]->translation();
  EXPECT_NEAR(moved.x(), 0.06, 1e-9);
  EXPECT_NEAR(moved.z(), -0.06, 1e-9);
}

TEST_F(Sequences, RawDriveWithoutOxtsHasNoTruth) {
  const fs::path folder = WriteRawDrive(root_);
  for (const char* removed :
       {"oxts/data/0000000001.txt", "../calib_velo_to_cam.txt", "oxts/data", "oxts"}) {
    fs::remove_all(folder / removed);
    const Sequence s = OpenSequence({.folder = folder});
    EXPECT_EQ(s.groundtruth, "none");
    ASSERT_EQ(s.groundtruth_world_from_camera.size(), 3u);
    EXPECT_FALSE(s.groundtruth_world_from_camera[0].has_value());
    EXPECT_EQ(s.missing.size(), 1u) << removed;
  }
}

// Images 2 to 4 of 8, with what the data set has of all frames.
TEST_F(Sequences, OpensAPartOfARecording) {
  struct Case {
    fs::path whole;
    std::vector<std::string> images;
    std::string name;
  };
  for (const Case& c :
       {Case{WriteRawDrive(root_, 8), {"image_00/data", "image_01/data"}, "000000000"},
        Case{WriteOdometrySequence(root_, 8), {"image_0", "image_1"}, "00000"},
        Case{WriteTrackingSequence(root_, 8), {"../image_02/0005", "../image_03/0005"}, "00000"}}) {
    const Sequence whole = OpenSequence({.folder = c.whole});
    for (const int i : {0, 1, 5, 6, 7}) {
      for (const std::string& folder : c.images)
        ASSERT_TRUE(fs::remove((c.whole / folder / StrCat(c.name, i, ".png")).lexically_normal()));
    }
    const fs::path boxes = root_.Write("boxes.txt",
                                       "1 -1 Car -1 -1 -10 0 0 1 1 -1 -1 -1 -1 -1 -1 -10 0.5\n"
                                       "3 -1 Car -1 -1 -10 0 0 1 1 -1 -1 -1 -1 -1 -1 -10 0.5\n");
    const Sequence part = OpenSequence({.folder = c.whole, .detections_file = boxes});
    EXPECT_EQ(part.first_frame, 2) << c.whole;
    EXPECT_EQ(part.images.size(), 3u);
    EXPECT_EQ(part.images[0].left.filename(), c.name + "2.png");
    EXPECT_EQ(part.timestamps_ns[1] - part.timestamps_ns[0], 100'000'000);
    if (!whole.is_rate_assumed) {
      EXPECT_EQ(part.timestamps_ns[0], whole.timestamps_ns[2]);
    }
    ASSERT_TRUE(part.groundtruth_world_from_camera[2].has_value()) << c.whole;
    const RigidTransform moved =
        part.groundtruth_world_from_camera[0]->Inverse() * *part.groundtruth_world_from_camera[2];
    EXPECT_NEAR(moved.translation().z(), 2.0, 1e-4);
    ASSERT_EQ(part.detections.size(), 1u);
    EXPECT_EQ(part.detections[0].frame, 3);
    EXPECT_FALSE(part.notes.empty());
    const Sequence two = OpenSequence({.folder = c.whole, .begin_frame = 3, .end_frame = 5});
    EXPECT_EQ(two.images[0].left, part.images[1].left);
  }
}

TEST_F(Sequences, OpensAnOdometrySequence) {
  const Sequence s = OpenSequence({.folder = WriteOdometrySequence(root_)});
  EXPECT_EQ(s.type, "kitti-odometry");
  EXPECT_EQ(s.groundtruth, "official");
  EXPECT_THAT(s.timestamps_ns, ElementsAre(0, 100'000'000, 200'000'000));
  EXPECT_EQ(s.groundtruth_world_from_camera[2]->translation(), Eigen::Vector3d(0, 0, 2));
  EXPECT_THAT(s.missing, IsEmpty());
}

TEST_F(Sequences, PosesBesideTheImagesTakePrecedence) {
  const fs::path folder = WriteOdometrySequence(root_);
  root_.Write("sequences/06/poses.txt",
              "1 0 0 0 0 1 0 0 0 0 1 5\n1 0 0 0 0 1 0 0 0 0 1 6\n1 0 0 0 0 1 0 0 0 0 1 7\n");
  EXPECT_EQ(OpenSequence({.folder = folder}).groundtruth_world_from_camera[0]->translation().z(),
            5.0);
}

TEST_F(Sequences, FramesBeyondThePosesHaveNoTruth) {
  const fs::path folder = WriteOdometrySequence(root_);
  root_.Write("poses/06.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1 1");
  const Sequence s = OpenSequence({.folder = folder});
  EXPECT_TRUE(s.groundtruth_world_from_camera[1].has_value());
  EXPECT_FALSE(s.groundtruth_world_from_camera[2].has_value());
  EXPECT_THAT(s.missing, ElementsAre(HasSubstr("poses of the last 1 of 3 frames")));
}

TEST_F(Sequences, OpensTrackingInBothCalibrationDialects) {
  const fs::path folder = WriteTrackingSequence(root_);
  for (const bool with_colons : {true, false}) {
    root_.Write("training/calib/0005.txt", TrackingCalibration(with_colons));
    const Sequence s = OpenSequence({.folder = folder});
    EXPECT_EQ(s.name, "tracking_0005");
    EXPECT_EQ(s.type, "kitti-tracking");
    EXPECT_EQ(s.pair, "colour");
    EXPECT_NEAR(s.camera.baseline_m, 0.5, 1e-15);
    EXPECT_THAT(s.timestamps_ns, ElementsAre(0, 100'000'000, 200'000'000));
    EXPECT_EQ(s.groundtruth, "devkit");
    EXPECT_NEAR(s.groundtruth_world_from_camera[2]->translation().z(), 2.0, 1e-4);
    ASSERT_EQ(s.labels.size(), 2u);
    // The boxes are drawn in image_02 and the left image is image_02, so they are not shifted.
    EXPECT_EQ(s.labels[0].left_px, 4.5);
    EXPECT_THAT(s.missing, IsEmpty());
  }
}

TEST_F(Sequences, TrackingWithOtherFramesThanImages) {
  const fs::path folder = WriteTrackingSequence(root_);
  root_.Write("training/oxts/0005.txt", OxtsPacketText(0) + OxtsPacketText(1));
  const std::string label = " -1 Car 0 0 0 0 0 1 1 1 1 1 1 1 1 1\n";
  const fs::path labels = root_.Write("training/label_02/0005.txt", "1" + label + "9" + label);
  const Sequence s = OpenSequence({.folder = folder});
  EXPECT_EQ(s.groundtruth, "none");
  EXPECT_THAT(s.missing, ElementsAre(HasSubstr("0005.txt: too few packets")));
  EXPECT_EQ(s.labels.size(), 1u);
  EXPECT_THAT(s.notes, ElementsAre(HasSubstr("labels up to frame 9, images up to 2")));
  EXPECT_THAT(ErrorMessage([&] { OpenSequence({.folder = folder, .labels_file = labels}); }),
              HasSubstr("0005.txt:2: found frame 9, expected a frame of the sequence, 0 to 2"));
}

TEST_F(Sequences, OpensTrackingByItsImageFolderOrWithASlash) {
  const fs::path folder = WriteTrackingSequence(root_);
  for (const fs::path& same : {root_.path() / "training/image_02/0005", folder / "",
                               root_.path() / "training/image_03/../image_02/./0005/"}) {
    const Sequence s = OpenSequence({.folder = same});
    EXPECT_EQ(s.name, "tracking_0005") << same;
    EXPECT_EQ(s.folder, folder) << same;
  }
}

TEST_F(Sequences, FrameRangeAppliesToEverything) {
  const fs::path boxes = root_.Write("boxes.txt",
                                     "0 -1 Car -1 -1 -10 0 0 4 4 -1 -1 -1 -1 -1 -1 -10 0.5\n"
                                     "2 -1 Car -1 -1 -10 0 0 4 4 -1 -1 -1 -1 -1 -1 -10 0.5\n"
                                     "4 -1 Car -1 -1 -10 0 0 4 4 -1 -1 -1 -1 -1 -1 -10 0.5\n");
  const Sequence s = OpenSequence({.folder = WriteRawDrive(root_, 5),
                                   .begin_frame = 1,
                                   .end_frame = 4,
                                   .detections_file = boxes});
  EXPECT_EQ(s.first_frame, 1);
  EXPECT_EQ(s.total_frames, 5);
  ASSERT_EQ(s.images.size(), 3u);
  EXPECT_EQ(s.images[0].left.filename(), "0000000001.png");
  EXPECT_EQ(s.timestamps_ns.size(), 3u);
  // The world frame remains the first camera of the drive, not of the frame range.
  EXPECT_NEAR(s.groundtruth_world_from_camera[0]->translation().z(), 1.0, 1e-4);
  ASSERT_EQ(s.detections.size(), 1u);
  EXPECT_EQ(s.detections[0].frame, 2);
}

TEST_F(Sequences, ReadsBoxesOfOtherFilesAndCameras) {
  const fs::path detections =
      root_.Write("boxes.txt",
                  "0 -1 Car -1 -1 -10 0 0 1 1 -1 -1 -1 -1 -1 -1 -10 -0.5\n"
                  "0 -1 Car -1 -1 -10 0 0 1 1 -1 -1 -1 -1 -1 -1 -10 0.5\n"
                  "1 -1 Van -1 -1 -10 0 0 1 1 -1 -1 -1 -1 -1 -1 -10 0.25\n");
  const Sequence s = OpenSequence({.folder = WriteRawDrive(root_),
                                   .labels_file = root_.Write("labels.txt", kCarLabel),
                                   .detections_file = detections,
                                   .detections_camera = 2,
                                   .min_score = 0.5});
  // Only boxes strictly below the minimum score are removed.
  ASSERT_EQ(s.detections.size(), 1u);
  EXPECT_EQ(s.detections[0].score, 0.5);
  EXPECT_EQ(s.detections[0].left_px, 0.0);
  EXPECT_NEAR(s.detections_offset_m, 0.06, 1e-15);
  // The label moves left by fx offset / z = 10 * 0.06 / 4 px. The label without a depth does not
  // move.
  ASSERT_EQ(s.labels.size(), 2u);
  EXPECT_NEAR(s.labels[0].left_px, 4.5 - 0.15, 1e-12);
  EXPECT_NEAR(s.labels[0].right_px, 9.5 - 0.15, 1e-12);
  EXPECT_EQ(s.labels[1].left_px, 1.0);
}

TEST_F(Sequences, FindsSequencesWithImages) {
  WriteRawDrive(root_);
  WriteOdometrySequence(root_);
  WriteTrackingSequence(root_);
  root_.Write("training/calib/0003.txt", TrackingCalibration(true));
  root_.Write("training/label_02/0003.txt", kCarLabel);
  root_.Write("other/readme.txt", "nothing");
  const std::vector<FoundSequence> found = FindSequences(root_.path());
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].type, "kitti-raw");
  EXPECT_EQ(found[1].type, "kitti-odometry");
  EXPECT_EQ(found[2].type, "kitti-tracking");
  EXPECT_EQ(found[2].folder, root_.path() / "training/0005");
  for (const FoundSequence& s : found) {
    EXPECT_EQ(OpenSequence({.folder = s.folder}).type, s.type);
    const std::vector<FoundSequence> itself = FindSequences(s.folder);
    ASSERT_EQ(itself.size(), 1u);
    EXPECT_EQ(itself[0].folder, s.folder);
  }
  EXPECT_THAT(FindSequences(root_.path() / "other"), IsEmpty());
}

TEST_F(Sequences, FindStopsAtCyclicLinks) {
  WriteOdometrySequence(root_);
  fs::create_directory_symlink(root_.path(), root_.path() / "again");
  EXPECT_EQ(FindSequences(root_.path()).size(), 1u);
}

TEST(DetectionsFromLabels, KeepOnlyTheBoxes) {
  const test::TempFolder root;
  const fs::path folder = WriteTrackingSequence(root);
  const Sequence s = OpenSequence({.folder = folder, .detections_file = kDetectionsFromLabels});
  ASSERT_EQ(s.detections.size(), s.labels.size());
  EXPECT_EQ(s.detections[0].type, "Car");
  EXPECT_EQ(s.detections[0].left_px, s.labels[0].left_px);
  EXPECT_EQ(s.detections[0].bottom_px, s.labels[0].bottom_px);
  EXPECT_EQ(s.detections[0].track, -1);
  EXPECT_FALSE(s.detections[0].box3d.has_value());
  EXPECT_EQ(s.detections_offset_m, 0.0);
  EXPECT_THROW(
      OpenSequence({.folder = folder, .detections_file = kDetectionsFromLabels, .min_score = 0.5}),
      Error);
}

TEST(DetectionsFromLabels, AreLimitedToTheNamedTracks) {
  const test::TempFolder root;
  const fs::path folder = WriteTrackingSequence(root);
  const auto boxes = [&](const char* detections) {
    return OpenSequence({.folder = folder, .detections_file = detections}).detections.size();
  };
  const Sequence all = OpenSequence({.folder = folder, .detections_file = "labels"});
  const int first = all.labels[0].track;
  const auto of_first = std::count_if(all.labels.begin(), all.labels.end(),
                                      [&](const ObjectBox& label) { return label.track == first; });
  EXPECT_EQ(boxes(StrCat("labels:", first, "-", first).c_str()), of_first);
  EXPECT_EQ(boxes("labels:0-1000"), static_cast<std::size_t>(std::count_if(
                                        all.labels.begin(), all.labels.end(),
                                        [](const ObjectBox& label) { return label.track >= 0; })));
  EXPECT_EQ(boxes("labels:900-1000"), 0U);
  for (const char* wrong : {"labels:", "labels:1", "labels:2-1", "labels:1-x", "labels:1-2,3"}) {
    EXPECT_THAT(ErrorMessage([&] { boxes(wrong); }),
                HasSubstr(StrCat("option --detections: found \"", wrong, "\", expected labels")));
  }
}

}  // namespace
}  // namespace cvo
