// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Reading the ground truth of rendered scenes: what is accepted and what is refused.

#include "experiments/datasets/formats/scene_truth.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "core/base/error.h"
#include "experiments/datasets/sequence.h"
#include "tests/experiments/datasets/folders.h"
#include "tests/support/error_message.h"
#include "tests/support/image_file.h"

namespace cvo {

namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

const cv::Size kSize(kTestWidth_px, kTestHeight_px);

// A row of objects.csv. `rest` holds position, rotation, velocity, angular velocity, size, pixel
// counts, fractions and both boxes.
std::string Row(int frame, int id, const std::string& rest) {
  return StrCat(frame, ",", id, ",ball_", id, ",Ball,", rest, "\n");
}
constexpr const char* kInView =
    "1,2,3,0,0,0.6,0.8,0.5,0,0,0,0,1.25,0.7,0.7,0.7,12,24,0.5,0.25,1,2,4,4,1,2,5,6";
constexpr const char* kOutOfView = "1,2,3,0,0,0,1,0,0,0,0,0,0,0.7,0.7,0.7,0,0,0,1,,,,,,,,";

class SceneTruth : public testing::Test {
 protected:
  fs::path Objects(const std::string& rows) const {
    return folder_.Write("objects.csv", CsvHeader<SceneBody>() + "\n" + rows);
  }
  std::string ObjectsError(const std::string& rows, int frames = 1) const {
    const fs::path path = Objects(rows);
    return ErrorMessage([&] { ReadSceneBodies(path, frames); });
  }
  static std::string InView(const std::string& from, const std::string& to) {
    std::string row = Row(0, 1, kInView);
    return row.replace(row.find(from), from.size(), to);
  }

  test::TempFolder folder_;
};

TEST_F(SceneTruth, ReadsEveryFieldOfABody) {
  const auto bodies = ReadSceneBodies(Objects(Row(0, 1, kInView) + Row(0, 2, kOutOfView) +
                                              Row(1, 1, kOutOfView) + Row(1, 2, kInView)),
                                      2);
  ASSERT_EQ(bodies.size(), 2U);
  ASSERT_EQ(bodies[0].size(), 2U);
  const SceneBody& body = bodies[0][0];
  EXPECT_EQ(body.id, 1);
  EXPECT_EQ(body.name, "ball_1");
  EXPECT_EQ(body.category, "Ball");
  EXPECT_EQ(body.world_from_object.translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_NEAR(body.world_from_object.rotation().z(), 0.6, 1e-15);
  EXPECT_NEAR(body.world_from_object.rotation().w(), 0.8, 1e-15);
  EXPECT_EQ(body.velocity_in_world, Eigen::Vector3d(0.5, 0, 0));
  EXPECT_EQ(body.angular_velocity_in_world, Eigen::Vector3d(0, 0, 1.25));
  EXPECT_EQ(body.size_m, Eigen::Vector3d(0.7, 0.7, 0.7));
  EXPECT_EQ(body.visible_px, 12);
  EXPECT_EQ(body.visible_fraction, 0.5);
  ASSERT_TRUE(body.visible_box);
  EXPECT_EQ(body.visible_box->right_px, 4);
  EXPECT_FALSE(bodies[0][1].visible_box);
}

TEST_F(SceneTruth, AcceptsASceneWithoutBodies) {
  const auto bodies = ReadSceneBodies(Objects(""), 3);
  ASSERT_EQ(bodies.size(), 3U);
  EXPECT_TRUE(bodies[2].empty());
}

TEST_F(SceneTruth, RefusesBadCellsNamingLineAndColumn) {
  EXPECT_THAT(ObjectsError(InView("1,2,3,", "1,two,3,")),
              HasSubstr("objects.csv:2: found \"two\" in column y, expected a finite number"));
  EXPECT_THAT(ObjectsError(InView("12,24", "12.5,24")), HasSubstr("column visible_px"));
  EXPECT_THAT(ObjectsError(InView("1,2,3,", "1,nan,3,")), HasSubstr("column y"));
  EXPECT_THAT(ObjectsError(InView(",6\n", "\n")), HasSubstr("31 cells"));
  EXPECT_THAT(ObjectsError(InView("Ball", "")), HasSubstr("an empty name or category"));
}

TEST_F(SceneTruth, RefusesImpossibleValues) {
  EXPECT_THAT(ObjectsError(InView("0.6,0.8", "0.6,0.6")), HasSubstr("quaternion"));
  EXPECT_THAT(ObjectsError(InView("0.7,0.7,0.7", "0.7,0,0.7")), HasSubstr("positive sizes"));
  EXPECT_THAT(ObjectsError(InView("1,2,4,4", "5,2,4,4")), HasSubstr("a box whose left > right"));
  EXPECT_THAT(ObjectsError(InView("1,2,4,4", "1,2,4,")), HasSubstr("column visible_bottom"));
}

TEST_F(SceneTruth, RefusesMissingOrMisplacedRows) {
  EXPECT_THAT(ObjectsError(Row(0, 1, kInView) + Row(0, 2, kInView) + Row(1, 1, kInView), 2),
              HasSubstr("3 rows"));
  EXPECT_THAT(ObjectsError(Row(0, 1, kInView) + Row(0, 2, kInView), 2),
              HasSubstr("objects.csv:3: found frame 0, body 2, expected frame 1, body 1"));
  EXPECT_THAT(ObjectsError(Row(0, 2, kInView)), HasSubstr("expected frame 0, body 1"));
  std::string other = Row(1, 1, kInView);
  other.replace(other.find("Ball"), 4, "Cube");
  EXPECT_THAT(ObjectsError(Row(0, 1, kInView) + other, 2), HasSubstr("body 1 as in frame 0"));
}

TEST_F(SceneTruth, DepthAndInstancesReadBackExactly) {
  cv::Mat depth(kSize, CV_32FC1);
  cv::Mat instances(kSize, CV_16UC1);
  for (int i = 0; i < kSize.area(); ++i) {
    depth.at<float>(i / kSize.width, i % kSize.width) = 0.1F * static_cast<float>(i);
    instances.at<std::uint16_t>(i / kSize.width, i % kSize.width) =
        static_cast<std::uint16_t>(700 * i);
  }
  const fs::path depth_path = folder_.path() / "0.tiff", instance_path = folder_.path() / "0.png";
  test::WriteImageFile(depth_path, depth);
  test::WriteImageFile(instance_path, instances);
  EXPECT_EQ(cv::norm(ReadDepth(depth_path, kSize), depth, cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(ReadInstances(instance_path, kSize), instances, cv::NORM_INF), 0.0);
}

TEST_F(SceneTruth, RefusesImagesOfTheWrongTypeOrSize) {
  const fs::path grey = folder_.Write("grey.png", GreyPng());
  EXPECT_THAT(
      ErrorMessage([&] { ReadInstances(grey, kSize); }),
      AllOf(HasSubstr("grey.png"), HasSubstr("1 x 8 bits, expected 12x8 pixels of 1 x 16")));
  const fs::path large = folder_.path() / "large.png";
  test::WriteImageFile(large, cv::Mat::zeros(9, 12, CV_16UC1));
  EXPECT_THAT(ErrorMessage([&] { ReadInstances(large, kSize); }), HasSubstr("found 12x9 pixels"));
  const fs::path broken = folder_.Write("broken.tiff", "II*");
  EXPECT_THAT(ErrorMessage([&] { ReadDepth(broken, kSize); }), HasSubstr("broken.tiff"));
}

TEST_F(SceneTruth, RefusesInvalidDepth) {
  cv::Mat depth = cv::Mat::zeros(kSize, CV_32FC1);
  const fs::path path = folder_.path() / "0.tiff";
  for (const float bad :
       {-1.0F, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    depth.at<float>(3, 5) = bad;
    test::WriteImageFile(path, depth);
    EXPECT_THAT(ErrorMessage([&] { ReadDepth(path, kSize); }), HasSubstr("pixel 5, 3"));
  }
}

// A KITTI odometry folder with the files of a rendered scene beside its images.
class SceneSequence : public testing::Test {
 protected:
  SceneSequence() {
    std::string times, poses;
    for (int i = 0; i < 3; ++i) {
      times += StrCat(i, ".000000e-01\n");
      poses += StrCat("1 0 0 ", 0.1 * i, " 0 1 0 0 0 0 1 ", i, "\n");
    }
    folder_.Write("tiny/times.txt", times);
    folder_.Write("tiny/poses.txt", poses);
    folder_.Write("tiny/calib.txt",
                  StrCat("P0: ", ProjectionRow(0.0), "\nP1: ", ProjectionRow(-0.5), "\n"));
    folder_.Write("tiny/labels.txt", "1 2 Ball 0 0 0 1 1 4 4 0.7 0.7 0.7 0 0.3 2 0.5\n");
    folder_.Write("tiny/detections/good.txt",
                  "2 -1 Ball -1 -1 -10 1 1 4 4 -1 -1 -1 -1000 -1000 -1000 -10 0.9\n");
    WriteImages(folder_, "tiny/image_0", 3, 6);
    WriteImages(folder_, "tiny/image_1", 3, 6);
  }
  fs::path tiny() const { return folder_.path() / "tiny"; }

  test::TempFolder folder_;
};

TEST_F(SceneSequence, HasItsLabelsItsNameAndNoRectificationError) {
  const Sequence sequence = OpenSequence({.folder = tiny()});
  EXPECT_EQ(sequence.name, "tiny");
  EXPECT_EQ(sequence.type, "kitti-odometry");
  EXPECT_EQ(sequence.camera.right_shift_px, 0.0);
  ASSERT_EQ(sequence.labels.size(), 1U);
  EXPECT_EQ(sequence.labels[0].track, 2);
  EXPECT_EQ(sequence.labels[0].left_px, 1.0);
  EXPECT_THAT(sequence.other_files, testing::Contains(tiny() / "labels.txt"));
  EXPECT_TRUE(sequence.detections.empty());
  EXPECT_THAT(sequence.missing, testing::IsEmpty());
}

TEST_F(SceneSequence, OffersItsDetectionsByLevel) {
  const Sequence sequence = OpenSequence({.folder = tiny(), .detections_file = "good"});
  ASSERT_EQ(sequence.detections.size(), 1U);
  EXPECT_EQ(sequence.detections[0].score, 0.9);
  EXPECT_THAT(sequence.other_files, testing::Contains(tiny() / "detections/good.txt"));
  EXPECT_THAT(ErrorMessage([&] { OpenSequence({.folder = tiny(), .detections_file = "best"}); }),
              HasSubstr("best: found no such file"));
}

}  // namespace

}  // namespace cvo
