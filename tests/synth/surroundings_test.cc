// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "synth/models/build.h"
#include "synth/models/model.h"
#include "tests/support/error_message.h"

namespace cvo::synth {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using testing::HasSubstr;

Surroundings Room(std::uint64_t seed, const RoomDescription& room = {}) {
  Rng rng(seed, "look");
  return MakeRoom(room, rng);
}

Eigen::AlignedBox3d BoundsOf(const PlacedModel& placed) {
  Eigen::AlignedBox3d box;
  for (const Part& part : placed.model.parts) {
    for (const Vertex& vertex : part.mesh.vertices) {
      box.extend(placed.world_from_model * Vector3d(vertex.position.cast<double>()));
    }
  }
  return box;
}

TEST(MakeRoom, FurnitureStandsAlongTheWallsWithoutOverlap) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const RoomDescription room;
    const Surroundings made = Room(seed);
    ASSERT_EQ(made.placed.size(), 10u);
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const PlacedModel& placed : made.placed) boxes.push_back(BoundsOf(placed));
    const Vector2d free = 0.5 * room.size_m.head<2>() - Vector2d::Constant(room.furniture_depth_m);
    const Eigen::AlignedBox3d middle(Vector3d(-free.x(), -free.y(), 0.0),
                                     Vector3d(free.x(), free.y(), room.size_m.z()));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      EXPECT_NEAR(boxes[i].min().z(), 0.0, 1e-5);
      EXPECT_TRUE(middle.intersection(boxes[i]).isEmpty());
      for (const Eigen::Vector4d& wall : made.walls) {
        for (const Vector3d& corner : {boxes[i].min(), boxes[i].max()}) {
          EXPECT_GT(wall.head<3>().dot(corner) + wall.w(), -1e-5);
        }
      }
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_TRUE(boxes[i].intersection(boxes[k]).isEmpty());
      }
    }
  }
}

TEST(MakeRoom, WallNormalsPointInward) {
  const Surroundings room = Room(1);
  ASSERT_EQ(room.walls.size(), 6u);
  for (const Eigen::Vector4d& wall : room.walls) {
    EXPECT_NEAR(wall.head<3>().norm(), 1.0, 1e-12);
    EXPECT_GT(wall.head<3>().dot(Vector3d(0, 0, 1.3)) + wall.w(), 1.2);
  }
}

TEST(MakeRoom, ShellIsInsideAndCastsNoShadow) {
  const Surroundings room = Room(2);
  for (const Part& part : room.shell) {
    EXPECT_FALSE(part.casts_shadow);
    for (const Vertex& vertex : part.mesh.vertices) {
      EXPECT_LE(std::abs(vertex.position.x()), 2.5f + 1e-5f);
      EXPECT_LE(std::abs(vertex.position.y()), 3.0f + 1e-5f);
    }
  }
}

TEST(MakeRoom, ShellNormalsPointIntoTheRoom) {
  const Surroundings room = Room(2);
  int walls = 0;
  for (const Part& part : room.shell) {
    const std::vector<Vertex>& vertices = part.mesh.vertices;
    const bool flat = std::all_of(vertices.begin(), vertices.end(), [&](const Vertex& vertex) {
      return vertex.normal == vertices[0].normal;
    });
    if (!flat) continue;
    ++walls;
    const Eigen::Vector3f inward = Eigen::Vector3f(0, 0, 1.3f) - vertices[0].position;
    EXPECT_GT(vertices[0].normal.dot(inward), 0.0f);
  }
  EXPECT_GE(walls, 6);
}

TEST(MakeRoom, RoomsAreFixedPerStream) {
  const auto places = [](const Surroundings& room) {
    std::vector<Vector3d> all;
    for (const PlacedModel& placed : room.placed) {
      all.emplace_back(placed.world_from_model.translation());
    }
    return all;
  };
  EXPECT_EQ(places(Room(1)), places(Room(1)));
  EXPECT_NE(places(Room(1)), places(Room(2)));
}

TEST(MakeRoom, RefusesBadRooms) {
  RoomDescription room;
  room.shelves = 40;
  EXPECT_THAT(ErrorMessage([&] { Room(1, room); }),
              HasSubstr("no place along the walls for 40 shelves"));
  room = {};
  room.size_m = {5.0, 0.0, 2.5};
  EXPECT_THAT(ErrorMessage([&] { Room(1, room); }), HasSubstr("room.size_m"));
}

StreetDescription Crossing() {
  StreetDescription street;
  street.roads = {{{{-60, 0}, {40, 0}, {40, 60}}, 8.0, 15.0}, {{{-20, -50}, {-20, 50}}, 7.0, 15.0}};
  return street;
}

Surroundings Street(std::uint64_t seed, const StreetDescription& street = Crossing()) {
  Rng rng(seed, "look");
  return MakeStreet(street, rng);
}

TEST(MakeStreet, NothingStandsOnARoad) {
  const StreetDescription street = Crossing();
  const Surroundings made = Street(1);
  EXPECT_GT(made.placed.size(), 60u);
  for (const RoadDescription& road : street.roads) {
    const std::vector<Vector2d> line = RoundedPolyline(road.points, road.corner_radius_m);
    for (const PlacedModel& placed : made.placed) {
      for (const CollisionShape& shape : placed.model.shapes) {
        for (int corner = 0; corner < 4; ++corner) {
          const Vector3d sign(corner % 2 == 0 ? 1 : -1, corner < 2 ? 1 : -1, -1);
          const Vector3d at = placed.world_from_model *
                              (shape.model_from_shape * shape.half_size_m.cwiseProduct(sign));
          EXPECT_GT(DistanceToPolyline(line, at.head<2>()), 0.5 * road.width_m);
        }
      }
    }
  }
}

TEST(MakeStreet, SharesTexturesAndKeepsPavementsOffRoads) {
  const Surroundings street = Street(2);
  std::set<const unsigned char*> textures;
  for (const Part& part : street.shell) textures.insert(part.texture.data);
  for (const PlacedModel& placed : street.placed) {
    for (const Part& part : placed.model.parts) textures.insert(part.texture.data);
  }
  EXPECT_LE(textures.size(), 40u);
  EXPECT_TRUE(street.walls.empty());
  // The carriageway of the other road has nothing but asphalt, markings and kerbs on it.
  for (const Vertex& vertex : street.shell.at(2).mesh.vertices) {
    const Vector2d p = vertex.position.head<2>().cast<double>();
    EXPECT_GT(std::abs(p.x() + 20.0), 3.5 - 1.01) << p.transpose();
  }
}

TEST(MakeStreet, StreetsAreFixedPerStream) {
  const Surroundings a = Street(1);
  const Surroundings b = Street(1);
  ASSERT_EQ(a.placed.size(), b.placed.size());
  for (std::size_t i = 0; i < a.placed.size(); ++i) {
    EXPECT_EQ(a.placed[i].world_from_model.Matrix(), b.placed[i].world_from_model.Matrix());
  }
  const Surroundings other = Street(2);
  EXPECT_NE(a.placed[0].world_from_model.Matrix(), other.placed[0].world_from_model.Matrix());
}

TEST(MakeStreet, RefusesBadStreets) {
  EXPECT_THAT(ErrorMessage([] { Street(1, {}); }), HasSubstr("street.roads"));
  StreetDescription street = Crossing();
  street.roads[0].points.resize(1);
  EXPECT_THAT(ErrorMessage([&] { Street(1, street); }), HasSubstr("1 points"));
  street = Crossing();
  street.roads[0].corner_radius_m = 1.0;
  EXPECT_THAT(ErrorMessage([&] { Street(1, street); }), HasSubstr("corner_radius_m"));
}

TEST(Polyline, RoundsACornerByAnArc) {
  const std::vector<Vector2d> line = RoundedPolyline({{0, 0}, {20, 0}, {20, 20}}, 5.0);
  EXPECT_EQ(line.front(), Vector2d(0, 0));
  EXPECT_LT((line.back() - Vector2d(20, 20)).norm(), 1e-12);
  const Vector2d centre(15, 5);
  int on_arc = 0;
  for (const Vector2d& p : line) {
    if (p.x() <= 15.0 || p.y() >= 5.0) continue;
    EXPECT_NEAR((p - centre).norm(), 5.0, 1e-9);
    ++on_arc;
  }
  EXPECT_GE(on_arc, 5);
  EXPECT_DOUBLE_EQ(DistanceToPolyline({{0, 0}, {10, 0}}, {3, -4}), 4.0);
}

}  // namespace
}  // namespace cvo::synth
