// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/estimation/cluster.h"

namespace cvo {

// Returns the level component of a direction with unit length; an arbitrary level direction if it
// is vertical.
Eigen::Vector3d Levelled(const Eigen::Vector3d& direction, const Eigen::Vector3d& down);

// Turns a direction about the vertical as the motion does. Roll and pitch do not change it.
Eigen::Vector3d TurnedBy(const RigidTransform& motion, const Eigen::Vector3d& down,
                         const Eigen::Vector3d& direction);

// Returns the axes forward, down, and left of an observer who looks forward, as columns (KITTI's x,
// y and z of a body). `forward` and `down` must be unit vectors at right angles.
Eigen::Matrix3d BoxAxes(const Eigen::Vector3d& forward, const Eigen::Vector3d& down);

// Returns the level direction in which the point of the cluster moved, over the shortest past in
// which it moved by more than `least_m`. Empty if it has not moved that far since the oldest state.
std::optional<Eigen::Vector3d> DirectionOfMotion(const Cluster& cluster,
                                                 const Eigen::Vector3d& p_in_object,
                                                 const Eigen::Vector3d& down, double least_m);

}  // namespace cvo
