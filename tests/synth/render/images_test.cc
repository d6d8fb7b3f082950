// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/core.hpp>

#include "tests/synth/render/worlds.h"

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
  const Rendering rendering = Renderer(world, 2).Draw(ViewOf(world));
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
  const cv::Mat image = Renderer(world, 2).Draw(ViewOf(world)).left;
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
    return LumaOf(Renderer(world_, 2).Draw(ViewOf(world_)).left);
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
  const cv::Mat with = LumaOf(Renderer(world_, 2).Draw(ViewOf(world_)).left);
  for (Drawable& drawable : world_.drawables) drawable.casts_shadow = false;
  const Rendering bare = Renderer(world_, 2).Draw(ViewOf(world_));
  cv::Mat darker;
  cv::subtract(LumaOf(bare.left), with, darker);
  darker.setTo(0, bare.instances == 0);
  EXPECT_LT(cv::countNonZero(darker > 6), 12) << "of the ball's pixels";
}

TEST(Mesh, OneSidedIsNotDrawnFromBehind) {
  World world = EmptyWorld();
  AddBackground(world, Quad({3, -5, -5}, {0, 0, 10}, {0, 10, 0}));  // normal towards the camera
  std::reverse(world.meshes[0].indices.begin(), world.meshes[0].indices.end());
  const auto covered = [&] {
    return cv::countNonZero(Renderer(world, 2).Draw(ViewOf(world)).depth);
  };
  EXPECT_EQ(covered(), 160 * 120);
  world.meshes[0].two_sided = false;
  EXPECT_EQ(covered(), 160 * 120);
  for (Vertex& vertex : world.meshes[0].vertices) vertex.normal = -vertex.normal;
  EXPECT_EQ(covered(), 0);
  world.meshes[0].two_sided = true;
  EXPECT_EQ(covered(), 160 * 120);
}

TEST(Light, ReachesBothSidesOfASurface) {
  World world = EmptyWorld();
  world.textures[0].setTo(cv::Scalar::all(150));
  world.light.direction = {1.0, 0.0, 0.0};
  AddBackground(world, Quad({3, -5, -5}, {0, 0, 10}, {0, 10, 0}));
  const cv::Mat front = LumaOf(Renderer(world, 2).Draw(ViewOf(world)).left);
  for (Vertex& vertex : world.meshes[0].vertices) vertex.normal = -vertex.normal;
  const cv::Mat back = LumaOf(Renderer(world, 2).Draw(ViewOf(world)).left);
  EXPECT_EQ(cv::norm(front, back, cv::NORM_INF), 0.0);
  EXPECT_NEAR(cv::mean(front)[0], 150 * (0.65 + 0.62 * 5.0 / 6.0), 2.0);
}

}  // namespace
}  // namespace cvo::synth
