// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "synth/models/mesh_builder.h"

namespace cvo::synth {

// Arguments of the builders. Each builder makes one kind of model, with z from 0 and about the
// requested size, which MakeModel then fits exactly. An empty material stands for the usual one of
// the model.
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

// These models take textures that several of them share. They have exactly the given size, and the
// origin at their centre.
Model MakeTree(const Eigen::Vector3d& size_m, const Texture& leaves, const Texture& bark,
               Rng& look);
Model MakeBuilding(const Eigen::Vector3d& size_m, const Texture& facade, const Texture& roof,
                   Rng& look);
Model MakeHedge(const Eigen::Vector3d& size_m, const Texture& leaves, Rng& look);
Model MakeLampPost(double height_m, const Texture& metal, const Texture& lamp);
Model MakeSign(const Texture& picture, const Texture& metal, Rng& look);

// Makes the requested material, or `usual` if the request has none.
Texture MaterialOr(const BuildRequest& request, const std::string& usual, Rng& look);

}  // namespace cvo::synth
