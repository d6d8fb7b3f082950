// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <opencv2/core.hpp>

#include "experiments/datasets/body_truth.h"
#include "experiments/datasets/images.h"
#include "experiments/datasets/sequence.h"
#include "experiments/metrics/camera_metrics.h"
#include "tests/support/real_data.h"

// The readers on real KITTI data. The folder is named by the environment variable CLUSTERVO_DATA
// only; it has kitti_raw, kitti_odometry and kitti_tracking.

namespace cvo {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class KittiData : public testing::Test {
 protected:
  void SetUp() override {
    const auto folder = test::RealData();
    if (!folder) GTEST_SKIP() << "CLUSTERVO_DATA does not name a folder with KITTI data";
    data_ = *folder;
  }

  fs::path Drive(const std::string& number) const {
    return data_ / "kitti_raw/2011_09_26" / ("2011_09_26_drive_" + number + "_sync");
  }
  fs::path Tracking() const { return data_ / "kitti_tracking/training"; }
  fs::path Odometry() const { return data_ / "kitti_odometry/sequences/06"; }

  fs::path data_;
};

double PathLength(const Sequence& sequence) {
  double length = 0.0;
  const auto& poses = sequence.groundtruth_world_from_camera;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    if (!poses[i] || !poses[i - 1]) continue;
    length += (poses[i]->translation() - poses[i - 1]->translation()).norm();
  }
  return length;
}

std::size_t FramesWithTruth(const Sequence& sequence) {
  const auto& poses = sequence.groundtruth_world_from_camera;
  return static_cast<std::size_t>(
      std::count_if(poses.begin(), poses.end(), [](const auto& pose) { return pose.has_value(); }));
}

double Value(const std::vector<Metric>& metrics, const std::string& name) {
  const Metric* metric = FindMetric(metrics, name);
  return metric == nullptr ? -1.0 : metric->value;
}

TEST_F(KittiData, RawDriveHasItsCameraTimesAndTruth) {
  const Sequence s = OpenSequence({.folder = Drive("0001")});
  EXPECT_EQ(s.name, "2011_09_26_drive_0001");
  EXPECT_EQ(s.type, "kitti-raw");
  EXPECT_EQ(s.pair, "grey");
  EXPECT_EQ(s.total_frames, 108);
  EXPECT_EQ(s.images.size(), 108u);
  EXPECT_EQ(s.camera.fx, 721.5377);
  EXPECT_EQ(s.camera.cx, 609.5593);
  EXPECT_NEAR(s.camera.baseline_m, 387.5744 / 721.5377, 1e-12);
  EXPECT_EQ(s.camera.width_px, 1242);
  EXPECT_EQ(s.camera.height_px, 375);
  // 2011-09-26 13:02:25.967790592
  EXPECT_EQ(s.timestamps_ns.front(), 1317042145967790592);
  EXPECT_EQ(s.groundtruth, "devkit");
  EXPECT_EQ(FramesWithTruth(s), 108u);
  // Starts at the origin and drives forward at about 10 m/s.
  EXPECT_NEAR(s.groundtruth_world_from_camera[0]->translation().norm(), 0.0, 1e-9);
  EXPECT_GT(s.groundtruth_world_from_camera[10]->translation().z(), 5.0);
  EXPECT_NEAR(PathLength(s), 107.0, 5.0);
}

TEST_F(KittiData, RawImagesDecode) {
  const Sequence s = OpenSequence({.folder = Drive("0001"), .begin_frame = 100});
  EXPECT_EQ(s.first_frame, 100);
  ASSERT_EQ(s.images.size(), 8u);
  for (const StereoPaths& paths : s.images) {
    const LoadedImage image = LoadGrey(paths.right);
    ASSERT_TRUE(image.ok()) << image.problem;
    EXPECT_EQ(image.grey.size(), cv::Size(1242, 375));
    EXPECT_EQ(image.sha256.size(), 64u);
  }
}

TEST_F(KittiData, InterpolatedTruthDiffersByCentimetresAndEndsAtThePackets) {
  const Sequence devkit = OpenSequence({.folder = Drive("0001")});
  const Sequence moved = OpenSequence({.folder = Drive("0001"), .groundtruth = "interpolated"});
  EXPECT_EQ(moved.groundtruth, "interpolated");
  const std::vector<Metric> metrics =
      EvaluateCamera(devkit.groundtruth_world_from_camera, moved.groundtruth_world_from_camera);
  EXPECT_GT(Value(metrics, "camera_ate"), 0.005);
  EXPECT_LT(Value(metrics, "camera_ate"), 0.06);
  // The last image was taken 0.02 ms after the last packet.
  EXPECT_EQ(FramesWithTruth(moved), 107u);
  EXPECT_FALSE(moved.groundtruth_world_from_camera.back().has_value());
  // The first image of drive 0013 was taken 1.1 ms before its first packet.
  const Sequence both = OpenSequence({.folder = Drive("0013"), .groundtruth = "interpolated"});
  EXPECT_EQ(FramesWithTruth(both), 70u);
  EXPECT_FALSE(both.groundtruth_world_from_camera.front().has_value());
  ASSERT_EQ(both.missing.size(), 1u);
  EXPECT_THAT(both.missing[0], HasSubstr("no ground truth for 2 of 72 images"));
}

TEST_F(KittiData, TrackingLabelsAndDetectionsApplyToTheRawDrive) {
  const Sequence s = OpenSequence({.folder = Drive("0013"),
                                   .labels_file = Tracking() / "label_02/0003.txt",
                                   .detections_file = Tracking() / "det_02_regionlets/0003.txt",
                                   .detections_camera = 2,
                                   .min_score = 0.0});
  EXPECT_EQ(s.labels.size(), 455u);
  EXPECT_EQ(std::count_if(s.detections.begin(), s.detections.end(),
                          [](const ObjectBox& box) { return box.type == "Car"; }),
            268);
  EXPECT_NEAR(s.detections_offset_m, 44.85728 / 721.5377, 1e-12);
  // The first label with a 3D box is 4.76 m ahead, and therefore 9.4 px further left in image_00.
  const auto car = std::find_if(s.labels.begin(), s.labels.end(),
                                [](const ObjectBox& box) { return box.box3d.has_value(); });
  ASSERT_NE(car, s.labels.end());
  EXPECT_NEAR(car->left_px, 894.768323 - 44.85728 / 4.758829, 1e-6);
}

TEST_F(KittiData, OdometryHasPosesOfAllItsFrames) {
  const Sequence s = OpenSequence({.folder = Odometry()});
  EXPECT_EQ(s.name, "odometry_06");
  EXPECT_EQ(s.groundtruth, "official");
  EXPECT_EQ(s.images.size(), 51u);
  EXPECT_EQ(FramesWithTruth(s), 51u);
  EXPECT_EQ(s.timestamps_ns[1], 100'000'000);
  EXPECT_EQ(s.camera.fx, 707.0912);
  EXPECT_NEAR(s.camera.baseline_m, 379.8145 / 707.0912, 1e-12);
  EXPECT_EQ(s.camera.width_px, 1226);
  EXPECT_NEAR(s.groundtruth_world_from_camera[1]->translation().z(), 1.198998, 1e-12);
  EXPECT_NEAR(s.groundtruth_world_from_camera[2]->translation().x(), -2.787365e-02, 1e-12);
}

TEST_F(KittiData, OpensATrackingSequenceInColour) {
  const Sequence s = OpenSequence({.folder = Tracking() / "0005"});
  EXPECT_EQ(s.name, "tracking_0005");
  EXPECT_EQ(s.pair, "colour");
  EXPECT_EQ(s.images.size(), 16u);
  EXPECT_EQ(s.labels.size(), 98u);
  EXPECT_EQ(s.groundtruth, "none");
  EXPECT_NEAR(s.camera.baseline_m, (44.85728 + 339.5242) / 721.5377, 1e-12);
  ASSERT_EQ(s.missing.size(), 1u);
  EXPECT_THAT(s.missing[0], HasSubstr("oxts/0005.txt"));
  EXPECT_EQ(LoadGrey(s.images[0].left).grey.type(), CV_8UC1);
  const Sequence same = OpenSequence({.folder = Tracking() / "image_02/0005/"});
  EXPECT_EQ(same.name, s.name);
  EXPECT_EQ(same.folder, s.folder);
}

}  // namespace
}  // namespace cvo

// True bodies of drive_0013, labelled as tracking sequence 0003.

namespace cvo {
namespace {

class KittiBodies : public testing::Test {
 protected:
  void SetUp() override {
    const auto folder = test::RealData();
    if (!folder) GTEST_SKIP() << "CLUSTERVO_DATA does not name a folder with KITTI data";
    data_ = *folder;
  }

  std::unique_ptr<BodyTruthReader> Read(const std::string& groundtruth) const {
    return ReadBodyTruth(
        OpenSequence({.folder = data_ / "kitti_raw/2011_09_26/2011_09_26_drive_0013_sync",
                      .groundtruth = groundtruth,
                      .labels_file = data_ / "kitti_tracking/training/label_02/0003.txt"}));
  }

  std::filesystem::path data_;
};

TEST_F(KittiBodies, TwoVisibleCarsMoveAndTheParkedOnesDoNot) {
  const auto reader = Read("devkit");
  ASSERT_NE(reader, nullptr);
  std::vector<int> movers;
  for (const TruthBody& body : reader->objects().bodies) {
    int visible = 0;
    for (const auto& frame : body.frames) visible += frame && frame->visible ? 1 : 0;
    if (visible == 0) continue;
    if (body.mover) {
      movers.push_back(body.id);
    } else {
      EXPECT_LT(body.travel_m, 1.0) << body.id;
    }
  }
  EXPECT_THAT(movers, testing::ElementsAre(1, 2));
  EXPECT_NEAR(FindBody(reader->objects(), 1)->travel_m, 107.0, 1.0);  // about 15 m/s
}

TEST_F(KittiBodies, BoxesAreAlignedWithImages) {
  // A point on the number plate of the first car in frame 8, 2 m closer than its centre, and a
  // point on the road beside it. An offset between boxes and images would move them off.
  const auto reader = Read("devkit");
  const auto body = [&](double u, double v, double z) {
    const double fx = 721.5377, cx = 609.5593, cy = 172.854;
    return static_cast<int>(
        reader->Find(8, {u, v}, {(u - cx) * z / fx, (v - cy) * z / fx, z}).body);
  };
  const Eigen::Vector3d center =
      reader->objects().world_from_camera[8]->Inverse() *
      Eigen::Vector3d(FindBody(reader->objects(), 1)->frames[8]->world_from_object.translation());
  EXPECT_NEAR(center.z(), 7.15, 0.1);
  EXPECT_EQ(body(1090, 308, center.z() - 2.0), 1);
  EXPECT_EQ(body(700, 308, center.z() - 2.0), 0);
}

}  // namespace
}  // namespace cvo
