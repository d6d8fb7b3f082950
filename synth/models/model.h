// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

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

}  // namespace cvo::synth
