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

// A thing that others must not enter.
struct Solid {
  std::string name;
  std::vector<CollisionShape> shapes;
  std::shared_ptr<const Motion> motion;  // none: stays where it is, with others of its kind
  RigidTransform world_from_model;       // without motion
};

// From time zero to `duration_s`: no solid in another, none but those without motion beyond a wall
// (inward planes). Touching is allowed. Throws Error at `where` naming the first collision and when
// it is deepest. The same for every number of threads.
void CheckCollisions(const std::vector<Solid>& solids, const std::vector<Eigen::Vector4d>& walls,
                     double duration_s, int threads, const std::string& where);

// Throws Error for a body of which no frame can show anything.
void CheckInView(const World& world, const std::string& where);

}  // namespace cvo::synth
