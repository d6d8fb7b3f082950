// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/truth/truth.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <opencv2/core.hpp>

#include "tests/synth/worlds.h"

namespace cvo::synth {
namespace {

TEST(ComputeTruth, VisibleBoxEndsAtTheOuterPixelsOfTheMask) {
  const World world = OneBoxWorld();
  Rendering rendering = EmptyRendering(world);
  rendering.instances(cv::Rect(20, 30, 5, 4)).setTo(1);
  rendering.instances.at<std::uint16_t>(40, 22) = 1;
  rendering.alone_px = {84};
  const BodyTruth body = ComputeTruth(world, 0, rendering).bodies.at(0);
  EXPECT_EQ(body.visible_px, 21);
  EXPECT_DOUBLE_EQ(body.visible_fraction, 0.25);
  ASSERT_TRUE(body.visible_box);
  EXPECT_EQ(body.visible_box->left_px, 20);
  EXPECT_EQ(body.visible_box->right_px, 24);
  EXPECT_EQ(body.visible_box->top_px, 30);
  EXPECT_EQ(body.visible_box->bottom_px, 40);
}

TEST(ComputeTruth, HiddenBodyHasNoVisibleBox) {
  const World world = OneBoxWorld();
  const BodyTruth body = ComputeTruth(world, 0, EmptyRendering(world)).bodies.at(0);
  EXPECT_FALSE(body.visible_box);
  EXPECT_EQ(body.visible_fraction, 0.0);
  EXPECT_TRUE(body.amodal_box);
}

// Front face at 4 m: half width 1 m is 25 px, half height 0.75 m is 18.75 px.
TEST(ComputeTruth, AmodalBoxIsTheProjectionOfTheMesh) {
  const World world = OneBoxWorld();
  const BodyTruth body = ComputeTruth(world, 0, EmptyRendering(world)).bodies.at(0);
  ASSERT_TRUE(body.amodal_box);
  EXPECT_NEAR(body.amodal_box->left_px, 24.5, 1e-9);
  EXPECT_NEAR(body.amodal_box->right_px, 74.5, 1e-9);
  EXPECT_NEAR(body.amodal_box->top_px, 20.75, 1e-9);
  EXPECT_NEAR(body.amodal_box->bottom_px, 58.25, 1e-9);
  EXPECT_NEAR(body.truncation, 0.0, 1e-12);
}

// 2 m further left the front face spans -25.5 px to 24.5 px; the image begins at 0.
TEST(ComputeTruth, TruncationIsThePartOutsideTheImage) {
  const World world = OneBoxWorld({4.5, 2.0, 0.0});
  const BodyTruth body = ComputeTruth(world, 0, EmptyRendering(world)).bodies.at(0);
  ASSERT_TRUE(body.amodal_box);
  EXPECT_EQ(body.amodal_box->left_px, 0.0);
  const double right = 49.5 - 100.0 / 5.0;  // right side of the back face, at 5 m
  EXPECT_NEAR(body.amodal_box->right_px, right, 1e-9);
  EXPECT_NEAR(body.truncation, 25.5 / (25.5 + right), 1e-9);
}

TEST(ComputeTruth, BodyBehindTheCameraHasNoAmodalBox) {
  const World world = OneBoxWorld({-4.0, 0.0, 0.0});
  const BodyTruth body = ComputeTruth(world, 0, EmptyRendering(world)).bodies.at(0);
  EXPECT_FALSE(body.amodal_box);
  EXPECT_EQ(body.truncation, 1.0);
  EXPECT_EQ(FormatLabels(world, ComputeTruth(world, 0, EmptyRendering(world)), 0), "");
}

// The corner of the triangle behind the camera must not be projected; the intersections of its
// sides with the near plane must.
TEST(ProjectedBox, ClipsTrianglesAtTheNearPlane) {
  StereoCamera rig = OneBoxWorld().rig;
  Mesh mesh;
  for (const Eigen::Vector3f& p :
       {Eigen::Vector3f(0, 0, 2), Eigen::Vector3f(0.2F, 0, 2), Eigen::Vector3f(1, 0, -1)}) {
    mesh.vertices.push_back({p, Eigen::Vector3f::UnitX(), Eigen::Vector2f::Zero()});
  }
  mesh.indices = {0, 1, 2};
  ProjectedBox projection(rig);
  projection.Add(mesh, RigidTransform());
  ASSERT_TRUE(projection.box());
  EXPECT_NEAR(projection.box()->left_px, 49.5, 1e-9);
  // On the side from (0.2, 0, 2) to (1, 0, -1), z = 0.05 at 1.95 / 3 of the way.
  EXPECT_NEAR(projection.box()->right_px, 49.5 + 100.0 * (0.2 + 0.8 * 0.65) / 0.05, 1e-3);
}

TEST(FormatLabels, MatchesAHandComputedRow) {
  const World world = OneBoxWorld();
  Rendering rendering = EmptyRendering(world);
  rendering.instances(cv::Rect(40, 30, 10, 10)).setTo(1);
  rendering.alone_px = {200};
  // The centre of the bottom is 4.5 m ahead and 0.75 m below. The body faces along the camera's z
  // axis, which is a rotation by -90 degrees about its y axis.
  EXPECT_EQ(FormatLabels(world, ComputeTruth(world, 0, rendering), 7),
            "7 1 Block 0.000000 1 -1.570796 24.500000 20.750000 74.500000 58.250000 1.500000 "
            "2.000000 1.000000 0.000000 0.750000 4.500000 -1.570796\n");
}

TEST(FormatLabels, OcclusionFollowsTheVisibleFraction) {
  const World world = OneBoxWorld();
  const auto occlusion = [&](int visible_px) {
    Rendering rendering = EmptyRendering(world);
    if (visible_px > 0) rendering.instances(cv::Rect(0, 0, visible_px, 1)).setTo(1);
    rendering.alone_px = {100};
    const std::string row = FormatLabels(world, ComputeTruth(world, 0, rendering), 0);
    return row.substr(std::string("0 1 Block 0.000000 ").size(), 1);
  };
  EXPECT_EQ(occlusion(80), "0");
  EXPECT_EQ(occlusion(79), "1");
  EXPECT_EQ(occlusion(30), "1");
  EXPECT_EQ(occlusion(29), "2");
  EXPECT_EQ(occlusion(0), "3");
}

TEST(FormatKittiCalibration, RightCameraHasTheBaseline) {
  const std::string text = FormatKittiCalibration(OneBoxWorld().rig);
  EXPECT_THAT(text, testing::StartsWith("P0: 100 0 49.5 0 0 100 39.5 0 0 0 1 0\n"
                                        "P1: 100 0 49.5 -20 0 100 39.5 0 0 0 1 0\n"
                                        "P2: 100 0 49.5 0 "));
}

}  // namespace
}  // namespace cvo::synth
