// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/family/placement.h"

#include <gtest/gtest.h>

#include "tests/synth/write/test_scene.h"

namespace cvo::synth {
namespace {

using Eigen::Vector3d;

// The camera looks along x, between walls 5 m to its left and right.
class PlacementTest : public testing::Test {
 protected:
  bool TryAdd(const Vector3d& at, double side_m, const Vector3d& velocity = Vector3d::Zero()) {
    CollisionShape shape;
    shape.half_size_m = Vector3d::Constant(0.5 * side_m);
    const RigidTransform pose(Eigen::Quaterniond::Identity(), at);
    return placed_.TryAdd(shape, test::StraightMotion(pose, velocity), 0.5);
  }

  test::StraightMotion camera_{test::WorldFromForwardCamera(), Vector3d::Zero()};
  Placement placed_{StereoCamera{450.0, 450.0, 319.5, 239.5, 0.12, 640, 480}, camera_, 2.0,
                    PlacementLimits{0.1, 0.6, 20.0, {{0, 1, 0, 5}, {0, -1, 0, 5}}}};
};

TEST_F(PlacementTest, RefusesBodiesNearAnother) {
  EXPECT_TRUE(TryAdd({4, 0, 0}, 0.5));
  EXPECT_FALSE(TryAdd({4, 0.55, 0}, 0.5));
  EXPECT_TRUE(TryAdd({4, 0.65, 0}, 0.5));
  // Starts apart, but passes through the others.
  EXPECT_FALSE(TryAdd({4, -1.5, 0}, 0.5, {0, 1, 0}));
  EXPECT_EQ(placed_.bodies().size(), 2u);
}

TEST_F(PlacementTest, RefusesBodiesNearTheCameraOrAWall) {
  EXPECT_FALSE(TryAdd({0.9, 0, 0}, 0.5));
  EXPECT_TRUE(TryAdd({10, 4.6, 0}, 0.5));
  EXPECT_FALSE(TryAdd({10, -4.6, 0}, 0.5, {0, -1, 0}));
}

TEST_F(PlacementTest, RefusesBodiesMostlyOutOfView) {
  EXPECT_FALSE(TryAdd({-4, 0, 0}, 0.5));
  EXPECT_FALSE(TryAdd({4, 4, 0}, 0.5));
  EXPECT_FALSE(TryAdd({25, 0, 0}, 0.5));
  EXPECT_TRUE(TryAdd({4, 2, 0}, 0.5, {0, 0.5, 0}));
}

TEST_F(PlacementTest, RefusesOccludedAndOccludingBodies) {
  EXPECT_TRUE(TryAdd({4, 0, 0}, 0.6));
  EXPECT_FALSE(TryAdd({6, 0, 0}, 0.3));             // behind it
  EXPECT_FALSE(TryAdd({2, 0, 0}, 0.6));             // in front of it
  EXPECT_TRUE(TryAdd({2, -1, 0}, 0.3, {0, 1, 0}));  // only in passing
}

}  // namespace
}  // namespace cvo::synth
