// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/base/rng.h"
#include "core/geometry/rigid_transform.h"

namespace cvo {

// to_from_from of pairs of points (columns) of which many may be wrong: three pairs fix a
// hypothesis, the one with the most pairs within max_distance_m wins and is fitted to those. Empty
// where no hypothesis has min_inliers.
std::optional<RigidTransform> AlignPointsRansac(const Eigen::Matrix3Xd& from,
                                                const Eigen::Matrix3Xd& to, double max_distance_m,
                                                int min_inliers, int iterations, Rng& rng);

}  // namespace cvo
