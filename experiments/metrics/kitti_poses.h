// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "core/geometry/rigid_transform.h"

namespace cvo {

// The rotation nearest to R, which must be one to within 1e-3 per entry of R R^T and not a
// reflection. Throws Error(where, ...).
Eigen::Matrix3d CheckedRotation(const Eigen::Matrix3d& R, const std::string& where);

// [R t] row by row, twelve numbers. Throws Error(where, ...).
RigidTransform TransformFromRow(const std::vector<double>& row, const std::string& where);

// KITTI pose files: world_from_camera of frame i in line i, without timestamps. Reading is strict
// and throws Error with file and line; written numbers read back as the same doubles.
std::vector<RigidTransform> ReadKittiPoses(const std::filesystem::path& path);
std::string FormatKittiPoses(const std::vector<RigidTransform>& world_from_camera);
void WriteKittiPoses(const std::filesystem::path& path,
                     const std::vector<RigidTransform>& world_from_camera);

}  // namespace cvo
