// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "variants/stereo_odometry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "core/files/images/image_file.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/run_job.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo {
namespace {

using testing::HasSubstr;

constexpr int kFrames = 6;

// The tiny sequence with two boxes per frame, the first of which lies outside the image.
class StereoOdometryTest : public ::testing::Test {
 protected:
  StereoOdometryTest() {
    test::WriteTinySequence(folder_.path(), kFrames);
    sequence_ = OpenSequence({.folder = folder_.path()});
    for (int i = 0; i < kFrames; ++i) {
      boxes_.push_back(
          {{{-90.0, 20.0, -10.0, 60.0}, "Car", 0.9}, {{60.0, 20.0, 160.0, 140.0}, "Car", 0.8}});
      for (const Detection& box : boxes_.back()) AddToSequence(i, box);
    }
  }

  void AddToSequence(int frame, const Detection& detection) {
    ObjectBox box;
    box.frame = frame;
    box.type = detection.category;
    box.left_px = detection.box.left_px;
    box.top_px = detection.box.top_px;
    box.right_px = detection.box.right_px;
    box.bottom_px = detection.box.bottom_px;
    box.score = detection.score;
    sequence_.detections.push_back(box);
  }

  FrameReport Process(StereoOdometry& odometry, int frame) const {
    const StereoPaths& paths = sequence_.images[frame];
    return odometry.Process(ReadImageFile(paths.left, cv::IMREAD_GRAYSCALE),
                            ReadImageFile(paths.right, cv::IMREAD_GRAYSCALE),
                            sequence_.timestamps_ns[frame], boxes_[frame]);
  }

  test::TempFolder folder_;
  Sequence sequence_;
  std::vector<std::vector<Detection>> boxes_;
};

std::vector<double> Numbers(const RigidTransform& pose) { return {pose.data(), pose.data() + 7}; }

void ExpectSame(const FrameReport& a, const FrameReport& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.inliers, b.inliers);
  EXPECT_EQ(Numbers(a.world_from_camera), Numbers(b.world_from_camera));
  ASSERT_EQ(a.clusters.size(), b.clusters.size());
  for (std::size_t i = 0; i < a.clusters.size(); ++i) {
    EXPECT_EQ(a.clusters[i].id, b.clusters[i].id);
    EXPECT_EQ(Numbers(a.clusters[i].world_from_object), Numbers(b.clusters[i].world_from_object));
    EXPECT_EQ(a.clusters[i].velocity_m_s, b.clusters[i].velocity_m_s);
  }
}

TEST_F(StereoOdometryTest, AgreesWithTheRunnerToTheLastBit) {
  for (const char* variant : {"full", "static"}) {
    const auto run = RunSequence(
        {.sequence = sequence_, .variant = FindVariant(variant), .options = {}, .seed = 3});
    ASSERT_TRUE(run.has_value());
    StereoOdometry odometry(
        {.camera = sequence_.camera, .variant = variant, .seed = 3, .threads = 2});
    for (int i = 0; i < kFrames; ++i) ExpectSame(Process(odometry, i), run->frames[i].report);
    const std::vector<RigidTransform> trajectory = odometry.Trajectory();
    ASSERT_EQ(trajectory.size(), run->frames.size());
    for (int i = 0; i < kFrames; ++i) {
      EXPECT_EQ(Numbers(trajectory[i]), Numbers(run->frames[i].refined_world_from_camera));
    }
    EXPECT_EQ(odometry.ClusterTrajectories().size(), run->clusters.size());
  }
}

TEST_F(StereoOdometryTest, ReportsTheIndexOfTheCallersBox) {
  StereoOdometry odometry({.camera = sequence_.camera});
  FrameReport report;
  for (int i = 0; i < kFrames; ++i) report = Process(odometry, i);
  ASSERT_EQ(report.clusters.size(), 1u);
  EXPECT_EQ(report.clusters[0].detection, 1);
  EXPECT_EQ(report.clusters[0].category, "Car");
}

TEST_F(StereoOdometryTest, LandmarksReferToTheirFeatures) {
  StereoOdometry odometry({.camera = sequence_.camera});
  Process(odometry, 0);
  const FrameReport report = Process(odometry, 1);
  ASSERT_FALSE(report.landmarks.empty());
  for (const LandmarkReport& landmark : report.landmarks) {
    const auto projected =
        sequence_.camera.Project(report.world_from_camera.Inverse() * landmark.p_in_world);
    ASSERT_TRUE(projected.has_value());
    const Eigen::Vector3d& seen = odometry.features().at(landmark.feature).z_px;
    EXPECT_LT((*projected - seen).norm(), 5.0);
  }
}

TEST_F(StereoOdometryTest, PredictsAFrameWithoutImages) {
  StereoOdometry odometry({.camera = sequence_.camera});
  Process(odometry, 0);
  EXPECT_EQ(odometry.Skip(sequence_.timestamps_ns[1]).status, FrameStatus::kSkipped);
  EXPECT_TRUE(odometry.features().empty());
  EXPECT_EQ(Process(odometry, 2).status, FrameStatus::kTracked);
  EXPECT_EQ(odometry.Trajectory().size(), 3u);
}

TEST_F(StereoOdometryTest, ErrorsNameTheBadInput) {
  EXPECT_THAT(
      ErrorMessage([&] { StereoOdometry({.camera = sequence_.camera, .variant = "fast"}); }),
      HasSubstr("variant: found \"fast\", expected one of: full, "));
  EXPECT_THAT(ErrorMessage([] { StereoOdometry({}); }), HasSubstr("fx"));
  StereoOdometry odometry({.camera = sequence_.camera});
  boxes_[0][1].box.right_px = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(ErrorMessage([&] { Process(odometry, 0); }),
              HasSubstr("box 1: found (60, 20) to (nan"));
  const cv::Mat image(sequence_.camera.height_px, 10, CV_8UC1);
  EXPECT_THAT(ErrorMessage([&] { odometry.Process(image, image, 0); }),
              HasSubstr("left image: found 10 x 128"));
}

}  // namespace
}  // namespace cvo
