// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "synth/models/model.h"
#include "synth/scene/world.h"

namespace cvo::synth {

// A solid object that other solids must not penetrate.
struct Solid {
  std::string name;
  std::vector<CollisionShape> shapes;
  std::shared_ptr<const Motion> motion;  // null: static; static solids may overlap each other
  RigidTransform world_from_model;       // pose if `motion` is null
};

// Checks from time zero to `duration_s` that no solid penetrates another and that no moving solid
// crosses a wall (planes with inward normals). Touching is allowed. Throws Error at `where` that
// names the first collision and the time at which it is deepest. The result does not depend on the
// number of threads.
void CheckCollisions(const std::vector<Solid>& solids, const std::vector<Eigen::Vector4d>& walls,
                     double duration_s, int threads, const std::string& where);

// Throws Error for a body whose bounding sphere is outside the left camera's view in every frame.
void CheckInView(const World& world, const std::string& where);

}  // namespace cvo::synth
