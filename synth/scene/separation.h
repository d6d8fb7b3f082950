// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "synth/models/model.h"

namespace cvo::synth {

// How far apart two convex pieces are, m: never more than the distance, and positive where there is
// one. Negative: the least shift that would part them.
double Separation(const CollisionShape& a, const RigidTransform& world_from_a,
                  const CollisionShape& b, const RigidTransform& world_from_b);

// Signed distance of a piece's lowest point from the plane n . p + d = 0 with unit n, m.
double PlaneSeparation(const CollisionShape& shape, const RigidTransform& world_from_model,
                       const Eigen::Vector4d& plane);

// Of a ball around the origin of the model that holds all pieces, m.
double BoundingRadius_m(const std::vector<CollisionShape>& shapes);

}  // namespace cvo::synth
