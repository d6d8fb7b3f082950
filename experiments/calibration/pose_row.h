// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/geometry/rigid_transform.h"

namespace cvo {

// The rotation nearest to R, which must be one to within 1e-3 per entry of R R^T and not a
// reflection. Throws Error(where, ...).
Eigen::Matrix3d CheckedRotation(const Eigen::Matrix3d& R, const std::string& where);

// [R t] row by row, twelve numbers. Throws Error(where, ...).
RigidTransform TransformFromRow(const std::vector<double>& row, const std::string& where);

}  // namespace cvo
