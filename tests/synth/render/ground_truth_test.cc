// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/core.hpp>

#include "tests/synth/render/worlds.h"

namespace cvo::synth {
namespace {

Rendering DrawWorld(const World& world) { return Renderer(world, 2).Draw(ViewOf(world)); }

TEST(Depth, OfAPlaneIsExact) {
  World world = EmptyWorld();
  AddBackground(world, Quad({3.7, -9, -9}, {0, 0, 18}, {0, 18, 0}));
  const Rendering rendering = DrawWorld(world);
  double least = 0.0;
  double greatest = 0.0;
  cv::minMaxLoc(rendering.depth, &least, &greatest);
  EXPECT_NEAR(least, 3.7, 2e-6);
  EXPECT_NEAR(greatest, 3.7, 2e-6);
  EXPECT_EQ(cv::countNonZero(rendering.instances), 0);
}

// The worst case: two triangles that reach from behind the camera to 400 m.
TEST(Depth, OfALongRoadIsExact) {
  World world = EmptyWorld();
  AddBackground(world, Quad({-20, -200, -1.6}, {420, 0, 0}, {0, 400, 0}));
  const Rendering rendering = DrawWorld(world);
  const StereoCamera& rig = world.rig;
  for (int v = 64; v < rig.height_px; ++v) {
    const double expected = 1.6 * rig.fy / (v - rig.cy);
    for (int u = 0; u < rig.width_px; u += 7) {
      const double z = rendering.depth.at<float>(v, u);
      EXPECT_NEAR(rig.fx * rig.baseline_m / z, rig.fx * rig.baseline_m / expected, 2e-3)
          << u << " " << v;
    }
  }
  EXPECT_EQ(rendering.depth.at<float>(30, 80), 0.0F) << "the sky has no depth";
}

TEST(Instances, CoverTheProjectionOfABall) {
  World world = EmptyWorld();
  const double radius = 0.5;
  const Eigen::Vector3d centre(3.0, 0.4, 0.2);
  AddBody(world, Ball(radius), centre);
  const Rendering rendering = DrawWorld(world);
  const StereoCamera& rig = world.rig;
  const Eigen::Vector3d centre_in_left = LookingAlongX().Inverse() * centre;
  // A pixel shows the ball if its ray passes the centre within the radius; rays are about 1/fx
  // wide.
  const double margin = 0.7 * centre_in_left.norm() / rig.fx;
  int inside = 0;
  for (int v = 0; v < rig.height_px; ++v) {
    for (int u = 0; u < rig.width_px; ++u) {
      const Eigen::Vector3d ray((u - rig.cx) / rig.fx, (v - rig.cy) / rig.fy, 1.0);
      const double distance = ray.normalized().cross(centre_in_left).norm();
      const int id = rendering.instances.at<std::uint16_t>(v, u);
      if (distance < radius - margin) {
        EXPECT_EQ(id, 1) << u << " " << v;
      }
      if (distance > radius + margin) {
        EXPECT_EQ(id, 0) << u << " " << v;
      }
      EXPECT_EQ(id == 1, rendering.depth.at<float>(v, u) > 0.0F) << u << " " << v;
      inside += id;
    }
  }
  EXPECT_GT(inside, 1500);
}

TEST(AlonePixels, AreCountedWithoutOccluders) {
  World world = BallsWorld();
  const Rendering both = DrawWorld(world);
  const int front = cv::countNonZero(both.instances == 2);
  const int back = cv::countNonZero(both.instances == 1);
  EXPECT_EQ(both.alone_px[1], front);
  EXPECT_GT(both.alone_px[0], back + 50);
  View without = ViewOf(world);
  without.world_from_body[1] =
      RigidTransform(Eigen::Quaterniond::Identity(), Eigen::Vector3d(-3.0, 0.0, 0.0));
  const Rendering single = Renderer(world, 2).Draw(without);
  EXPECT_EQ(single.alone_px[0], both.alone_px[0]);
  EXPECT_EQ(cv::countNonZero(single.instances == 1), both.alone_px[0]);
  EXPECT_EQ(single.alone_px[1], 0) << "behind the camera";
}

TEST(Bodies, MayOutnumberTheStencilValues) {
  World world = EmptyWorld();
  const Mesh card = Quad({0, -0.2, -0.2}, {0, 0, 0.4}, {0, 0.4, 0});
  for (int i = 0; i < 300; ++i) AddBody(world, card, {2.0 + 0.01 * i, 0.0, 0.0});
  const Rendering rendering = DrawWorld(world);
  for (const int pixels : rendering.alone_px) EXPECT_GT(pixels, 100);
  EXPECT_EQ(cv::countNonZero(rendering.instances == 1), rendering.alone_px[0]);
}

}  // namespace
}  // namespace cvo::synth
