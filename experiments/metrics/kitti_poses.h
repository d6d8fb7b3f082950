// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/geometry/rigid_transform.h"

namespace cvo {

// KITTI pose files: world_from_camera of frame i in line i, without timestamps. Reading is strict
// and throws Error with file and line; written numbers read back as the same doubles.
std::vector<RigidTransform> ReadKittiPoses(const std::filesystem::path& path);
std::string FormatKittiPoses(const std::vector<RigidTransform>& world_from_camera);
void WriteKittiPoses(const std::filesystem::path& path,
                     const std::vector<RigidTransform>& world_from_camera);

}  // namespace cvo
