// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Frames and poses read back from a log are identical to those written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "experiments/log/frame_log.h"
#include "experiments/log/pack_frames.h"
#include "experiments/log/packed.h"
#include "experiments/log/pose_log.h"
#include "tests/support/temp_folder.h"

namespace cvo {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

RigidTransform At(double x) {
  return {ExpSo3({0.1 * x, 0.2, 0.3}), Eigen::Vector3d(x, 2.0 * x, 3.0)};
}

ClusterReport MakeCluster(int i) {
  ClusterReport cluster;
  cluster.id = ClusterId{i};
  cluster.category = "a category that is longer than a short text";
  cluster.status = ClusterStatus::kPredicted;
  cluster.world_from_object = At(i);
  cluster.velocity_m_s = {1.0 + i, 2.0, 3.0};
  cluster.center_in_object = {4.0 + i, 5.0, 6.0};
  cluster.half_size_m = {7.0 + i, 8.0, 9.0};
  cluster.box = {At(0.5 + i), {1.5, 1.6, 1.7 + i}};
  cluster.observed_landmarks = 10 + i;
  cluster.detection = 11 + i;
  cluster.score = 0.12 + i;
  return cluster;
}

FrameRecord MakeFrame(int i) {
  FrameRecord frame;
  frame.frame = 4 + i;
  frame.timestamp_ns = 1'000'000'000'000LL + i;
  FrameReport& report = frame.report;
  report.status = FrameStatus::kRecovered;
  report.world_from_camera = At(0.25 + i);
  report.features = 1 + i;
  report.matches = 2 + i;
  report.inliers = 3 + i;
  report.new_landmarks = 4 + i;
  report.window_frames = 5 + i;
  report.spatial_ages = {i, 6, 7};
  report.window_landmarks = 8 + i;
  report.window_iterations = 9 + i;
  report.window_endings = {10 + i, 11, 12};
  report.cluster_endings = {13 + i, 14, 15};
  report.calibration.right_field_px.setConstant(0.1 + i);
  report.calibration.information.setConstant(0.2 + i);
  report.mean_error_px = 0.3 + i;
  for (int k = 0; k < i % 3; ++k) report.clusters.push_back(MakeCluster(k + 1));
  frame.refined_world_from_camera = At(0.75 + i);
  frame.detections.push_back({{1.0, 2.0, 3.0, 4.0 + i}, "Car", 0.5});
  frame.landmarks.push_back({i, {std::int16_t{3}, PointMotion::kStopped}, 7});
  frame.problems.push_back({"image_0/7.png", "half a file"});
  return frame;
}

// The packed form of a record, which covers all fields that are packed. PacksEveryField tests that
// none is missing.
std::string Bytes(const auto& record) {
  std::string bytes;
  Packer{bytes}(record);
  return bytes;
}

TEST(FrameLog, ReadsBackAnyNumberOfFrames) {
  const test::TempFolder folder;
  FrameLog log(folder.path());
  constexpr int kFrames = 100;
  for (int i = 0; i < kFrames; ++i) log.Append(MakeFrame(i));
  ASSERT_THAT(log, SizeIs(kFrames));
  int i = 0;
  for (const FrameRecord& frame : log) EXPECT_EQ(Bytes(frame), Bytes(MakeFrame(i++)));
  EXPECT_EQ(i, kFrames);
  EXPECT_EQ(Bytes(log[57]), Bytes(MakeFrame(57)));
}

TEST(FrameLog, PacksEveryField) {
  const FrameRecord expected = MakeFrame(2);
  const FrameRecord frame = FrameLog({expected})[0];
  const FrameReport& a = frame.report;
  const FrameReport& b = expected.report;
  EXPECT_EQ(frame.frame, 6);
  EXPECT_EQ(frame.timestamp_ns, expected.timestamp_ns);
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.world_from_camera.Minus(b.world_from_camera).norm(), 0.0);
  EXPECT_THAT(std::vector({a.features, a.matches, a.inliers, a.new_landmarks, a.window_frames}),
              ElementsAre(3, 4, 5, 6, 7));
  EXPECT_THAT(a.spatial_ages, ElementsAre(2, 6, 7));
  EXPECT_THAT(std::vector({a.window_landmarks, a.window_iterations}), ElementsAre(10, 11));
  EXPECT_EQ(a.window_endings.converged, 12);
  EXPECT_EQ(a.cluster_endings.no_usable_step, 15);
  EXPECT_EQ(a.calibration.right_field_px, b.calibration.right_field_px);
  EXPECT_EQ(a.calibration.information, b.calibration.information);
  EXPECT_EQ(a.mean_error_px, b.mean_error_px);
  EXPECT_EQ(frame.refined_world_from_camera.translation().x(), 2.75);
  EXPECT_EQ(frame.detections.at(0).category, "Car");
  EXPECT_EQ(frame.detections[0].box.bottom_px, 6.0);
  EXPECT_EQ(frame.landmarks.at(0).truth, expected.landmarks[0].truth);
  EXPECT_EQ(frame.landmarks[0].count, 7);
  EXPECT_EQ(frame.problems.at(0).image, "image_0/7.png");
  EXPECT_EQ(frame.problems[0].reason, "half a file");
  ASSERT_THAT(a.clusters, SizeIs(2));
  const ClusterReport& c = a.clusters[1];
  const ClusterReport d = MakeCluster(2);
  EXPECT_EQ(c.id, d.id);
  EXPECT_EQ(c.category, d.category);
  EXPECT_EQ(c.status, d.status);
  EXPECT_EQ(c.world_from_object.Minus(d.world_from_object).norm(), 0.0);
  EXPECT_EQ(c.velocity_m_s, d.velocity_m_s);
  EXPECT_EQ(c.center_in_object, d.center_in_object);
  EXPECT_EQ(c.half_size_m, d.half_size_m);
  EXPECT_EQ(c.box.object_from_box.Minus(d.box.object_from_box).norm(), 0.0);
  EXPECT_EQ(c.box.size_m, d.box.size_m);
  EXPECT_EQ(c.observed_landmarks, 12);
  EXPECT_EQ(c.detection, 13);
  EXPECT_EQ(c.score, d.score);
}

TEST(FrameLog, RefineReplacesOnlyRefinedPoses) {
  FrameLog log({MakeFrame(0), MakeFrame(1)});
  EXPECT_THROW(log.Refine({At(1.0)}), Error);
  log.Refine({At(8.0), At(9.0)});
  EXPECT_EQ(log[1].refined_world_from_camera.translation().x(), 9.0);
  EXPECT_EQ(log[1].report.world_from_camera.translation().x(), 1.25);
}

ClusterPose PoseOf(int cluster, std::int64_t frame) {
  ClusterPose pose{MakeCluster(cluster), frame, 100 * frame};
  return pose;
}

TEST(PoseLog, OrdersPosesAddedInAnyOrder) {
  const test::TempFolder folder;
  PoseLog log(folder.path());
  log.Add({{ClusterId{2}, "", {PoseOf(2, 0), PoseOf(2, 1)}}, {ClusterId{3}, "", {}}});
  log.Add({{ClusterId{1}, "", {PoseOf(1, 1)}}, {ClusterId{2}, "", {PoseOf(2, 2)}}});
  EXPECT_THAT(log.clusters(), ElementsAre(ClusterId{1}, ClusterId{2}, ClusterId{3}));
  std::vector<std::pair<int, int>> by_frame;
  for (const PoseLog::Entry& entry : log.ByFrame())
    by_frame.emplace_back(entry.frame, entry.cluster);
  EXPECT_THAT(by_frame,
              ElementsAre(std::pair(0, 2), std::pair(1, 1), std::pair(1, 2), std::pair(2, 2)));
  const std::vector<PoseLog::Entry> by_cluster = log.ByCluster();
  ASSERT_THAT(by_cluster, SizeIs(4));
  EXPECT_EQ(by_cluster[0].id(), ClusterId{1});
  EXPECT_EQ(by_cluster[3].frame, 2);
  EXPECT_EQ(Bytes(log.Read(by_cluster[3])), Bytes(PoseOf(2, 2)));
}

}  // namespace
}  // namespace cvo
