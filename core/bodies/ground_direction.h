// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "core/base/rng.h"
#include "core/geometry/rigid_transform.h"

namespace cvo {

// Estimates which way is down, for boxes of bodies that stand on the ground (METHOD.md 10.4): the
// normal of the plane that carries many static points and has hardly any below it, averaged over
// the frames; the camera's own y axis if there is no such plane.
class GroundDirection {
 public:
  explicit GroundDirection(std::uint64_t seed) : rng_(seed, "ground") {}

  // Adds a frame, with the static points that it shows, in world.
  void Update(std::span<const Eigen::Vector3d> points, const RigidTransform& world_from_camera);

  // Returns the unit vector that points down, in world.
  Eigen::Vector3d Down(const RigidTransform& world_from_camera) const;

 private:
  Rng rng_;
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();  // of normals, weighted by their number of points
};

}  // namespace cvo
