// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace cvo::synth {

struct Vertex {
  Eigen::Vector3f position;  // m, in the body's frame (background: in world)
  Eigen::Vector3f normal;    // unit length, outward
  Eigen::Vector2f uv;        // texture coordinates; textures repeat
};

// Triangles as triples of vertex indices, in any order around them.
struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
  bool two_sided = true;  // false: not drawn where its normals point away from the viewer
};

}  // namespace cvo::synth
