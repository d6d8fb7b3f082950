// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/rng.h"
#include "core/clusters/cluster_prediction.h"
#include "core/labelling/landmark_update.h"
#include "tests/core/labelling/labelled_frame.h"

namespace cvo::labels_test {
namespace {

using test::Frame;
using test::kCamera;
using test::Moving;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

// Tests what happens to the labelled points of a frame: new landmarks and clusters, and landmarks
// that change their body.

constexpr ClusterId kNone{};

std::vector<std::int64_t> FramesOf(const Landmark& landmark) {
  std::vector<std::int64_t> frames;
  for (const Observation& seen : landmark.observations) frames.push_back(seen.frame.value);
  return frames;
}

TEST(UpdateLandmarks, StaticPointThatMovedWithTheBodyKeepsItsPast) {
  Moving m;
  m.window.landmarks = {Moving::Seen(m.p_in_world, [&](std::int64_t f) { return m.OnBody(f); })};
  m.Add(m.p_in_world, kSceneOwner, 0, ClusterId{1});
  EXPECT_EQ(m.Update(), 0);
  EXPECT_THAT(m.window.landmarks, IsEmpty());
  ASSERT_THAT(m.map.live[0].landmarks, SizeIs(1));
  const Landmark& landmark = m.map.live[0].landmarks[0];
  EXPECT_EQ(landmark.id, LandmarkId{7});
  EXPECT_EQ(m.labels.points[0].id, LandmarkId{7});
  EXPECT_EQ(landmark.label.cluster, ClusterId{1});
  EXPECT_THAT(FramesOf(landmark), ElementsAre(0, 1, 2, 3, 4));
  EXPECT_LT((Moving::BodyAt(4) * landmark.p_in_object - m.p_in_world).norm(), 1e-9);
}

TEST(UpdateLandmarks, PointOfTheBodyThatStoodStillBecomesStatic) {
  Moving m;
  const Eigen::Vector3d p_in_object = Moving::BodyAt(4).Inverse() * m.p_in_world;
  // The point is static in frames 2 and 3, and on the body before.
  m.map.live[0].landmarks = {Moving::Seen(
      p_in_object, [&](std::int64_t f) { return f < 2 ? m.OnBody(f) : m.p_in_world; })};
  m.map.live[0].landmarks[0].past_information.setIdentity();
  m.Add(m.p_in_world, Moving::kBody, 0, kStaticScene);
  EXPECT_EQ(m.Update(), 0);
  EXPECT_THAT(m.map.live[0].landmarks, IsEmpty());
  ASSERT_THAT(m.window.landmarks, SizeIs(1));
  EXPECT_THAT(FramesOf(m.window.landmarks[0]), ElementsAre(2, 3, 4));
  EXPECT_LT((m.window.landmarks[0].p_in_object - m.p_in_world).norm(), 1e-9);
  // The past information was about its position on the body.
  EXPECT_TRUE(m.window.landmarks[0].past_information.isZero());
}

TEST(UpdateLandmarks, RemovesOutliersAndCreatesNewPoints) {
  Moving m;
  m.window.landmarks = {Moving::Seen(m.p_in_world, [&](std::int64_t) { return m.p_in_world; })};
  m.Add(m.p_in_world, kSceneOwner, 0, kNone);
  m.Add({0.0, 0.0, 9.0}, kNoOwner, -1, kStaticScene);
  m.Add({0.1, 0.0, 6.0}, kNoOwner, -1, ClusterId{1});
  m.Add({0.2, 0.0, 9.0}, kNoOwner, -1, kNone);
  EXPECT_EQ(m.Update(), 2);
  ASSERT_THAT(m.window.landmarks, SizeIs(1));
  EXPECT_EQ(m.window.landmarks[0].id, LandmarkId{10});
  ASSERT_THAT(m.map.live[0].landmarks, SizeIs(1));
  EXPECT_EQ(m.map.live[0].landmarks[0].id, LandmarkId{11});
  EXPECT_LT((m.map.live[0].landmarks[0].p_in_object - Eigen::Vector3d(-0.3, 0.0, 0.0)).norm(),
            1e-9);
  EXPECT_EQ(m.next, LandmarkId{12});
  EXPECT_EQ(m.labels.points[2].id, LandmarkId{11});
  EXPECT_FALSE(m.labels.points[3].id.valid());
}

TEST(UpdateLandmarks, CovarianceIsTheBestTriangulationInTheBodysFrame) {
  Moving m;
  m.tracks[0].world_from_object =
      RigidTransform(ExpSo3({0.0, 1.2, 0.0}), Eigen::Vector3d(0.4, 0.0, 6.0));
  m.Add(m.p_in_world, kNoOwner, -1, ClusterId{1});
  m.Update();
  const Landmark& landmark = m.map.live[0].landmarks.at(0);
  const Eigen::Matrix3d R = m.tracks[0].world_from_object.RotationMatrix();
  const Eigen::Matrix3d in_camera = kCamera.PointCovariance(
      Frame::Pixel(m.p_in_world), MeasurementCovariance(m.options.noise, 1.0));
  EXPECT_LT((R * landmark.covariance.in_object_m2 * R.transpose() - in_camera).norm(), 1e-12);
}

TEST(RemoveUnconfirmed, DropsLandmarksSeenOnceLongAgo) {
  std::vector<Landmark> landmarks(4);
  for (int i = 0; i < 4; ++i) {
    landmarks[i].id = LandmarkId{i};
    landmarks[i].observations.resize(i == 2 ? 2 : 1);
    landmarks[i].last_seen = FrameId{i == 0 ? 8 : 7};
  }
  landmarks[3].past_information.setIdentity();
  RemoveUnconfirmed(FrameId{10}, landmarks);
  ASSERT_THAT(landmarks, SizeIs(3));
  EXPECT_EQ(landmarks[0].id, LandmarkId{0});
  EXPECT_EQ(landmarks[1].id, LandmarkId{2});
  EXPECT_EQ(landmarks[2].id, LandmarkId{3});
}

// A frame with the visible half of a ball and its box.
Frame Ball(const Eigen::Vector3d& center, double radius_m) {
  Frame frame;
  Rng rng(1, "ball");
  while (frame.points.size() < 400) {
    const Eigen::Vector3d n =
        Eigen::Vector3d(rng.Normal(), rng.Normal(), rng.Normal()).normalized();
    const Eigen::Vector3d p = center + radius_m * n;
    if (n.dot(p) < 0.0) frame.Add(p, kNoOwner, -1, ClusterId{1});
  }
  const Eigen::Vector3d z = Frame::Pixel(center);
  const double half_px = kCamera.fx * radius_m / center.z();
  frame.frame.detections = {
      {{z[0] - half_px, z[1] - half_px, z[0] + half_px, z[1] + half_px}, "ball", 0.7}};
  return frame;
}

TEST(CreateClusters, TheirOriginIsTheMedianOfTheirPoints) {
  const Eigen::Vector3d center(0.5, 0.3, 8.0);
  Frame frame = Ball(center, 0.6);
  frame.labels.births = {{ClusterId{1}, 0, -1}};
  frame.With([&](const FrameView& view) {
    CreateClusters(view, FrameId{4}, frame.points, frame.labels, frame.map);
    return 0;
  });
  ASSERT_THAT(frame.map.live, SizeIs(1));
  const Cluster& cluster = frame.map.live[0];
  EXPECT_EQ(cluster.id, ClusterId{1});
  EXPECT_EQ(frame.map.next, ClusterId{2});
  EXPECT_EQ(cluster.category, "ball");
  EXPECT_EQ(cluster.detections, 1);
  EXPECT_EQ(cluster.score, 0.7);
  ASSERT_THAT(cluster.states, SizeIs(1));
  EXPECT_TRUE(cluster.Latest().velocity_m_s.isZero());
  // Half of the visible hemisphere is nearer than half its radius from the centre.
  const Eigen::Vector3d from_center = cluster.Latest().world_from_object.translation() - center;
  EXPECT_LT((from_center + 0.3 * center.normalized()).norm(), 0.1);
}

TEST(CreateClusters, GivenLabelsWithoutABoxMakeABodyOfCategoryObject) {
  Frame frame = Ball({0.0, 0.0, 8.0}, 0.6);
  frame.labels.births = {{ClusterId{1}, -1, 5}};
  frame.With([&](const FrameView& view) {
    CreateClusters(view, FrameId{4}, frame.points, frame.labels, frame.map);
    return 0;
  });
  const Cluster& cluster = frame.map.live.at(0);
  EXPECT_EQ(cluster.given_body, BodyId{5});
  EXPECT_EQ(cluster.category, "object");
  EXPECT_EQ(cluster.detections, 0);
  EXPECT_TRUE(IsConfirmed(cluster, {}));
}

TEST(DropWeakBirths, RenumbersTheOthersAndReleasesThePoints) {
  Frame frame;
  frame.map.next = ClusterId{5};
  frame.window.landmarks.resize(1);
  frame.window.landmarks[0].label = {kStaticScene, 1};
  const Eigen::Vector3d p(0.0, 0.0, 5.0);
  for (int i = 0; i < 3; ++i) frame.Add(p, kNoOwner, -1, ClusterId{5});
  frame.Add(p, kNoOwner, -1, ClusterId{6});
  frame.Add(p, kSceneOwner, 0, ClusterId{6});
  for (int i = 0; i < 4; ++i) frame.Add(p, kNoOwner, -1, ClusterId{7});
  frame.Add(p, kNoOwner, -1, kStaticScene);
  // Inferred to belong to a new cluster, but not yet assigned to it.
  frame.labels.points.back().inferred = ClusterId{7};
  frame.labels.births = {{ClusterId{5}, 0, -1}, {ClusterId{6}, 1, -1}, {ClusterId{7}, 2, -1}};
  DropWeakBirths(3, frame.window, frame.map, frame.points, frame.labels);
  ASSERT_THAT(frame.labels.births, SizeIs(2));
  EXPECT_EQ(frame.labels.births[0].id, ClusterId{5});
  EXPECT_EQ(frame.labels.births[0].detection, 0);
  EXPECT_EQ(frame.labels.births[1].id, ClusterId{6});
  EXPECT_EQ(frame.labels.births[1].detection, 2);
  std::vector<std::int64_t> assigned;
  for (const LandmarkReport& label : frame.labels.points) assigned.push_back(label.cluster.value);
  EXPECT_THAT(assigned, ElementsAre(5, 5, 5, 0, 0, 6, 6, 6, 6, 0));
  EXPECT_FALSE(frame.labels.points[3].inferred.valid());
  EXPECT_EQ(frame.labels.points[5].inferred, ClusterId{6});
  EXPECT_EQ(frame.labels.points.back().inferred, ClusterId{6});
}

TEST(CollectPoints, OmitsOnlyNewPointsWithoutDisparity) {
  Frame frame;
  frame.Add({0.0, 0.0, 5.0}, kNoOwner, -1, kNone);
  for (int i = 0; i < 3; ++i) frame.Add({0.0, 0.0, 200.0}, kNoOwner, -1, kNone);
  std::vector<ClusterTrack> tracks(2);
  tracks[1].matches = {{4, 2, 0}};
  const auto points = frame.With([&](const FrameView& view) {
    return CollectPoints(view, {{9, 3, 0}}, tracks);
  });
  ASSERT_THAT(points, SizeIs(3));
  EXPECT_EQ(points[0].owner, kNoOwner);
  EXPECT_EQ(points[1].feature, 2);
  EXPECT_EQ(points[1].owner, 1);
  EXPECT_EQ(points[1].landmark, 4);
  EXPECT_EQ(points[2].owner, kSceneOwner);
  EXPECT_EQ(points[2].landmark, 9);
}

TEST(CollectPoints, UsesReserveFeaturesOnlyOnBodies) {
  Frame frame;
  const std::vector<Eigen::Vector3d> p = {
      {-1.0, 0.0, 5.0}, {0.0, 0.0, 5.0}, {1.0, 0.0, 5.0}, {1.0, 1.0, 5.0}};
  for (const Eigen::Vector3d& point : p) {
    frame.Add(point, kNoOwner, -1, kNone);
    frame.frame.features.back().is_reserve = true;
  }
  const auto around = [&](int feature) {
    const Eigen::Vector3d& z_px = frame.frame.features[feature].z_px;
    return ImageBox{z_px[0] - 5.0, z_px[1] - 5.0, z_px[0] + 5.0, z_px[1] + 5.0};
  };
  frame.frame.detections = {{around(1), "Car", 0.9}};
  std::vector<ClusterTrack> tracks(1);
  tracks[0].box = around(2);
  std::vector<int> features;
  for (const FramePoint& point : frame.With([&](const FrameView& view) {
         return CollectPoints(view, {{9, 3, 0}}, tracks);
       })) {
    features.push_back(point.feature);
  }
  // One in the detection, one on the cluster, and one that is matched.
  EXPECT_THAT(features, ElementsAre(1, 2, 3));
}

TEST(SceneFeatures, UseReserveFeaturesOnlyInDetections) {
  std::vector<StereoFeature> features(3);
  features[0].z_px = {50.0, 50.0, 40.0};
  features[1].z_px = {10.0, 10.0, 5.0};
  features[2].z_px = {52.0, 50.0, 40.0};
  features[1].is_reserve = features[2].is_reserve = true;
  EXPECT_THAT(SceneFeatures(features, {}), ElementsAre(0));
  const std::vector<Detection> car = {{{45.0, 45.0, 55.0, 55.0}, "Car", 0.9}};
  EXPECT_THAT(SceneFeatures(features, car), ElementsAre(0, 2));
}

}  // namespace
}  // namespace cvo::labels_test
