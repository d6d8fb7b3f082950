// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "experiments/datasets/formats/data_rows.h"
#include "experiments/datasets/formats/object_boxes.h"
#include "experiments/datasets/sequence.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo {

namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Number, MustSpanTheWholeText) {
  EXPECT_EQ(ParseDouble("7.215377000000e+02"), 721.5377);
  EXPECT_EQ(ParseDouble("+1"), 1.0);
  EXPECT_EQ(ParseDouble("-.5"), -0.5);
  for (const char* text :
       {"", " 1", "1 ", "1.0x", "nan", "inf", "-Infinity", "1e999", "0x10", "+", "+-1", "1,5"}) {
    EXPECT_EQ(ParseDouble(text), std::nullopt) << text;
  }
  EXPECT_EQ(ParseInteger("-12"), -12);
  EXPECT_EQ(ParseInteger("1.0"), std::nullopt);
  EXPECT_EQ(ParseInteger("99999999999999999999"), std::nullopt);
}

std::optional<std::int64_t> Seconds_ns(const char* text) {
  return ParseTimeNs(text, 1'000'000'000);
}

TEST(Number, SecondsAreExactToTheNanosecond) {
  EXPECT_EQ(Seconds_ns("1.000000e-01"), 100'000'000);
  EXPECT_EQ(Seconds_ns("1.234567e+02"), 123'456'700'000);
  EXPECT_EQ(Seconds_ns("1305031102.175304001"), 1305031102175304001);
  EXPECT_EQ(Seconds_ns("12"), 12'000'000'000);
  EXPECT_EQ(Seconds_ns("1E2"), 100'000'000'000);
  EXPECT_EQ(Seconds_ns("-0.5"), -500'000'000);
  EXPECT_EQ(Seconds_ns(".000000001"), 1);
  EXPECT_EQ(Seconds_ns("0.0000000014"), 1);
  EXPECT_EQ(Seconds_ns("0.0000000015"), 2);
  EXPECT_EQ(Seconds_ns("0.9999999999"), 1'000'000'000);
  EXPECT_EQ(Seconds_ns("1e-30"), 0);
  for (const char* text : {"", ".", "-", "e5", "1e", "1e5x", "1.2.3", "nan", "1e400", "9e9"}) {
    EXPECT_EQ(Seconds_ns(text), std::nullopt) << text;
  }
}

TEST(Timestamp, CountsNanosecondsSince1970) {
  EXPECT_EQ(ParseDateTimeNs("1970-01-01 00:00:00.000000001"), 1);
  EXPECT_EQ(ParseDateTimeNs("2011-09-26 13:02:25.967790592"), 1317042145967790592);
  EXPECT_EQ(ParseDateTimeNs("1969-12-31 23:59:59.999999999"), -1);
}

TEST(Timestamp, AcceptsOnlyOneFormat) {
  for (const char* text : {"", "2011-09-26 13:02:25", "2011-09-26 13:02:25.96779059",
                           "2011-09-26 13:02:25.9677905920", "2011-09-26T13:02:25.967790592",
                           "2011-13-26 13:02:25.967790592", "2011-02-29 13:02:25.967790592",
                           "2011-09-26 24:00:00.000000000", "2011-09-26 13:60:25.967790592",
                           "2011-09-26 13:02:60.967790592", "2011-09-26 13:02:2x.967790592",
                           "9999-09-26 13:02:25.967790592", " 2011-09-26 13:02:25.96779059"}) {
    EXPECT_EQ(ParseDateTimeNs(text), std::nullopt) << text;
  }
}

TEST(Timestamp, FilesMayEndWithCarriageReturnsAndBlankLines) {
  const test::TempFolder folder;
  const auto path = folder.Write("t.txt",
                                 "1970-01-01 00:00:00.000000001\r\n"
                                 "1970-01-01 00:00:00.000000002 \n\n\n");
  EXPECT_THAT(ReadDateTimes(path), ElementsAre(1, 2));
}

TEST(FrameRange, Parses) {
  const auto parse = [](const char* text) {
    const FrameRange range = ParseFrameRange(text);
    return std::pair(range.begin, range.end);
  };
  EXPECT_EQ(parse("2:5"), std::pair(2, 5));
  EXPECT_EQ(parse("2:"), std::pair(2, -1));
  EXPECT_EQ(parse(":5"), std::pair(0, 5));
  EXPECT_EQ(parse(":"), std::pair(0, -1));
}

TEST(FrameRange, RefusesInvalidRanges) {
  for (const char* text : {"", "5", "a:b", "-1:5", "1:-1", "1:2:3", "1 :2", "3:99999999999"}) {
    EXPECT_THAT(ErrorMessage([&] { ParseFrameRange(text); }),
                AllOf(HasSubstr("--frames: found \"" + std::string(text) + "\""),
                      HasSubstr("expected A:B")))
        << text;
  }
  for (const char* text : {"5:5", "5:2", ":0"}) {
    EXPECT_THAT(ErrorMessage([&] { ParseFrameRange(text); }), HasSubstr("an empty range")) << text;
  }
}

class Boxes : public testing::Test {
 protected:
  std::string DetectionError(const std::string& text) {
    return ErrorMessage([&] { ReadDetections(folder_.Write("boxes.txt", text), 10); });
  }
  std::string LabelError(const std::string& text) {
    return ErrorMessage([&] { ReadLabels(folder_.Write("boxes.txt", text), 10); });
  }
  test::TempFolder folder_;
};

TEST_F(Boxes, ParsesALabelRow) {
  const auto boxes = ReadLabels(
      folder_.Write("boxes.txt",
                    "3 2 Car 1 2 1.91 292.4 176.9 331.8 197.5 1.41 1.48 3.63 -21.4 1.7 51.9 1.5\n"
                    "4 -1 DontCare -1 -1 -10 1 2 3 4 -1000 -1000 -1000 -10 -1 -1 -1"),
      10);
  ASSERT_EQ(boxes.size(), 2u);
  const ObjectBox& car = boxes[0];
  EXPECT_EQ(car.frame, 3);
  EXPECT_EQ(car.track, 2);
  EXPECT_EQ(car.type, "Car");
  EXPECT_EQ(car.truncation, 1.0);
  EXPECT_EQ(car.occlusion, 2);
  EXPECT_EQ(car.left_px, 292.4);
  EXPECT_EQ(car.top_px, 176.9);
  EXPECT_EQ(car.right_px, 331.8);
  EXPECT_EQ(car.bottom_px, 197.5);
  ASSERT_TRUE(car.box3d.has_value());
  EXPECT_EQ(car.box3d->height_m, 1.41);
  EXPECT_EQ(car.box3d->width_m, 1.48);
  EXPECT_EQ(car.box3d->length_m, 3.63);
  EXPECT_EQ(car.box3d->bottom_in_camera, Eigen::Vector3d(-21.4, 1.7, 51.9));
  EXPECT_EQ(car.box3d->heading_rad, 1.5);
  EXPECT_FALSE(car.score.has_value());
  EXPECT_EQ(boxes[1].track, -1);
  EXPECT_FALSE(boxes[1].box3d.has_value());
}

TEST_F(Boxes, ParsesDetectionRowsOfEitherLength) {
  const std::string head = "0 1 Car -1.000000 -1 -1 880.5 207.9 1238.6 375.8 -1 -1 -1 ";
  const auto score = [&](const std::string& tail) {
    return ReadDetections(folder_.Write("boxes.txt", head + tail), 10)[0].score;
  };
  EXPECT_EQ(score("-1000 -1000 -1000 -10 -2.15213\n"), -2.15213);
  EXPECT_EQ(score("-1 -1 -1 -1 -1 1 \n"), 1.0);
  EXPECT_EQ(score("-1 -1 -1 -1\n"), std::nullopt);
  const auto label = ReadLabels(
      folder_.Write("boxes.txt", "1.00 2000.000000 Car 0.00 -1.00 0 1 2 3 4 -1 -1 -1 0 0 0 0 0.9"),
      10);
  EXPECT_EQ(label[0].track, 2000) << "a tracker wrote integers as floats, and a score";
  EXPECT_EQ(label[0].occlusion, -1);
  EXPECT_THAT(LabelError("1.5 2 Car 0 0 0 1 2 3 4 -1 -1 -1 0 0 0 0"),
              HasSubstr("boxes.txt:1: found \"1.5\" in column 1, expected a whole number"));
  EXPECT_TRUE(ReadDetections(folder_.Write("boxes.txt", ""), 10).empty());
}

TEST_F(Boxes, RefusesBadRows) {
  const std::string good = "0 -1 Car -1 -1 -10 1 2 3 4 -1 -1 -1 -1 -1 -1 -10 0.5\n";
  EXPECT_THAT(DetectionError(good + "0 -1 Car -1 -1 -10 1 2 3 4 -1 -1 -1 -1 -1 -1 -10"),
              AllOf(HasSubstr("boxes.txt:2: found 17 columns"), HasSubstr("expected 18")));
  EXPECT_THAT(DetectionError("0 -1 Car\n"),
              AllOf(HasSubstr("boxes.txt:1: found 3 columns"), HasSubstr("expected 18")));
  EXPECT_THAT(DetectionError("0 -1 Car -1 -1 -10 3 2 1 4 -1 -1 -1 -1 -1 -1 -10 0.5\n"),
              AllOf(HasSubstr(":1: found a box of -2 x 2"), HasSubstr("left <= right")));
  EXPECT_THAT(DetectionError("0.5 -1 Car -1 -1 -10 1 2 3 4 -1 -1 -1 -1 -1 -1 -10 0.5\n"),
              AllOf(HasSubstr("\"0.5\" in column 1"), HasSubstr("a whole number")));
  EXPECT_THAT(DetectionError("-1 -1 Car -1 -1 -10 1 2 3 4 -1 -1 -1 -1 -1 -1 -10 0.5\n"),
              HasSubstr("found frame -1"));
  EXPECT_THAT(DetectionError("10 -1 Car -1 -1 -10 1 2 3 4 -1 -1 -1 -1 -1 -1 -10 0.5\n"),
              AllOf(HasSubstr("found frame 10"), HasSubstr("0 to 9")));
  EXPECT_THAT(DetectionError("0 -1 Car -1 -1 -10 1 2 3 4 1.5 0 4 1 1 9 0 0.5\n"),
              AllOf(HasSubstr("found a body of 0 m"), HasSubstr("above 0")));
}

TEST_F(Boxes, ShiftIsTheDisparityOfTheOffset) {
  ObjectBox box;
  box.left_px = 100.0;
  box.right_px = 150.0;
  box.top_px = 20.0;
  box.bottom_px = 40.0;
  // A point at x in the left camera is at x + 0.06 in the other, which is 700 * 0.06 / 10 px
  // further right.
  const ObjectBox shifted = ShiftBox(box, 0.06, 700.0, 10.0);
  EXPECT_NEAR(shifted.left_px, 95.8, 1e-12);
  EXPECT_NEAR(shifted.right_px, 145.8, 1e-12);
  EXPECT_EQ(shifted.top_px, 20.0);
  EXPECT_EQ(shifted.bottom_px, 40.0);
  EXPECT_NEAR(ShiftBox(shifted, -0.06, 700.0, 10.0).left_px, 100.0, 1e-12);
  EXPECT_THAT(ErrorMessage([&] { ShiftBox(box, 0.06, 700.0, 0.0); }), HasSubstr("depth"));
}

TEST(Oxts, ConvertsDegreesToMetresInEveryDirection) {
  constexpr double kRadius_m = 6378137.0, kDegree = std::numbers::pi / 180.0;
  const OxtsPacket start{49.0, 8.0, 100.0, 0.0, 0.0, 0.0};
  OxtsPacket east = start, north = start, up = start;
  east.longitude_deg += 10.0 / (kRadius_m * std::cos(49.0 * kDegree) * kDegree);
  north.latitude_deg += 10.0 / (kRadius_m * kDegree);
  up.altitude_m += 10.0;
  const auto poses = ImuPoses({start, east, north, up});
  EXPECT_NEAR((poses[0].translation() - Eigen::Vector3d(0, 0, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((poses[1].translation() - Eigen::Vector3d(10, 0, 0)).norm(), 0.0, 1e-6);
  EXPECT_NEAR((poses[2].translation() - Eigen::Vector3d(0, 10, 0)).norm(), 0.0, 1e-4);
  EXPECT_NEAR((poses[3].translation() - Eigen::Vector3d(0, 0, 10)).norm(), 0.0, 1e-9);
}

TEST(Oxts, VelocitiesAreIntegratedInTheAxesOfTheFirstPacket) {
  OxtsPacket start{49.0, 8.0, 100.0, 0.0, 0.0, 0.5 * std::numbers::pi};  // towards the north
  start.velocity_m_s = {0.0, 10.0, 0.0};
  OxtsPacket faster = start;
  faster.velocity_m_s = {1.0, 12.0, 0.0};
  const auto poses = ImuPosesByVelocity({start, start, faster}, {0, 100'000'000, 300'000'000});
  EXPECT_NEAR((poses[1].translation() - Eigen::Vector3d(1.0, 0, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((poses[2].translation() - Eigen::Vector3d(3.2, -0.1, 0)).norm(), 0.0, 1e-12);
}

TEST(Oxts, AnglesAreYawThenPitchThenRoll) {
  const OxtsPacket start{49.0, 8.0, 100.0, 0.0, 0.0, 0.0};
  OxtsPacket turned = start;
  turned.roll_rad = 0.1;
  turned.pitch_rad = 0.2;
  turned.yaw_rad = 0.3;
  const Eigen::Matrix3d R = ImuPoses({start, turned})[1].RotationMatrix();
  EXPECT_NEAR(std::atan2(R(1, 0), R(0, 0)), 0.3, 1e-12);
  EXPECT_NEAR(-std::asin(R(2, 0)), 0.2, 1e-12);
  EXPECT_NEAR(std::atan2(R(2, 1), R(2, 2)), 0.1, 1e-12);
}

}  // namespace

}  // namespace cvo
