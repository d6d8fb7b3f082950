// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/rng.h"
#include "synth/models/model.h"

namespace cvo::synth {

struct ModelDescription {
  std::string kind;  // one of ModelKinds()
  // Size of its box along x, y, z; zero for the usual size of the model. For a ball, all three are
  // the diameter.
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();
  std::string material;        // one of MaterialNames(); empty: the usual one of the model
  std::filesystem::path file;  // kind "mesh": OBJ, PLY or glTF in metres, z up, scaled to size_m
};

// "ball", "block", "car", "chair", "crate", "shelf", "table", "tower", "mesh", ...
const std::vector<std::string>& ModelKinds();
const std::vector<std::string>& MaterialNames();

// Makes a model. `look` varies textures and small parts: a different stream gives a different model
// of the same kind and size. Throws Error for an unknown kind or material, a size that is not
// positive or a file that cannot be read.
Model MakeModel(const ModelDescription& description, Rng& look);

}  // namespace cvo::synth
