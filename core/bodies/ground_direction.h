// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "core/base/rng.h"
#include "core/geometry/rigid_transform.h"

namespace cvo {

// Where down is, for boxes of bodies that stand on the ground (METHOD.md 10.4): the normal of the
// plane that carries many static points and has hardly any below it, averaged over the frames;
// the camera's own y axis where there is none.
class GroundDirection {
 public:
  explicit GroundDirection(std::uint64_t seed) : rng_(seed, "ground") {}

  // Static points that the frame shows, in world.
  void Update(std::span<const Eigen::Vector3d> points, const RigidTransform& world_from_camera);

  // Unit length, in world.
  Eigen::Vector3d Down(const RigidTransform& world_from_camera) const;

 private:
  Rng rng_;
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();  // of normals, weighted by their points
};

}  // namespace cvo
