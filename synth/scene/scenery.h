// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <tuple>

#include "synth/models/model.h"
#include "synth/scene/world.h"

namespace cvo::synth {

// Adds meshes, textures and drawables to a world. Parts that share an image in memory share a
// texture.
class Scenery {
 public:
  explicit Scenery(World& world) : world_(world) {}

  void AddBody(const Model& model, int body);
  // Merges parts of equal appearance into one mesh per block of ground. There are few draw calls,
  // but blocks out of view can still be culled and near blocks drawn first.
  void AddBackground(const Part& part, const RigidTransform& world_from_part);

 private:
  // Texture, gloss, shadow casting, x and y of the block.
  using Likeness = std::tuple<int, float, bool, int, int>;

  int Texture(const cv::Mat& texture);
  std::size_t MeshFor(const Likeness& likeness);

  World& world_;
  // Indices of textures by the address of their pixels, numbered in the order of the parts.
  std::map<const unsigned char*, int> textures_;
  std::map<Likeness, std::size_t> background_;
};

}  // namespace cvo::synth
