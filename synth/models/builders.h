// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "synth/models/mesh_builder.h"

namespace cvo::synth {

// Each makes one kind of model, z from 0 and roughly in its size; MakeModel fits it exactly. An
// empty material is the one that suits.
struct BuildRequest {
  Eigen::Vector3d size_m;
  std::string material;
  std::filesystem::path file;
};

Model BuildBall(const BuildRequest& request, Rng& look);
Model BuildBlock(const BuildRequest& request, Rng& look);
Model BuildTower(const BuildRequest& request, Rng& look);
Model BuildCrate(const BuildRequest& request, Rng& look);
Model BuildChair(const BuildRequest& request, Rng& look);
Model BuildTable(const BuildRequest& request, Rng& look);
Model BuildShelf(const BuildRequest& request, Rng& look);
Model BuildCar(const BuildRequest& request, Rng& look);
Model BuildTree(const BuildRequest& request, Rng& look);
Model BuildBuilding(const BuildRequest& request, Rng& look);
Model BuildFromFile(const BuildRequest& request, Rng& look);

// The same with textures that several share; they have `size_m` exactly, the origin in the middle.
Model MakeTree(const Eigen::Vector3d& size_m, const Texture& leaves, const Texture& bark,
               Rng& look);
Model MakeBuilding(const Eigen::Vector3d& size_m, const Texture& facade, const Texture& roof,
                   Rng& look);
Model MakeHedge(const Eigen::Vector3d& size_m, const Texture& leaves, Rng& look);
Model MakeLampPost(double height_m, const Texture& metal, const Texture& lamp);
Model MakeSign(const Texture& picture, const Texture& metal, Rng& look);

// The material's name where the request has none.
Texture MaterialOr(const BuildRequest& request, const std::string& usual, Rng& look);

}  // namespace cvo::synth
