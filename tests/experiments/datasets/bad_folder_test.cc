// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

// Malformed folders. Every message names the file, and the line or field, what was found and what
// was expected.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

#include "core/files/text_file.h"
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

// Whether the message is one line that has the parts of "<where> | <found> | <expected>".
MATCHER_P(Says, parts, "") {
  const std::string message = arg, all = parts;
  const std::size_t first = all.find(" | "), second = all.find(" | ", first + 1);
  const std::string where = all.substr(0, first);
  const std::string found = all.substr(first + 3, second - first - 3);
  const std::string expected = all.substr(second + 3);
  const std::size_t a = message.find(where);
  const std::size_t b = message.find(": found " + found, a);
  const std::size_t c = message.find(", expected ", b);
  return a != std::string::npos && b != std::string::npos && c != std::string::npos &&
         message.find(expected, c) != std::string::npos && message.find('\n') == std::string::npos;
}

// Another text of a file of the sequence's folder; without a text, the file or folder is missing.
struct Change {
  fs::path file;
  std::optional<std::string> text = {};
};

// What is said of a folder with these changes.
struct Fault {
  std::vector<Change> changes;
  std::string says;  // "<where> | <found> | <expected>"
};

template <typename Write>
void ExpectFaults(const Write& write, const std::vector<Fault>& faults) {
  for (const Fault& fault : faults) {
    const test::TempFolder root;
    const fs::path folder = write(root);
    for (const Change& change : fault.changes) {
      const fs::path path = (folder / change.file).lexically_normal();
      if (change.text) root.Write(path.lexically_relative(root.path()), *change.text);
      if (!change.text) fs::remove_all(path);
    }
    EXPECT_THAT(OpenError({.folder = folder}), Says(fault.says));
  }
}

fs::path WriteDrive(const test::TempFolder& root) { return WriteRawDrive(root, 4); }

constexpr const char* kCameras = "../calib_cam_to_cam.txt";
constexpr const char* kTimes = "image_00/timestamps.txt";

std::string CalibrationText() {
  const test::TempFolder root;
  return test::ReadFile(WriteDrive(root) / kCameras);
}

// The calibration of the cameras with other values in one line.
Change Calibration(const std::string& key, const std::string& values) {
  std::string text = CalibrationText();
  const std::size_t begin = text.find(key + ":");
  text.replace(begin, text.find('\n', begin) - begin, key + ": " + values);
  return {kCameras, text};
}

TEST(BadRawDrive, Calibration) {
  const std::string cameras = "calib_cam_to_cam.txt";
  const std::string pair = "P_rect_00 and P_rect_01";
  ExpectFaults(
      WriteDrive,
      {{{{kCameras}}, cameras + " | no such file | can be read"},
       {{{kCameras, "P_rect_00: " + ProjectionRow(0.0) + "\n"}},
        cameras + " | no P_rect_01 | one projection per camera"},
       {{Calibration("P_rect_01", "10 0 6 -5 0 10 4")},
        cameras + ":8 | 8 columns | P_rect_01 and 12 numbers"},
       {{Calibration("P_rect_00", "10 0 6 0 0 1O 4 0 0 0 1 0")},
        cameras + ":5 | \"1O\" in column 7 | a finite number"},
       {{Calibration("P_rect_00", "10 0 6 0 0 nan 4 0 0 0 1 0")},
        cameras + ":5 | \"nan\" in column 7 | a finite number"},
       {{Calibration("P_rect_00", "10 1 6 0 0 10 4 0 0 0 1 0")},
        "P_rect_00 | a matrix of another form | a rectified camera"},
       {{Calibration("P_rect_00", "-10 0 6 0 0 10 4 0 0 0 1 0")},
        "P_rect_00 | focal lengths -10 | positive"},
       {{Calibration("P_rect_00", "11 0 6 0 0 10 4 0 0 0 1 0")},
        pair + " | different focal lengths | equal ones"},
       {{Calibration("P_rect_00", "10 0 6.1 0 0 10 4 0 0 0 1 0")},
        pair + " | different focal lengths | equal ones"},
       {{Calibration("P_rect_01", ProjectionRow(0.0))},
        pair + " | a baseline of 0 m | a positive one"},
       {{Calibration("P_rect_01", ProjectionRow(0.5))},
        pair + " | a baseline of -0.5 m | a positive one"},
       {{Calibration("P_rect_01", ProjectionRow(-0.5) + "\nP_rect_01: " + ProjectionRow(-0.4))},
        cameras + ":9 | \"P_rect_01\" a second time | once"},
       {{Calibration("R_rect_00", "1 0 0 0 1 0 0 0 2")},
        cameras + ":4: R_rect_00 | a matrix | a rotation"},
       {{Calibration("S_rect_00", "1242 375")}, "S_rect_00 | 1242x375 | 12x8"}});
}

TEST(BadRawDrive, Images) {
  const std::string third = "image_00/data/0000000002.png";
  ExpectFaults(
      WriteDrive,
      {{{{"image_01/data/0000000001.png"}, {"image_01/data/0000000002.png"}},
        "image_01/data | 2 files without number 1 | all from 0 to 3"},
       {{{"image_00/data/0000000000.png"}},
        "image_01/data | 4 images from number 0 | 3, as many as in"},
       {{{"image_00/data/0000000020.png", GreyPng()}},
        "image_00/data | 5 files without number 4 | all from 0 to 20"},
       {{{"image_01/data/0000000003.png"}}, "image_01/data | 3 images | 4, as many as in"},
       {{{"image_01"}}, "image_01/data | no such folder | a folder of"},
       {{{"image_01/data"}, {"image_01/data/notes", ""}},
        "image_01/data | no <number>.png | at least one"},
       {{{"image_00/data/00002.png", GreyPng()}}, "image_00/data | number 2 a second time | only"},
       {{{"image_01/data/0000000002.png", GreyPng(kTestWidth_px, kTestHeight_px - 1)}},
        "image_01/data/0000000002.png | 12x7 | 12x8 as in"},
       {{{third, "\xff\xd8\xff\xe0 JFIF and so on, more than a header"}},
        third + " | a JPEG image | a PNG image"},
       {{{third, ""}}, third + " | an empty file | a PNG image"},
       {{{third, GreyPng().substr(0, 20)}}, third + " | a PNG header cut short | a PNG image"},
       {{{"image_00/data/0000000002.jpg", "anything"}},
        "0000000002.jpg | a JPEG image | PNG images"}});
}

TEST(BadRawDrive, TimesAndPackets) {
  std::string far_north = OxtsPacketText(0.0);
  far_north.replace(0, 2, "91");
  std::string degrees = OxtsPacketText(0.0);
  degrees.replace(degrees.find(" 100 0 0 0"), 10, " 100 0 0 45");
  const std::string packet = "oxts/data/0000000002.txt";
  const std::string two = DateTimeRow(0) + DateTimeRow(1);
  ExpectFaults(
      WriteDrive,
      {{{{kTimes, DateTimeRow(0) + "2011-09-26 13:02\n"}},
        "image_00/timestamps.txt:2 | \"2011-09-26 13:02\" | YYYY-MM-DD"},
       {{{kTimes, DateTimeRow(0) + "\n" + DateTimeRow(1)}},
        "image_00/timestamps.txt:2 | \"\" | YYYY-MM-DD"},
       {{{kTimes, GreyPng(300, 300)}}, "image_00/timestamps.txt:1 | \"?PNG | YYYY-MM-DD"},
       {{{kTimes, DateTimeRow(0) + DateTimeRow(2) + DateTimeRow(1) + DateTimeRow(3)}},
        "image_00/timestamps.txt:3 | \"2011-09-26 13:02:10.110000000\" | after that of the line "
        "before"},
       {{{kTimes, two}}, "timestamps.txt | 2 times | 4, as many as images"},
       {{{packet, "49 8 100\n"}}, packet + ":1 | 3 columns | 30 columns"},
       {{{packet, OxtsPacketText(0.0, "nan")}},
        packet + ":1 | \"nan\" in column 30 | a finite number"},
       {{{packet, ""}}, packet + " | 0 lines | one OxTS packet"},
       {{{packet, far_north}}, packet + ":1 | latitude 91 | within 85"},
       {{{packet, degrees}}, packet + ":1 | an angle of 45 | yaw in radians"}});
}

TEST(BadRawDrive, TruncatedCalibrationIsReadOrRefused) {
  const test::TempFolder root;
  const fs::path folder = WriteDrive(root);
  const std::string whole = CalibrationText();
  int refused = 0, sizes = 0;
  for (std::size_t size = 0; size < whole.size(); size += 11, ++sizes) {
    root.Write("2011_09_26/calib_cam_to_cam.txt", whole.substr(0, size));
    refused += OpenError({.folder = folder}).empty() ? 0 : 1;
  }
  // The lines of cameras 2 and 3, which are not used, may be absent but not malformed.
  EXPECT_GT(refused, sizes / 2);
}

TEST(BadRawDrive, InvalidOptions) {
  const test::TempFolder root;
  const fs::path folder = WriteDrive(root);
  EXPECT_THAT(OpenError({.folder = folder, .type = "tum"}),
              AllOf(Says("option --type | \"tum\" | kitti-raw"), HasSubstr("kitti-odometry"),
                    HasSubstr("kitti-tracking")));
  EXPECT_THAT(OpenError({.folder = folder, .pair = "red"}),
              Says("option --pair | \"red\" | grey or colour"));
  EXPECT_THAT(OpenError({.folder = folder, .pair = "colour"}),
              Says("image_02/data | no such folder | a folder of"));
  EXPECT_THAT(OpenError({.folder = folder, .begin_frame = 4}),
              Says("--frames | 4: | 0 <= A < B <= 4"));
  EXPECT_THAT(OpenError({.folder = folder, .begin_frame = 2, .end_frame = 5}),
              Says("--frames | 2:5 | 0 <= A < B <= 4"));
  const fs::path renamed = folder.parent_path() / "2011_09_26_drive_0001_extract";
  fs::rename(folder, renamed);
  EXPECT_THAT(OpenError({.folder = renamed}), Says("_extract | an unrectified drive | _sync"));
}

TEST(BadRawDrive, Boxes) {
  const test::TempFolder root;
  const fs::path folder = WriteDrive(root);
  const std::string row = " -1 Car -1 -1 -10 0 0 1 1 -1 -1 -1 -1 -1 -1 -10 0.5\n";
  const fs::path boxes = root.Write("boxes.txt", "0" + row + "4" + row);
  EXPECT_THAT(OpenError({.folder = folder, .end_frame = 2, .detections_file = boxes}),
              Says("boxes.txt:2 | frame 4 | 0 to 3"));
  EXPECT_THAT(OpenError({.folder = folder,
                         .detections_file = root.Write("boxes.txt", "0" + row),
                         .detections_camera = 7}),
              Says("option --detections-camera | camera 7 | camera 0, 1, 2 or 3"));
  EXPECT_THAT(OpenError({.folder = folder,
                         .detections_file = root.Write("labels.txt", kCarLabel),
                         .min_score = 0.0}),
              Says("labels.txt | boxes without scores | scores"));
  EXPECT_THAT(OpenError({.folder = folder, .labels_file = root.path() / "none.txt"}),
              Says("none.txt | no such file | can be read"));
}

TEST(BadOdometry, Files) {
  const std::string row = "1 0 0 0 0 1 0 0 0 0 1 0\n";
  ExpectFaults(
      [](const test::TempFolder& root) { return WriteOdometrySequence(root); },
      {{{{"times.txt"}}, "06/times.txt | no such file | can be read"},
       {{{"calib.txt"}}, "06/calib.txt | no such file | can be read"},
       {{{"times.txt", "0.0\n0.1\n"}}, "times | 2 times | 3, as many as images"},
       {{{"times.txt", "0.0\n0.1\n0.1\n"}}, "times.txt:3 | time 0.1 | one after 0.1"},
       {{{"times.txt", "0.0\n0.1s\n0.2\n"}}, "times.txt:2 | \"0.1s\" | a time"},
       {{{"times.txt", "0.0\n0.1 0.2\n"}}, "times.txt:2 | 2 columns | 1, as in the first row"},
       {{{"../../poses/06.txt", "\n"}}, "poses/06.txt | 0 poses | 3, as many as images"},
       {{{"../../poses/06.txt", row + "1 0 0 0 0 1 0"}},
        "poses/06.txt:2 | 7 columns in a last line without | 12 columns"}});
}

TEST(BadOdometry, CameraMissingFromTheCalibration) {
  const test::TempFolder root;
  const fs::path folder = WriteOdometrySequence(root);
  WriteImages(root, "sequences/06/image_2", 3, 6);
  WriteImages(root, "sequences/06/image_3", 3, 6);
  EXPECT_THAT(OpenError({.folder = folder, .pair = "colour"}),
              Says("calib.txt | no P2 | one projection per camera"));
}

TEST(BadTracking, Files) {
  std::string calibration = TrackingCalibration(true);
  calibration.replace(calibration.find("R0_rect"), 7, "R9_rect");
  ExpectFaults(
      [](const test::TempFolder& root) { return WriteTrackingSequence(root); },
      {{{{"../image_03/0005"}}, "training/image_03/0005 | no such folder | a folder of"},
       {{{"../image_02/0005"}}, "training/image_02/0005 | no such folder | a folder of"},
       {{{"../calib/0005.txt", calibration}}, "calib/0005.txt | none of them | R0_rect or R_rect"},
       {{{"../calib/0005.txt"}}, "calib/0005.txt | no such file | can be read"},
       {{{"../oxts/0005.txt", OxtsPacketText(0) + "1 2 3\n" + OxtsPacketText(1)}},
        "oxts/0005.txt:2 | 3 columns | 30 columns"}});
}

TEST(BadFolder, IsOfUnknownTypeOrOfSeveralSequences) {
  const test::TempFolder root;
  EXPECT_THAT(OpenError({.folder = root.path()}),
              AllOf(Says(root.path().string() + " | a folder of no known type | kitti-raw"),
                    HasSubstr("kitti-odometry"), HasSubstr("kitti-tracking")));
  EXPECT_THAT(OpenError({.folder = root.path() / "absent"}),
              Says("absent | no such folder | a sequence"));
  EXPECT_THAT(ErrorMessage([&] { FindSequences(root.path() / "absent"); }),
              Says("absent | no such folder | to look for sequences in"));
  const fs::path folder = WriteTrackingSequence(root);
  EXPECT_THAT(OpenError({.folder = root.path() / "training"}),
              Says("training | a folder that contains 1 sequence | one of them"));
  EXPECT_THAT(OpenError({.folder = folder, .pair = "grey"}),
              Says("option --pair | \"grey\" | colour"));
}

}  // namespace
}  // namespace cvo
