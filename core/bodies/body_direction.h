// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/estimation/cluster.h"

namespace cvo {

// The part of a direction that is level, of unit length; some level direction where there is none.
Eigen::Vector3d Levelled(const Eigen::Vector3d& direction, const Eigen::Vector3d& down);

// The direction as a motion turns it about the vertical: rolling and pitching leave it as it is.
Eigen::Vector3d TurnedBy(const RigidTransform& motion, const Eigen::Vector3d& down,
                         const Eigen::Vector3d& direction);

// Columns: forward, down, and to the left of someone who looks forward (KITTI's x, y and z of a
// body). Both unit vectors, at right angles.
Eigen::Matrix3d BoxAxes(const Eigen::Vector3d& forward, const Eigen::Vector3d& down);

// Where the point of the cluster came from, level: over the shortest time in which it moved by
// more than `least_m`. Empty where it did not since its oldest state.
std::optional<Eigen::Vector3d> DirectionOfMotion(const Cluster& cluster,
                                                 const Eigen::Vector3d& p_in_object,
                                                 const Eigen::Vector3d& down, double least_m);

}  // namespace cvo
