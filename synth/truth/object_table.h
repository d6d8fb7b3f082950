// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "synth/truth/truth.h"

namespace cvo::synth {

// objects.csv: a header, then one row per body and frame, whether the body is visible or not. Poses
// and velocities are in the world frame of the folder, its first left camera. The columns of a
// missing box are empty.
std::string ObjectTableHeader();
std::string FormatObjectRows(const World& world, const FrameTruth& truth, int row_frame,
                             const RigidTransform& first_left_from_world);

// The content of objects.csv. In `frames`, the world frame is the folder's first left camera and
// frame numbers count from 0. Only the camera's pose is not set.
struct ObjectTable {
  std::vector<std::string> names;       // [id - 1]
  std::vector<std::string> categories;  // [id - 1]
  std::vector<Eigen::Vector3d> sizes_m;
  std::vector<FrameTruth> frames;
};

// `times_s` are the times of the folder's frames. Throws Error naming file and line.
ObjectTable ReadObjectTable(const std::filesystem::path& file, const std::vector<double>& times_s);

}  // namespace cvo::synth
