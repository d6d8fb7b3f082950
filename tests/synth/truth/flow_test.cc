// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/truth/flow.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "tests/synth/write/test_scene.h"

namespace cvo::synth {
namespace {

using test::EmptyRendering;
using test::OneBoxWorld;

// A fronto-parallel wall 2 m ahead, part of body 1; the camera is at the world origin.
struct WallScene {
  WallScene() : rig(OneBoxWorld().rig), rendering(EmptyRendering(OneBoxWorld())) {
    rendering.depth.setTo(2.0);
    rendering.instances.setTo(1);
    now.world_from_body.resize(1);
    next = now;
  }

  double U(int v, int u) const { return (Code(v, u)[2] - 32768.0) / 64.0; }
  double V(int v, int u) const { return (Code(v, u)[1] - 32768.0) / 64.0; }
  bool Valid(int v, int u) const { return Code(v, u)[0] == 1; }
  cv::Vec3w Code(int v, int u) const {
    return ComputeFlow(rig, rendering, now, next).at<cv::Vec3w>(v, u);
  }

  StereoCamera rig;
  Rendering rendering;
  View now;
  View next;
};

RigidTransform Shift(double x, double y, double z) {
  return {Eigen::Quaterniond::Identity(), Eigen::Vector3d(x, y, z)};
}

TEST(ComputeFlow, TranslatingPlane) {
  WallScene scene;
  scene.next.world_from_body[0] = Shift(0.1, -0.04, 0.0);
  EXPECT_EQ(scene.U(10, 20), 5.0);  // 100 * 0.1 / 2
  EXPECT_EQ(scene.V(10, 20), -2.0);
  EXPECT_TRUE(scene.Valid(10, 20));
}

TEST(ComputeFlow, CameraMotionCausesOppositeFlow) {
  WallScene scene;
  scene.next.world_from_left = Shift(0.1, 0.0, 0.0);
  EXPECT_EQ(scene.U(40, 50), -5.0);
  scene.rendering.instances.setTo(0);
  EXPECT_EQ(scene.U(40, 50), -5.0);
}

// At half the distance everything is twice as far from the principal point.
TEST(ComputeFlow, ApproachingPlaneExpands) {
  WallScene scene;
  scene.next.world_from_body[0] = Shift(0.0, 0.0, -1.0);
  EXPECT_EQ(scene.U(40, 60), 10.5);
  EXPECT_EQ(scene.V(30, 60), -9.5);
}

TEST(ComputeFlow, InvalidWithoutSurface) {
  WallScene scene;
  scene.rendering.depth.at<float>(5, 6) = 0.0F;
  EXPECT_EQ(scene.Code(5, 6), cv::Vec3w(0, 0, 0));
}

TEST(ComputeFlow, ValidOutsideTheImageUpTo512Pixels) {
  WallScene scene;
  scene.next.world_from_body[0] = Shift(10.0, 0.0, 0.0);  // 500 px
  EXPECT_TRUE(scene.Valid(40, 90));
  EXPECT_EQ(scene.U(40, 90), 500.0);
  scene.next.world_from_body[0] = Shift(10.3, 0.0, 0.0);
  EXPECT_FALSE(scene.Valid(40, 90));
  scene.next.world_from_body[0] = Shift(0.0, 0.0, -3.0);  // behind the camera
  EXPECT_FALSE(scene.Valid(40, 90));
}

}  // namespace
}  // namespace cvo::synth
