// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "synth/truth/truth.h"

namespace cvo::synth {

// objects.csv: a header, then a row for every body in every frame, seen or not. Poses and
// velocities are in the world that is the folder's first left camera; boxes are empty where there
// is none.
std::string ObjectTableHeader();
std::string FormatObjectRows(const World& world, const FrameTruth& truth, int row_frame,
                             const RigidTransform& first_left_from_world);

// The same read back: in FrameTruth, world is the folder's first left camera, frames count from 0,
// alone the camera's pose is not set.
struct ObjectTable {
  std::vector<std::string> names;       // [id - 1]
  std::vector<std::string> categories;  // [id - 1]
  std::vector<Eigen::Vector3d> sizes_m;
  std::vector<FrameTruth> frames;
};

// `times_s`: of the folder's frames. Throws Error naming file and line.
ObjectTable ReadObjectTable(const std::filesystem::path& file, const std::vector<double>& times_s);

}  // namespace cvo::synth
