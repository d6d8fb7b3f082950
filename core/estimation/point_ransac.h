// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/base/rng.h"
#include "core/geometry/rigid_transform.h"

namespace cvo {

// Estimates to_from_from from pairs of points (columns) that may contain many outliers. Each
// hypothesis is fixed by three pairs. The one with the most pairs within max_distance_m is refitted
// to these pairs. Empty if no hypothesis has min_inliers of them.
std::optional<RigidTransform> AlignPointsRansac(const Eigen::Matrix3Xd& from,
                                                const Eigen::Matrix3Xd& to, double max_distance_m,
                                                int min_inliers, int iterations, Rng& rng);

}  // namespace cvo
