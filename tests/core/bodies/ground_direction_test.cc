// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/bodies/ground_direction.h"

#include <gtest/gtest.h>

#include <vector>

namespace cvo::ground_direction_test {
namespace {

using Eigen::Vector3d;

// A room, seen by a camera 1.2 m above the floor that is tilted down by 0.3 rad. The world frame is
// the camera frame.
struct Room {
  RigidTransform level_from_camera{ExpSo3({-0.3, 0.0, 0.0}), Vector3d(0.0, -1.2, 0.0)};
  Rng rng{1, "room"};
  std::vector<Vector3d> points;

  void Add(int count, const Vector3d& low, const Vector3d& high) {
    for (int i = 0; i < count; ++i) {
      const Vector3d p(rng.Uniform(low.x(), high.x()), rng.Uniform(low.y(), high.y()),
                       rng.Uniform(low.z(), high.z()));
      points.push_back(level_from_camera.Inverse() * p);
    }
  }
  Vector3d Down() const { return level_from_camera.Inverse().rotation() * Vector3d::UnitY(); }
};

TEST(GroundDirection, IsTheNormalOfTheFloorNotOfATable) {
  Room room;
  room.Add(80, {-2.0, -0.005, 2.0}, {2.0, 0.005, 5.0});  // floor
  room.Add(120, {-1.0, -0.75, 2.5}, {1.0, -0.74, 3.5});  // table
  room.Add(150, {-2.5, -2.5, 5.0}, {2.5, 0.0, 5.2});     // wall
  GroundDirection ground(0);
  for (int i = 0; i < 3; ++i) ground.Update(room.points, {});
  EXPECT_GT(ground.Down({}).dot(room.Down()), 0.9998);  // 1 degree
}

TEST(GroundDirection, IsTheCamerasIfNoFloorIsVisible) {
  Room room;
  room.Add(150, {-2.5, -2.5, 5.0}, {2.5, 0.0, 5.2});  // wall
  GroundDirection ground(0);
  const RigidTransform world_from_camera(ExpSo3({0.1, 0.2, 0.0}), Vector3d::Zero());
  EXPECT_EQ(ground.Down(world_from_camera), world_from_camera.rotation() * Vector3d::UnitY());
  ground.Update(room.points, {});
  EXPECT_EQ(ground.Down({}), Vector3d::UnitY());
}

}  // namespace
}  // namespace cvo::ground_direction_test
