// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <opencv2/core.hpp>
#include <string>

#include "tests/synth/worlds.h"

namespace cvo::synth {
namespace {

// Returns the sum of squared differences between a window in the left image and the window
// `disparity` pixels further left in the right image.
double Difference(const cv::Mat& left, const cv::Mat& right, int disparity) {
  const cv::Rect window(60, 30, 80, 60);
  return cv::norm(left(window), right(window - cv::Point(disparity, 0)), cv::NORM_L2SQR);
}

TEST(Images, DisparityMatchesTheDepth) {
  World world = EmptyWorld();
  const double depth = 2.5;
  AddBackground(world, Quad({depth, -3, -3}, {0, 0, 6}, {0, 6, 0}));
  const Rendering rendering = Renderer(world).Draw(ViewOf(world));
  const cv::Mat left = LumaOf(rendering.left);
  const cv::Mat right = LumaOf(rendering.right);
  int best = 0;
  for (int d = 0; d <= 40; ++d) {
    if (Difference(left, right, d) < Difference(left, right, best)) best = d;
  }
  const double before = Difference(left, right, best - 1);
  const double at = Difference(left, right, best);
  const double after = Difference(left, right, best + 1);
  const double found = best + 0.5 * (before - after) / (before - 2.0 * at + after);
  EXPECT_NEAR(found, world.rig.fx * world.rig.baseline_m / depth, 0.05);
}

TEST(Images, FourthChannelIsLuma) {
  World world = BallsWorld();
  world.textures[0].setTo(cv::Scalar(200, 100, 40));
  const cv::Mat image = Renderer(world).Draw(ViewOf(world)).left;
  for (int row = 0; row < image.rows; ++row) {
    for (int column = 0; column < image.cols; ++column) {
      const cv::Vec4b p = image.at<cv::Vec4b>(row, column);
      EXPECT_NEAR(p[3], 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2], 1.5);
    }
  }
  EXPECT_EQ(LumaOf(image).at<uchar>(60, 80), image.at<cv::Vec4b>(60, 80)[3]);
  const cv::Vec3b bgr = ColourOf(image).at<cv::Vec3b>(60, 80);
  EXPECT_EQ(bgr[0], image.at<cv::Vec4b>(60, 80)[2]);
  EXPECT_EQ(bgr[2], image.at<cv::Vec4b>(60, 80)[0]);
  EXPECT_GT(bgr[2], bgr[0]) << "red light textures are red";
}

// A card above the camera and a floor below it, lit vertically from above.
class Shadow : public testing::Test {
 protected:
  Shadow() : world_(EmptyWorld()) {
    world_.textures[0].setTo(cv::Scalar::all(180));
    world_.light.direction = {0.0, 0.0, -1.0};
    AddBackground(world_, Quad({0, -5, -1}, {8, 0, 0}, {0, 10, 0}));
    AddBackground(world_, Quad({2.5, -0.5, 1.5}, {1, 0, 0}, {0, 1, 0}));
  }
  cv::Mat Draw(bool casts_shadow) {
    world_.drawables[1].casts_shadow = casts_shadow;
    return LumaOf(Renderer(world_).Draw(ViewOf(world_)).left);
  }
  World world_;
};

TEST_F(Shadow, FallsExactlyWhereTheLightIsBlocked) {
  const cv::Mat with = Draw(true);
  const cv::Mat without = Draw(false);
  const StereoCamera& rig = world_.rig;
  const double edge = 3.0 * 2.0 * world_.light.shadow_range_m / 2048;
  int dark = 0;
  for (int v = 70; v < rig.height_px; ++v) {
    for (int u = 0; u < rig.width_px; ++u) {
      const double x = rig.fy / (v - rig.cy);  // of the point on the floor
      const double y = -(u - rig.cx) / rig.fx * x;
      const double inside = std::min(0.5 - std::abs(x - 3.0), 0.5 - std::abs(y));
      const double pixel = 1.5 * x * x / rig.fy;
      const int darker = without.at<uchar>(v, u) - with.at<uchar>(v, u);
      if (inside > edge + pixel) {
        EXPECT_GT(darker, 60) << u << " " << v;
      }
      if (inside < -edge - pixel) {
        EXPECT_EQ(darker, 0) << u << " " << v;
      }
      dark += darker > 60 ? 1 : 0;
    }
  }
  EXPECT_GT(dark, 500);
}

TEST_F(Shadow, NoSurfaceShadowsItself) {
  world_.light.direction = {0.8, 0.3, -0.5};
  world_.drawables.pop_back();
  AddBody(world_, Ball(0.5), {3.0, 0.0, -0.5});
  const cv::Mat with = LumaOf(Renderer(world_).Draw(ViewOf(world_)).left);
  for (Drawable& drawable : world_.drawables) drawable.casts_shadow = false;
  const Rendering bare = Renderer(world_).Draw(ViewOf(world_));
  cv::Mat darker;
  cv::subtract(LumaOf(bare.left), with, darker);
  darker.setTo(0, bare.instances == 0);
  EXPECT_LT(cv::countNonZero(darker > 6), 12) << "of the ball's pixels";
}

Rendering DrawWorld(const World& world) { return Renderer(world).Draw(ViewOf(world)); }

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
  const Rendering single = Renderer(world).Draw(without);
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

bool SameBytes(const cv::Mat& a, const cv::Mat& b) {
  return a.type() == b.type() && a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}

void ExpectSame(const Rendering& a, const Rendering& b) {
  EXPECT_TRUE(SameBytes(a.left, b.left));
  EXPECT_TRUE(SameBytes(a.right, b.right));
  EXPECT_TRUE(SameBytes(a.depth, b.depth));
  EXPECT_TRUE(SameBytes(a.instances, b.instances));
  EXPECT_EQ(a.alone_px, b.alone_px);
}

TEST(Determinism, RenderersDoNotDisturbEachOther) {
  const World balls = BallsWorld();
  World wall = EmptyWorld();
  wall.rig.width_px = 96;
  AddBackground(wall, Quad({2, -5, -3}, {0, 0, 6}, {0, 10, 0}));
  Renderer balls_renderer(balls);
  const Rendering alone = balls_renderer.Draw(ViewOf(balls));
  Renderer wall_renderer(wall);
  EXPECT_EQ(wall_renderer.Draw(ViewOf(wall)).left.cols, 96);
  ExpectSame(alone, balls_renderer.Draw(ViewOf(balls)));
  { Renderer ended(wall); }
  ExpectSame(alone, balls_renderer.Draw(ViewOf(balls)));
}

TEST(Determinism, ImagesAloneMatchTheFullRendering) {
  const World world = BallsWorld();
  Renderer renderer(world);
  cv::Mat left;
  cv::Mat right;
  renderer.DrawImages(ViewOf(world), left, right);
  const Rendering whole = renderer.Draw(ViewOf(world));
  EXPECT_TRUE(SameBytes(left, whole.left));
  EXPECT_TRUE(SameBytes(right, whole.right));
}

// A rasteriser thread of Mesa may write to a fence that is freed (gl.cc).
TEST(Renderer, StartsNoRasteriserThreads) {
  DrawWorld(BallsWorld());
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::string name;
    std::getline(std::ifstream(task.path() / "comm"), name);
    EXPECT_THAT(name, Not(testing::StartsWith("llvmpipe")));
  }
}

TEST(RendererVersion, NamesMesaAndVectorWidth) {
  const RendererVersion version = FindRendererVersion();
  EXPECT_THAT(version.gl, testing::HasSubstr("Mesa"));
  EXPECT_THAT(version.renderer, testing::HasSubstr("256 bits"));
}

}  // namespace
}  // namespace cvo::synth
