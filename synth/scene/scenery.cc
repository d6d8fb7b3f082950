// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/scene/scenery.h"

#include <cmath>

namespace cvo::synth {
namespace {

constexpr float kBlock_m = 24.0F;  // a room usually fits into the block around the origin

struct Block {
  int x;
  int y;
};

Block BlockAround(const Eigen::Vector3f& point) {
  const auto index = [](float v) { return static_cast<int>(std::floor(v / kBlock_m + 0.5F)); };
  return {index(point.x()), index(point.y())};
}

}  // namespace

void Scenery::AddBody(const Model& model, int body) {
  for (const Part& part : model.parts) {
    world_.drawables.push_back({static_cast<int>(world_.meshes.size()), Texture(part.texture), body,
                                part.gloss, part.casts_shadow});
    world_.meshes.push_back(part.mesh);
  }
}

void Scenery::AddBackground(const Part& part, const RigidTransform& world_from_part) {
  const int texture = Texture(part.texture);
  const Eigen::Matrix3f rotation = world_from_part.RotationMatrix().cast<float>();
  const Eigen::Vector3f translation = world_from_part.translation().cast<float>();
  std::vector<Vertex> vertices;
  for (const Vertex& v : part.mesh.vertices) {
    vertices.push_back({rotation * v.position + translation, rotation * v.normal, v.uv});
  }
  // Index of each vertex in the mesh of each block.
  std::map<std::pair<std::size_t, std::uint32_t>, std::uint32_t> moved;
  const std::vector<std::uint32_t>& indices = part.mesh.indices;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const Eigen::Vector3f middle =
        (vertices[indices[i]].position + vertices[indices[i + 1]].position +
         vertices[indices[i + 2]].position) /
        3.0F;
    const Block block = BlockAround(middle);
    const std::size_t number = MeshFor({texture, part.gloss, part.casts_shadow, block.x, block.y});
    Mesh& mesh = world_.meshes[number];
    for (std::size_t k = i; k < i + 3; ++k) {
      const auto [at, is_new] =
          moved.try_emplace({number, indices[k]}, static_cast<std::uint32_t>(mesh.vertices.size()));
      if (is_new) mesh.vertices.push_back(vertices[indices[k]]);
      mesh.indices.push_back(at->second);
    }
  }
}

int Scenery::Texture(const cv::Mat& texture) {
  const auto [known, is_new] =
      textures_.try_emplace(texture.data, static_cast<int>(world_.textures.size()));
  if (is_new) world_.textures.push_back(texture);
  return known->second;
}

std::size_t Scenery::MeshFor(const Likeness& likeness) {
  const auto [merged, is_new] = background_.try_emplace(likeness, world_.meshes.size());
  if (is_new) {
    const auto& [texture, gloss, casts_shadow, x, y] = likeness;
    world_.drawables.push_back({static_cast<int>(merged->second), texture, 0, gloss, casts_shadow});
    world_.meshes.emplace_back();
    world_.meshes.back().two_sided = false;  // never seen from behind
  }
  return merged->second;
}

}  // namespace cvo::synth
