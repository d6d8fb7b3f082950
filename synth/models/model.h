// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "core/base/rng.h"
#include "core/geometry/rigid_transform.h"

namespace cvo::synth {

struct Vertex {
  Eigen::Vector3f position;  // m, in the body's frame (background: in world)
  Eigen::Vector3f normal;    // unit length, outward
  Eigen::Vector2f uv;        // texture coordinates; textures repeat
};

// Triangles as triples of vertex indices, in either winding order.
struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
  bool two_sided = true;  // false: faces whose normals point away from the viewer are not drawn
};

// A mesh with its texture.
struct Part {
  Mesh mesh;        // in the model's frame
  cv::Mat texture;  // CV_8UC3, RGB, sides are powers of two; parts may share one
  float gloss = 0;  // 0 ... 1
  bool casts_shadow = true;
};

// A convex part of the collision shape: a sphere if radius_m > 0, otherwise a box.
struct CollisionShape {
  RigidTransform model_from_shape;
  Eigen::Vector3d half_size_m = Eigen::Vector3d::Zero();
  double radius_m = 0.0;
};

// The model frame has x forward, y left, z up and its origin at the centre of the box that contains
// all parts.
struct Model {
  std::vector<Part> parts;
  std::vector<CollisionShape> shapes;
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();  // of that box
};

// A static model.
struct PlacedModel {
  Model model;
  RigidTransform world_from_model;
};

struct ModelDescription {
  std::string kind;  // one of ModelKinds()
  // Size of its box along x, y, z; zero for the usual size of the model. For a ball, all three are
  // the diameter.
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();
  std::string material;  // one of MaterialNames(); empty: the usual one of the model
};

// "ball", "block", "car", "chair", "crate", "shelf", "table", "tower", ...
const std::vector<std::string>& ModelKinds();
const std::vector<std::string>& MaterialNames();

// Makes a model. `look` varies textures and small parts: a different stream gives a different model
// of the same kind and size. Throws Error for an unknown kind or material, and for a ball
// that is not round.
Model MakeModel(const ModelDescription& description, Rng& look);

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
