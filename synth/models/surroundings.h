// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/rng.h"
#include "synth/models/model.h"

namespace cvo::synth {

// A room with four walls, floor and ceiling: x and y from -size/2 to size/2, z from 0 to its
// height. Furniture stands along the walls, within `furniture_depth_m` of them; the middle is free.
struct RoomDescription {
  Eigen::Vector3d size_m = {5.0, 6.0, 2.6};
  int shelves = 4;
  int tables = 2;
  int crates = 4;
  int posters = 14;  // flat, on the walls
  double furniture_depth_m = 0.55;
};

// A road along RoundedPolyline(points, corner_radius_m) of polyline.h, in the plane z = 0.
struct RoadDescription {
  std::vector<Eigen::Vector2d> points;
  double width_m = 8.0;
  double corner_radius_m = 15.0;  // of its centre line; less if the legs are short
};

// Roads with pavements, buildings and trees on both sides, none of which stands on a road.
struct StreetDescription {
  std::vector<RoadDescription> roads;
  double pavement_m = 3.0;
  double building_height_m = 10.0;  // on average
  double trees_per_100m = 5.0;      // on each side
};

struct Surroundings {
  std::vector<Part> shell;             // in world; not part of collision checks (see walls)
  std::vector<PlacedModel> placed;     // furniture, buildings, trees: bodies must not enter them
  std::vector<Eigen::Vector4d> walls;  // planes with inward normals: n . p + d >= 0 inside
};

// `look` determines where things stand and how they look. Throws Error for a description that
// cannot be built.
Surroundings MakeRoom(const RoomDescription& room, Rng& look);
Surroundings MakeStreet(const StreetDescription& street, Rng& look);

}  // namespace cvo::synth
