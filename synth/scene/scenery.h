// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <tuple>

#include "synth/models/model.h"
#include "synth/scene/world.h"

namespace cvo::synth {

// Collects in a world what is drawn; the same picture in memory becomes the same texture.
class Scenery {
 public:
  explicit Scenery(World& world) : world_(world) {}

  void AddBody(const Model& model, int body);
  // What is drawn alike becomes one mesh in each block of ground: few calls, and yet what is out of
  // sight can be left out and what is near drawn first.
  void AddBackground(const Part& part, const RigidTransform& world_from_part);

 private:
  // Texture, gloss, shadow, block.
  using Likeness = std::tuple<int, float, bool, int, int>;

  int Texture(const cv::Mat& texture);
  std::size_t MeshFor(const Likeness& likeness);

  World& world_;
  // Found by address, numbered in the order of the parts.
  std::map<const unsigned char*, int> textures_;
  std::map<Likeness, std::size_t> background_;
};

}  // namespace cvo::synth
