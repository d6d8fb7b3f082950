// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <opencv2/core.hpp>

#include "tests/synth/render/worlds.h"

namespace cvo::synth {
namespace {

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

std::uint64_t Fingerprint(const Rendering& rendering) {
  std::uint64_t hash = 14695981039346656037U;  // FNV-1a
  for (const cv::Mat& image :
       {rendering.left, rendering.right, rendering.depth, rendering.instances}) {
    for (std::size_t i = 0; i < image.total() * image.elemSize(); ++i) {
      hash = (hash ^ image.data[i]) * 1099511628211U;
    }
  }
  return hash;
}

// Exits with a hash of a rendering. To be called in a new process, since the first renderer of a
// process fixes its number of threads.
void ExitWithHash(int threads) {
  const World world = BallsWorld();
  const std::uint64_t hash = Fingerprint(Renderer(world, threads).Draw(ViewOf(world)));
  std::_Exit(static_cast<int>(hash % 251));
}

TEST(Determinism, SameBytesTwice) {
  const World world = BallsWorld();
  Renderer renderer(world, 2);
  const Rendering first = renderer.Draw(ViewOf(world));
  View aside = ViewOf(world);
  aside.world_from_body[0] =
      RigidTransform(Eigen::Quaterniond::Identity(), Eigen::Vector3d(2.0, 0.5, 0.0));
  const Rendering other = renderer.Draw(aside);
  EXPECT_FALSE(SameBytes(first.left, other.left));
  ExpectSame(first, renderer.Draw(ViewOf(world)));
}

TEST(Determinism, RenderersDoNotDisturbEachOther) {
  const World balls = BallsWorld();
  World wall = EmptyWorld();
  wall.rig.width_px = 96;
  AddBackground(wall, Quad({2, -5, -3}, {0, 0, 6}, {0, 10, 0}));
  Renderer balls_renderer(balls, 2);
  const Rendering alone = balls_renderer.Draw(ViewOf(balls));
  Renderer wall_renderer(wall, 2);
  EXPECT_EQ(wall_renderer.Draw(ViewOf(wall)).left.cols, 96);
  ExpectSame(alone, balls_renderer.Draw(ViewOf(balls)));
  { Renderer ended(wall, 2); }
  ExpectSame(alone, balls_renderer.Draw(ViewOf(balls)));
}

TEST(Determinism, ImagesAloneMatchTheFullRendering) {
  const World world = BallsWorld();
  Renderer renderer(world, 2);
  cv::Mat left;
  cv::Mat right;
  renderer.DrawImages(ViewOf(world), left, right);
  const Rendering whole = renderer.Draw(ViewOf(world));
  EXPECT_TRUE(SameBytes(left, whole.left));
  EXPECT_TRUE(SameBytes(right, whole.right));
}

TEST(DeterminismDeathTest, SameBytesWithAnyNumberOfThreads) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const World world = BallsWorld();
  const int expected = static_cast<int>(Fingerprint(Renderer(world, 2).Draw(ViewOf(world))) % 251);
  unsetenv("LP_NUM_THREADS");
  for (int threads : {1, 3, 4}) {
    EXPECT_EXIT(ExitWithHash(threads), testing::ExitedWithCode(expected), "");
  }
}

TEST(RendererVersion, NamesMesaAndVectorWidth) {
  const RendererVersion version = FindRendererVersion();
  EXPECT_THAT(version.gl, testing::HasSubstr("Mesa"));
  EXPECT_THAT(version.renderer, testing::HasSubstr("256 bits"));
}

}  // namespace
}  // namespace cvo::synth
