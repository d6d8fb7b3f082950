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

const Eigen::Vector3d kCenter(1.0, -2.0, 0.5);
const Eigen::Matrix3d kInformation =
    (Eigen::Matrix3d() << 9.0, 1.0, 0.5, 1.0, 4.0, 0.2, 0.5, 0.2, 1.0).finished();
const RigidTransform kMotion(ExpSo3({0.4, -0.3, 0.9}), Eigen::Vector3d(3.0, 1.0, -2.0));

// Along x, the boxes have information 1 and 3, so the mean is a quarter of the way from the second
// to the first. The covariance is that of a single box of average information.
TEST(CenterEstimate, WeightsBoxesByTheirInformation) {
  CenterEstimate center;
  center.Add(Eigen::Vector3d(4.0, 0.0, 0.0), Eigen::Vector3d(1.0, 1.0, 2.0).asDiagonal());
  center.Add(Eigen::Vector3d(0.0, 2.0, 6.0), Eigen::Vector3d(3.0, 1.0, 4.0).asDiagonal());
  EXPECT_EQ(center.boxes, 2);
  EXPECT_LT((center.InObject() - Eigen::Vector3d(1.0, 1.0, 4.0)).norm(), 1e-12);
  const Eigen::Matrix3d expected = Eigen::Vector3d(0.5, 1.0, 1.0 / 3.0).asDiagonal();
  EXPECT_LT((center.Covariance() - expected).norm(), 1e-12);
}

TEST(CenterEstimate, MergingEqualsAddingAllBoxes) {
  CenterEstimate a;
  CenterEstimate b;
  CenterEstimate all;
  a.Add(kCenter, kInformation);
  all.Add(kCenter, kInformation);
  for (const double x : {2.0, 5.0}) {
    b.Add(Eigen::Vector3d(x, 0.0, 1.0), Eigen::Matrix3d::Identity());
    all.Add(Eigen::Vector3d(x, 0.0, 1.0), Eigen::Matrix3d::Identity());
  }
  a.Add(b);
  EXPECT_EQ(a.boxes, 3);
  EXPECT_LT((a.InObject() - all.InObject()).norm(), 1e-12);
  EXPECT_LT((a.Covariance() - all.Covariance()).norm(), 1e-12);
}

// Adding boxes in another frame and transforming the estimate to it give the same result.
TEST(CenterEstimate, TransformsWithItsFrame) {
  CenterEstimate here;
  here.Add(kCenter, kInformation);
  here.Add(Eigen::Vector3d(2.0, 0.0, 1.0), Eigen::Matrix3d::Identity());
  const CenterEstimate moved = here.In(kMotion);
  EXPECT_EQ(moved.boxes, 2);
  EXPECT_LT((moved.InObject() - kMotion * here.InObject()).norm(), 1e-12);
  const Eigen::Matrix3d R = kMotion.RotationMatrix();
  EXPECT_LT((moved.Covariance() - R * here.Covariance() * R.transpose()).norm(), 1e-12);
  CenterEstimate there;
  there.Add(kMotion, kCenter, kInformation);
  there.Add(kMotion, Eigen::Vector3d(2.0, 0.0, 1.0), Eigen::Matrix3d::Identity());
  EXPECT_LT((there.information - moved.information).norm(), 1e-12);
  EXPECT_LT((there.weighted - moved.weighted).norm(), 1e-12);
}

TEST(BodySize, IsTakenFromTheLastWholeBox) {
  BodySize size;
  size.Add(1.0, false);
  EXPECT_EQ(size.side_m, 1.0);
  size.Add(0.5, false);
  EXPECT_EQ(size.side_m, 1.0) << "the largest part";
  size.Add(2.0, false);
  EXPECT_EQ(size.side_m, 2.0);
  EXPECT_FALSE(size.is_whole);
  size.Add(1.5, true);
  EXPECT_EQ(size.side_m, 1.5);
  EXPECT_TRUE(size.is_whole);
  size.Add(3.0, false);
  EXPECT_EQ(size.side_m, 1.5) << "a part says nothing more";
  size.Add(1.2, true);
  EXPECT_EQ(size.side_m, 1.2);
  EXPECT_TRUE(size.is_whole);
}

TEST(FindState, ReturnsTheStateOfExactlyThisFrame) {
  Cluster cluster;
  for (const int frame : {3, 5, 9}) cluster.states.push_back({FrameId{frame}, 0, {}});
  for (const std::size_t i : {0u, 1u, 2u}) {
    EXPECT_EQ(FindState(cluster, cluster.states[i].frame), &cluster.states[i]);
  }
  for (const int frame : {2, 4, 6, 10}) EXPECT_EQ(FindState(cluster, FrameId{frame}), nullptr);
}

// A ball of 0.6 m diameter at `center`, seen by a camera at `world_from_camera`. Only its right
// half has texture, so the observed surface lies there.
struct SeenBall {
  StereoFrame frame;
  StereoCamera camera{400.0, 400.0, 320.0, 240.0, 0.2, 640, 480};
  Vector3d center{0.3, -0.2, 4.0};
  double depth_bias_m = 0.0;  // of the observed surface
  bool hides = false;         // another body occludes its lower right quarter

  ViewedSides Viewed(const BoxShape& shape) {
    From({});  // sets its detection
    ViewedSides viewed;
    const FeatureGrid grid(frame.features, camera);
    const FrameView view{frame, UseDetections::Show(frame), grid, camera, RigidTransform()};
    AddPicture(view, 0, shape, center, viewed);
    return viewed;
  }
  BoxCenter From(const RigidTransform& world_from_camera) {
    const Vector3d c = world_from_camera.Inverse() * center;
    const double u = camera.fx * c.x() / c.z() + camera.cx;
    const double v = camera.fy * c.y() / c.z() + camera.cy;
    const double half_px = camera.fx * 0.3 / c.z();
    frame.detections = {{{u - half_px, v - half_px, u + half_px, v + half_px}, "ball", 1.0}};
    if (hides) frame.detections.push_back({{u, v, u + half_px, v + half_px}, "cart", 1.0});
    const double surface_m = c.z() - 0.2 + depth_bias_m;
    const Vector3d surface = c / c.z() * surface_m + Vector3d(0.15, 0.0, 0.0);
    const FeatureGrid grid(frame.features, camera);
    const FrameView view{frame, UseDetections::Show(frame), grid, camera, world_from_camera};
    return CenterFromBox(view, ClusterOptions().birth_depth, 0, world_from_camera * surface);
  }
};

// The pose of a camera that looks along +x at the ball, from its side.
RigidTransform FromTheSide() {
  return {ExpSo3({0.0, std::numbers::pi / 2, 0.0}), Vector3d(-3.0, 0.0, 4.0)};
}

TEST(BoxCenter, LiesBehindTheSurfaceOnTheAxisOfTheBox) {
  SeenBall ball;
  const BoxCenter fix = ball.From({});
  EXPECT_NEAR(fix.size_m, 0.6, 0.04);
  EXPECT_LT((fix.center_in_world - ball.center).norm(), 0.02);
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

double DeviationAlong(const Vector3d& direction, const BoxCenter& fix) {
  const Vector3d d = direction.normalized();
  return std::sqrt(1.0 / d.dot(fix.information * d));
}

TEST(BoxCenter, IsUncertainWhereAnEdgeMayNotBeTheBodys) {
  const Vector3d up = Vector3d::UnitY();
  SeenBall ball;
  ball.center = {3.0, 0.0, 5.0};
  const Vector3d across(5.0, 0.0, -3.0);
  const BoxCenter whole = ball.From({});
  EXPECT_TRUE(whole.is_whole);
  EXPECT_NEAR(DeviationAlong(up, whole), 0.05 * whole.size_m, 1e-9);
  EXPECT_NEAR(DeviationAlong(across, whole), 0.05 * whole.size_m, 1e-9);
  EXPECT_NEAR(DeviationAlong(ball.center, whole), 0.3 * whole.size_m, 1e-9);
  ball.hides = true;
  const BoxCenter hidden = ball.From({});
  EXPECT_FALSE(hidden.is_whole);
  EXPECT_NEAR(DeviationAlong(up, hidden), 0.3 * hidden.size_m, 1e-9);
  EXPECT_NEAR(DeviationAlong(across, hidden), 0.3 * hidden.size_m, 1e-9);
  ball.hides = false;
  ball.center = {3.9, 0.0, 5.0};  // truncated by the right image border
  const BoxCenter cut = ball.From({});
  EXPECT_FALSE(cut.is_whole);
  EXPECT_NEAR(DeviationAlong(up, cut), 0.05 * cut.size_m, 1e-9);
  EXPECT_NEAR(DeviationAlong({5.0, 0.0, -3.9}, cut), 0.3 * cut.size_m, 1e-9);
}

TEST(CenterEstimate, TwoViewsResolveTheDepthThatOneCannot) {
  SeenBall ball;
  ball.depth_bias_m = 0.15;  // half a radius
  const BoxCenter front = ball.From({});
  EXPECT_GT((front.center_in_world - ball.center).norm(), 0.12);
  CenterEstimate center;
  center.Add(front.center_in_world, front.information);
  const BoxCenter side = ball.From(FromTheSide());
  center.Add(side.center_in_world, side.information);
  EXPECT_EQ(center.boxes, 2);
  EXPECT_LT((center.InObject() - ball.center).norm(), 0.02);
}

}  // namespace
}  // namespace cvo::box_center_test
