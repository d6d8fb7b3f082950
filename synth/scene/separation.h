// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "synth/models/model.h"

namespace cvo::synth {

// Returns the separation of two convex shapes, m. It never exceeds their distance and is positive
// if they are disjoint. If they overlap, it is the negative length of the smallest translation that
// separates them.
double Separation(const CollisionShape& a, const RigidTransform& world_from_a,
                  const CollisionShape& b, const RigidTransform& world_from_b);

// Signed distance, m, from the plane n . p + d = 0 with unit n to the lowest point of a shape along
// n.
double PlaneSeparation(const CollisionShape& shape, const RigidTransform& world_from_model,
                       const Eigen::Vector4d& plane);

// Radius, m, of a sphere around the origin of the model that contains all shapes.
double BoundingRadius_m(const std::vector<CollisionShape>& shapes);

}  // namespace cvo::synth
