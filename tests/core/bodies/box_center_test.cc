// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "core/bodies/body_boxes.h"
#include "core/bodies/body_place.h"
#include "core/estimation/cluster.h"
#include "core/odometry/cluster_update.h"

namespace cvo::box_center_test {
namespace {

using Eigen::Vector3d;

TEST(FindState, ReturnsTheStateOfExactlyThisFrame) {
  Cluster cluster;
  for (const int frame : {3, 5, 9}) cluster.states.push_back({FrameId{frame}, 0, {}});
  for (auto& state : cluster.states) EXPECT_EQ(FindState(cluster, state.frame), &state);
  for (const int frame : {2, 4, 6, 10}) EXPECT_EQ(FindState(cluster, FrameId{frame}), nullptr);
}

// A ball of 0.6 m diameter at `center`, seen by a camera at `world_from_camera`.
struct SeenBall {
  Options options;
  StereoFrame frame;
  StereoCamera camera{400.0, 400.0, 320.0, 240.0, 0.2, 640, 480};
  Vector3d center{0.3, -0.2, 4.0};
  double depth_bias_m = 0.0;
  bool hides = false;  // another body occludes its lower right quarter

  // Calls `use` with the ball's view.
  auto Seen(const RigidTransform& world_from_camera, auto use) {
    const Vector3d c = world_from_camera.Inverse() * center;
    const double u = camera.fx * c.x() / c.z() + camera.cx;
    const double v = camera.fy * c.y() / c.z() + camera.cy;
    const double half_px = camera.fx * 0.3 / c.z();
    frame.detections = {{{u - half_px, v - half_px, u + half_px, v + half_px}, "ball", 1.0}};
    if (hides) frame.detections.push_back({{u, v, u + half_px, v + half_px}, "cart", 1.0});
    const FeatureGrid grid(frame.features, camera);
    return use(
        FrameView{frame, UseDetections::Show(frame), grid, camera, world_from_camera, options});
  }
  ViewedSides Viewed(const BoxShape& shape) {
    ViewedSides viewed;
    Seen({}, [&](const FrameView& view) {
      AddPicture(view, 0, shape, center, viewed);
      return 0;
    });
    return viewed;
  }
  // The centre, placed too far along the line of sight by depth_bias_m.
  Vector3d From(const RigidTransform& world_from_camera) const {
    const Vector3d c = world_from_camera.Inverse() * center;
    return world_from_camera * (c * (1.0 + depth_bias_m / c.z()));
  }
  // Relative to its diameter.
  Vector3d Deviations() {
    return Seen({}, [](const FrameView& view) { return CenterDeviations(view, 0, 1.0); });
  }
};

// The pose of a camera that looks along +x at the ball, from its side.
RigidTransform FromTheSide() {
  return {ExpSo3({0.0, std::numbers::pi / 2, 0.0}), Vector3d(-3.0, 0.0, 4.0)};
}

TEST(BodyPlace, BallIsAsTallAndWideAsItsImage) {
  SeenBall ball;
  const Eigen::Matrix3d turned =
      Eigen::AngleAxisd(std::numbers::pi / 4.0, Vector3d::UnitY()).toRotationMatrix();
  BoxShape shape{turned, Vector3d::Constant(0.5)};
  // As far as its image tells, it might be a box seen across its corners.
  EXPECT_LT(ball.Viewed(shape).square_m, 0.55);
  shape.is_round = true;
  const ViewedSides of_ball = ball.Viewed(shape);
  EXPECT_NEAR(of_ball.height_m, 0.6, 1e-9);
  EXPECT_NEAR(of_ball.square_m, 0.6, 1e-9);
}

TEST(BoxCenter, IsUncertainWhereAnEdgeMayNotBeTheBodys) {
  SeenBall ball;
  ball.center = {3.0, 0.0, 5.0};
  EXPECT_EQ(ball.Deviations(), Vector3d(0.05, 0.05, 0.3));
  ball.hides = true;
  EXPECT_EQ(ball.Deviations(), Vector3d(0.3, 0.3, 0.3));
  ball.hides = false;
  ball.center = {3.9, 0.0, 5.0};  // truncated by the right image border
  EXPECT_EQ(ball.Deviations(), Vector3d(0.3, 0.05, 0.3));
}

TEST(CenterEstimate, TwoViewsResolveTheDepthThatOneCannot) {
  SeenBall ball;
  ball.depth_bias_m = 0.15;  // half a radius
  const Vector3d front = ball.From({});
  EXPECT_GT((front - ball.center).norm(), 0.12);
  const Vector3d deviations_m = 0.6 * ball.Deviations();
  CenterEstimate center;
  const auto add = [&](const RigidTransform& world_from_camera, const Vector3d& seen) {
    const Vector3d ray = world_from_camera.Inverse() * seen;
    center.Add({}, seen, InformationAlong(world_from_camera, ray, deviations_m));
  };
  add({}, front);
  add(FromTheSide(), ball.From(FromTheSide()));
  EXPECT_EQ(center.boxes, 2);
  EXPECT_LT((center.InObject() - ball.center).norm(), 0.02);
}

TEST(CenterEstimate, CountsEarlierViewsLessAfterAnUncertainMotion) {
  CenterEstimate center;
  center.Add({}, Vector3d::Zero(), Eigen::Matrix3d::Identity());
  center.Loosen(Vector3d(0.0, 1.0, 3.0).asDiagonal());
  EXPECT_LT(center.InObject().norm(), 1e-12);
  center.Add({}, Vector3d::Ones(), Eigen::Matrix3d::Identity());
  EXPECT_LT((center.InObject() - Vector3d(1.0 / 2.0, 2.0 / 3.0, 4.0 / 5.0)).norm(), 1e-12);
}

}  // namespace
}  // namespace cvo::box_center_test
