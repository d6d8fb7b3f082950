// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

// Malformed folders. Every message names the file, and the line or field, what was found and what
// was expected.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "experiments/datasets/sequence.h"
#include "tests/experiments/datasets/folders.h"
#include "tests/support/error_message.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

std::string OpenError(const SequenceRequest& request) {
  return ErrorMessage([&] { OpenSequence(request); });
}

MATCHER_P3(Says, where, found, expected, "") {
  const std::string message = arg;
  const std::size_t a = message.find(where);
  const std::size_t b = message.find(std::string(": found ") + found, a);
  const std::size_t c = message.find(", expected ", b);
  return a != std::string::npos && b != std::string::npos && c != std::string::npos &&
         message.find(expected, c) != std::string::npos && message.find('\n') == std::string::npos;
}

class BadRawDrive : public testing::Test {
 protected:
  std::string Error() const { return OpenError({.folder = folder_}); }
  std::string InterpolatedError() const {
    return OpenError({.folder = folder_, .groundtruth = "interpolated"});
  }
  void Write(const std::string& name, const std::string& text) const {
    root_.Write(fs::path("2011_09_26/2011_09_26_drive_0001_sync") / name, text);
  }
  // Replaces one line of the camera calibration.
  void Calibrate(const std::string& key, const std::string& values) const {
    const fs::path path = folder_.parent_path() / "calib_cam_to_cam.txt";
    std::ifstream in(path);
    std::string text, line;
    while (std::getline(in, line)) {
      text += line.starts_with(key + ":") ? key + ": " + values + "\n" : line + "\n";
    }
    in.close();
    root_.Write("2011_09_26/calib_cam_to_cam.txt", text);
  }

  test::TempFolder root_;
  fs::path folder_ = WriteRawDrive(root_, 4);
};

TEST_F(BadRawDrive, MissingCalibration) {
  fs::remove(folder_.parent_path() / "calib_cam_to_cam.txt");
  EXPECT_THAT(Error(), Says("calib_cam_to_cam.txt", "no such file", "can be read"));
}

TEST_F(BadRawDrive, MissingVelodyneCalibration) {
  fs::remove(folder_.parent_path() / "calib_velo_to_cam.txt");
  EXPECT_THAT(Error(), Says("calib_velo_to_cam.txt", "no such file", "can be read"));
}

TEST_F(BadRawDrive, CalibrationCutShort) {
  Calibrate("P_rect_01", "10 0 6 -5 0 10 4");
  EXPECT_THAT(Error(), Says("calib_cam_to_cam.txt:8", "8 columns", "P_rect_01 and 12 numbers"));
}

TEST_F(BadRawDrive, CalibrationWithoutAKey) {
  root_.Write("2011_09_26/calib_cam_to_cam.txt", "P_rect_00: " + ProjectionRow(0.0) + "\n");
  EXPECT_THAT(Error(), Says("calib_cam_to_cam.txt", "no P_rect_01", "one projection per camera"));
}

TEST_F(BadRawDrive, MalformedCalibration) {
  Calibrate("P_rect_00", "10 0 6 0 0 1O 4 0 0 0 1 0");
  EXPECT_THAT(Error(), Says("calib_cam_to_cam.txt:5", "\"1O\" in column 7", "a finite number"));
  Calibrate("P_rect_00", "10 0 6 0 0 nan 4 0 0 0 1 0");
  EXPECT_THAT(Error(), Says("calib_cam_to_cam.txt:5", "\"nan\" in column 7", "a finite number"));
}

TEST_F(BadRawDrive, CalibrationOfAnUnrectifiedCamera) {
  Calibrate("P_rect_00", "10 1 6 0 0 10 4 0 0 0 1 0");
  EXPECT_THAT(Error(), Says("P_rect_00", "a matrix of another form", "a rectified camera"));
  Calibrate("P_rect_00", "-10 0 6 0 0 10 4 0 0 0 1 0");
  EXPECT_THAT(Error(), Says("P_rect_00", "focal lengths -10", "positive"));
  Calibrate("P_rect_00", "11 0 6 0 0 10 4 0 0 0 1 0");
  EXPECT_THAT(Error(), Says("P_rect_00 and P_rect_01", "different focal lengths", "equal ones"));
  Calibrate("P_rect_00", "10 0 6.1 0 0 10 4 0 0 0 1 0");
  EXPECT_THAT(Error(), Says("P_rect_00 and P_rect_01", "different focal lengths", "equal ones"));
}

TEST_F(BadRawDrive, NonPositiveBaseline) {
  Calibrate("P_rect_01", ProjectionRow(0.0));
  EXPECT_THAT(Error(), Says("P_rect_00 and P_rect_01", "a baseline of 0 m", "a positive one"));
  Calibrate("P_rect_01", ProjectionRow(0.5));
  EXPECT_THAT(Error(), Says("P_rect_00 and P_rect_01", "a baseline of -0.5 m", "a positive one"));
}

TEST_F(BadRawDrive, DuplicateCalibrationKey) {
  Calibrate("P_rect_01", ProjectionRow(-0.5) + "\nP_rect_01: " + ProjectionRow(-0.4));
  EXPECT_THAT(Error(), Says("calib_cam_to_cam.txt:9", "\"P_rect_01\" a second time", "once"));
}

TEST_F(BadRawDrive, InvalidRotation) {
  Calibrate("R_rect_00", "1 0 0 0 1 0 0 0 2");
  EXPECT_THAT(Error(), Says("calib_cam_to_cam.txt:4: R_rect_00", "a matrix", "a rotation"));
}

TEST_F(BadRawDrive, CalibrationOfAnotherImageSize) {
  Calibrate("S_rect_00", "1242 375");
  EXPECT_THAT(Error(), Says("S_rect_00", "1242x375", "12x8"));
}

TEST_F(BadRawDrive, ImageMissingInTheMiddle) {
  fs::remove(folder_ / "image_01/data/0000000001.png");
  fs::remove(folder_ / "image_01/data/0000000002.png");
  EXPECT_THAT(Error(), Says("image_01/data", "2 files without 0000000001.png, 0000000002.png",
                            "0000000000.png to 0000000003.png"));
}

TEST_F(BadRawDrive, FirstImageMissing) {
  fs::remove(folder_ / "image_00/data/0000000000.png");
  EXPECT_THAT(Error(), Says("image_00/data", "3 files without 0000000000.png", "all from"));
}

TEST_F(BadRawDrive, ManyImagesMissing) {
  Write("image_00/data/0000000020.png", GreyPng());
  EXPECT_THAT(Error(), Says("image_00/data", "5 files without 0000000004.png", "all from"));
  EXPECT_THAT(Error(), HasSubstr("0000000013.png and 6 more"));
}

TEST_F(BadRawDrive, FewerRightImages) {
  fs::remove(folder_ / "image_01/data/0000000003.png");
  EXPECT_THAT(Error(), Says("image_01/data", "3 images", "4, as many as in"));
}

TEST_F(BadRawDrive, NoRightFolderOrNoImages) {
  fs::remove_all(folder_ / "image_01");
  EXPECT_THAT(Error(), Says("image_01/data", "no such folder", "a folder of"));
  fs::create_directories(folder_ / "image_01/data");
  EXPECT_THAT(Error(), Says("image_01/data", "no <number>.png", "at least one"));
}

TEST_F(BadRawDrive, DuplicateImageNumber) {
  Write("image_00/data/00002.png", GreyPng());
  EXPECT_THAT(Error(), Says("image_00/data", "number 2 a second time", "only"));
}

TEST_F(BadRawDrive, ImageOfAnotherSize) {
  Write("image_01/data/0000000002.png", GreyPng(kTestWidth_px, kTestHeight_px - 1));
  EXPECT_THAT(Error(), Says("image_01/data/0000000002.png", "12x7", "12x8 as in"));
}

TEST_F(BadRawDrive, ImagesThatAreNotPng) {
  Write("image_00/data/0000000002.png", "\xff\xd8\xff\xe0 JFIF and so on, more than a header");
  EXPECT_THAT(Error(), Says("image_00/data/0000000002.png", "a JPEG image", "a PNG image"));
  Write("image_00/data/0000000002.png", "");
  EXPECT_THAT(Error(), Says("0000000002.png", "an empty file", "a PNG image"));
  Write("image_00/data/0000000002.png", GreyPng().substr(0, 20));
  EXPECT_THAT(Error(), Says("0000000002.png", "a PNG header cut short", "a PNG image"));
  Write("image_00/data/0000000002.png", EncodePng(cv::Mat(8, 12, CV_16UC1, cv::Scalar(5))));
  EXPECT_THAT(Error(), Says("0000000002.png", "16 bits per channel", "8 bits"));
  Write("image_00/data/0000000002.jpg", "anything");
  EXPECT_THAT(Error(), Says("0000000002.jpg", "a JPEG image", "PNG images"));
}

TEST_F(BadRawDrive, InvalidTimestamps) {
  Write("image_00/timestamps.txt", DateTimeRow(0) + "2011-09-26 13:02\n");
  EXPECT_THAT(Error(), Says("image_00/timestamps.txt:2", "\"2011-09-26 13:02\"", "YYYY-MM-DD"));
  Write("image_00/timestamps.txt", DateTimeRow(0) + "\n" + DateTimeRow(1));
  EXPECT_THAT(Error(), Says("image_00/timestamps.txt:2", "\"\"", "YYYY-MM-DD"));
}

TEST_F(BadRawDrive, NonIncreasingTimestamps) {
  Write("image_00/timestamps.txt",
        DateTimeRow(0) + DateTimeRow(2) + DateTimeRow(1) + DateTimeRow(3));
  EXPECT_THAT(Error(), Says("image_00/timestamps.txt:3", "\"2011-09-26 13:02:10.110000000\"",
                            "after that of the line before"));
}

TEST_F(BadRawDrive, WrongNumberOfTimestamps) {
  Write("image_00/timestamps.txt", DateTimeRow(0) + DateTimeRow(1));
  EXPECT_THAT(Error(), Says("timestamps.txt", "2 times", "4, as many as images"));
  EXPECT_THAT(InterpolatedError(), Says("timestamps.txt", "2 times", "4, as many as images"));
}

TEST_F(BadRawDrive, InvalidOxtsPackets) {
  Write("oxts/data/0000000002.txt", "49 8 100\n");
  EXPECT_THAT(Error(), Says("oxts/data/0000000002.txt:1", "3 columns", "30 columns"));
  Write("oxts/data/0000000002.txt", OxtsPacketText(0.0, "nan"));
  EXPECT_THAT(Error(), Says("0000000002.txt:1", "\"nan\" in column 30", "a finite number"));
  Write("oxts/data/0000000002.txt", "");
  EXPECT_THAT(Error(), Says("0000000002.txt", "0 lines", "one OxTS packet"));
  std::string far_north = OxtsPacketText(0.0);
  Write("oxts/data/0000000002.txt", far_north.replace(0, 2, "91"));
  EXPECT_THAT(Error(), Says("0000000002.txt:1", "latitude 91", "within 85"));
}

TEST_F(BadRawDrive, WrongNumberOfOxtsPackets) {
  fs::remove(folder_ / "oxts/data/0000000003.txt");
  EXPECT_THAT(Error(), Says("oxts/data", "3 packets", "4, as many as images"));
  EXPECT_THAT(InterpolatedError(), Says("oxts/timestamps.txt", "4 times", "3, as many as packets"));
  fs::remove(folder_ / "oxts/data/0000000001.txt");
  EXPECT_THAT(Error(), Says("oxts/data", "2 files without 0000000001.txt", "all from"));
}

TEST_F(BadRawDrive, InterpolationWithoutPacketTimes) {
  fs::remove(folder_ / "oxts/timestamps.txt");
  EXPECT_THAT(InterpolatedError(), Says("oxts/timestamps.txt", "no such file", "can be read"));
  EXPECT_EQ(Error(), "");
}

TEST_F(BadRawDrive, UnrectifiedDrive) {
  const fs::path renamed = folder_.parent_path() / "2011_09_26_drive_0001_extract";
  fs::rename(folder_, renamed);
  EXPECT_THAT(OpenError({.folder = renamed}), Says("_extract", "an unrectified drive", "_sync"));
}

TEST_F(BadRawDrive, TruncatedCalibrationIsReadOrRefused) {
  const fs::path path = folder_.parent_path() / "calib_cam_to_cam.txt";
  std::ifstream in(path);
  const std::string whole((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  in.close();
  int refused = 0, sizes = 0;
  for (std::size_t size = 0; size < whole.size(); size += 11, ++sizes) {
    root_.Write("2011_09_26/calib_cam_to_cam.txt", whole.substr(0, size));
    refused += Error().empty() ? 0 : 1;
  }
  // The lines of cameras 2 and 3, which are not used, may be absent but not malformed.
  EXPECT_GT(refused, sizes / 2);
}

TEST_F(BadRawDrive, BinaryFileInsteadOfText) {
  Write("image_00/timestamps.txt", GreyPng(300, 300));
  EXPECT_THAT(Error(), Says("image_00/timestamps.txt:1", "\"?PNG", "YYYY-MM-DD"));
  root_.Write("2011_09_26/calib_velo_to_cam.txt", GreyPng(300, 300));
  Write("image_00/timestamps.txt",
        DateTimeRow(0) + DateTimeRow(1) + DateTimeRow(2) + DateTimeRow(3));
  EXPECT_THAT(Error(), Says("calib_velo_to_cam.txt", "", ""));
  EXPECT_LT(Error().size(), 400u);
}

TEST_F(BadRawDrive, InvalidOptions) {
  EXPECT_THAT(OpenError({.folder = folder_, .type = "tum"}),
              AllOf(Says("option --type", "\"tum\"", "kitti-raw"), HasSubstr("kitti-odometry"),
                    HasSubstr("kitti-tracking")));
  EXPECT_THAT(OpenError({.folder = folder_, .pair = "red"}),
              Says("option --pair", "\"red\"", "grey or colour"));
  EXPECT_THAT(OpenError({.folder = folder_, .pair = "colour"}),
              Says("image_02/data", "no such folder", "a folder of"));
  EXPECT_THAT(OpenError({.folder = folder_, .groundtruth = "gps"}),
              Says("option --groundtruth", "\"gps\"", "devkit or interpolated"));
  EXPECT_THAT(OpenError({.folder = folder_, .begin_frame = 4}),
              Says("--frames", "4:", "0 <= A < B <= 4"));
  EXPECT_THAT(OpenError({.folder = folder_, .begin_frame = 2, .end_frame = 5}),
              Says("--frames", "2:5", "0 <= A < B <= 4"));
  EXPECT_THAT(OpenError({.folder = folder_, .begin_frame = 2, .end_frame = 2}),
              Says("--frames", "2:2", "0 <= A < B <= 4"));
}

TEST_F(BadRawDrive, BoxesOutsideTheSequence) {
  const std::string row = " -1 Car -1 -1 -10 0 0 1 1 -1 -1 -1 -1 -1 -1 -10 0.5\n";
  const fs::path boxes = root_.Write("boxes.txt", "0" + row + "4" + row);
  EXPECT_THAT(OpenError({.folder = folder_, .detections_file = boxes}),
              Says("boxes.txt:2", "frame 4", "0 to 3"));
  EXPECT_THAT(OpenError({.folder = folder_, .end_frame = 2, .detections_file = boxes}),
              Says("boxes.txt:2", "frame 4", "0 to 3"));
  EXPECT_THAT(OpenError({.folder = folder_,
                         .detections_file = root_.Write("boxes.txt", "0" + row),
                         .detections_camera = 7}),
              Says("option --detections-camera", "camera 7", "camera 0, 1, 2 or 3"));
  EXPECT_THAT(OpenError({.folder = folder_,
                         .detections_file = root_.Write("labels.txt", kCarLabel),
                         .min_score = 0.0}),
              Says("labels.txt", "boxes without scores", "scores"));
  EXPECT_THAT(OpenError({.folder = folder_, .labels_file = root_.path() / "none.txt"}),
              Says("none.txt", "no such file", "can be read"));
}

class BadOdometry : public testing::Test {
 protected:
  std::string Error() const { return OpenError({.folder = folder_}); }

  test::TempFolder root_;
  fs::path folder_ = WriteOdometrySequence(root_);
};

TEST_F(BadOdometry, MissingFiles) {
  fs::remove(folder_ / "times.txt");
  EXPECT_THAT(Error(), Says("06/times.txt", "no such file", "can be read"));
  fs::remove(folder_ / "calib.txt");
  EXPECT_THAT(Error(), Says("06/calib.txt", "no such file", "can be read"));
}

TEST_F(BadOdometry, Times) {
  root_.Write("sequences/06/times.txt", "0.0\n0.1\n0.2\n0.3\n");
  EXPECT_THAT(Error(), Says("times", "4 times", "3, as many as images"));
  root_.Write("sequences/06/times.txt", "0.0\n0.1\n0.1\n");
  EXPECT_THAT(Error(), Says("times.txt:3", "\"0.1\"", "after that of the line before"));
  root_.Write("sequences/06/times.txt", "0.0\n0.1s\n0.2\n");
  EXPECT_THAT(Error(), Says("times.txt:2", "\"0.1s\" in column 1", "a time in seconds"));
  root_.Write("sequences/06/times.txt", "0.0\n0.1 0.2\n");
  EXPECT_THAT(Error(), Says("times.txt:2", "2 columns", "1 columns"));
}

TEST_F(BadOdometry, MorePosesThanImages) {
  const std::string row = "1 0 0 0 0 1 0 0 0 0 1 0\n";
  root_.Write("poses/06.txt", row + row + row + row);
  EXPECT_THAT(Error(), Says("poses/06.txt:4", "4 poses", "3, as many as images"));
}

TEST_F(BadOdometry, PosesCutShort) {
  root_.Write("poses/06.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0");
  EXPECT_THAT(Error(), Says("poses/06.txt:2", "7 columns in a last line without", "12 columns"));
}

TEST_F(BadOdometry, CameraMissingFromTheCalibration) {
  WriteImages(root_, "sequences/06/image_2", 3, 6);
  WriteImages(root_, "sequences/06/image_3", 3, 6);
  EXPECT_THAT(OpenError({.folder = folder_, .pair = "colour"}),
              Says("calib.txt", "no P2", "one projection per camera"));
}

TEST_F(BadOdometry, InterpolatedTruth) {
  EXPECT_THAT(OpenError({.folder = folder_, .groundtruth = "interpolated"}),
              Says("option --groundtruth", "\"interpolated\"", "one set of poses"));
}

class BadTracking : public testing::Test {
 protected:
  std::string Error() const { return OpenError({.folder = folder_}); }

  test::TempFolder root_;
  fs::path folder_ = WriteTrackingSequence(root_);
};

TEST_F(BadTracking, NoImages) {
  fs::remove_all(root_.path() / "training/image_03/0005");
  EXPECT_THAT(Error(), Says("training/image_03/0005", "no such folder", "a folder of"));
  fs::remove_all(root_.path() / "training/image_02/0005");
  EXPECT_THAT(Error(), Says("training/image_02/0005", "no such folder", "a folder of"));
}

TEST_F(BadTracking, Calibration) {
  std::string text = TrackingCalibration(true);
  root_.Write("training/calib/0005.txt", text.replace(text.find("R0_rect"), 7, "R9_rect"));
  EXPECT_THAT(Error(), Says("calib/0005.txt", "none of them", "R0_rect or R_rect"));
  fs::remove(root_.path() / "training/calib/0005.txt");
  EXPECT_THAT(Error(), Says("calib/0005.txt", "no such file", "can be read"));
}

TEST_F(BadTracking, OxtsLines) {
  root_.Write("training/oxts/0005.txt", OxtsPacketText(0) + OxtsPacketText(1));
  EXPECT_THAT(Error(), Says("oxts/0005.txt", "2 packets", "3, as many as images"));
  root_.Write("training/oxts/0005.txt", OxtsPacketText(0) + "1 2 3\n" + OxtsPacketText(1));
  EXPECT_THAT(Error(), Says("oxts/0005.txt:2", "3 columns", "30 columns"));
}

TEST_F(BadTracking, InterpolatedTruthAndGreyImages) {
  EXPECT_THAT(OpenError({.folder = folder_, .groundtruth = "interpolated"}),
              Says("option --groundtruth", "\"interpolated\"", "no timestamps"));
  EXPECT_THAT(OpenError({.folder = folder_, .pair = "grey"}),
              Says("option --pair", "\"grey\"", "colour"));
}

TEST_F(BadTracking, LabelsOfAnotherSequence) {
  root_.Write("training/label_02/0005.txt", "3 -1 Car 0 0 0 0 0 1 1 1 1 1 1 1 1 1\n");
  EXPECT_THAT(Error(), Says("label_02/0005.txt:1", "frame 3", "0 to 2"));
}

TEST_F(BadTracking, FolderOfSeveralSequences) {
  EXPECT_THAT(OpenError({.folder = root_.path() / "training"}),
              Says("training", "a folder of several KITTI tracking sequences", "training/0005"));
}

TEST(BadFolder, IsOfUnknownType) {
  const test::TempFolder root;
  EXPECT_THAT(OpenError({.folder = root.path()}),
              AllOf(Says(root.path().string(), "a folder of no known type", "kitti-raw"),
                    HasSubstr("kitti-odometry"), HasSubstr("kitti-tracking")));
  EXPECT_THAT(OpenError({.folder = root.path() / "absent"}),
              Says("absent", "no such folder", "a sequence"));
  EXPECT_THAT(ErrorMessage([&] { FindSequences(root.path() / "absent"); }),
              Says("absent", "no such folder", "to look for sequences in"));
}

}  // namespace
}  // namespace cvo
