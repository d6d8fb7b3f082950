// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/models/make_model.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "synth/models/builders.h"

namespace cvo::synth {
namespace {

struct Kind {
  const char* name;
  Eigen::Vector3d usual_size_m;  // zero: the size in the file
  Model (*build)(const BuildRequest&, Rng&);
};

const std::vector<Kind>& Kinds() {
  static const std::vector<Kind> kinds = {
      {"ball", {0.6, 0.6, 0.6}, BuildBall},          {"block", {0.4, 0.4, 0.4}, BuildBlock},
      {"building", {9.0, 12.0, 9.5}, BuildBuilding}, {"car", {4.2, 1.8, 1.5}, BuildCar},
      {"chair", {0.5, 0.5, 0.95}, BuildChair},       {"crate", {0.45, 0.6, 0.4}, BuildCrate},
      {"mesh", {0.0, 0.0, 0.0}, BuildFromFile},      {"shelf", {0.35, 1.0, 1.9}, BuildShelf},
      {"table", {0.7, 1.2, 0.75}, BuildTable},       {"tower", {0.5, 0.5, 1.6}, BuildTower},
      {"tree", {3.0, 3.0, 6.0}, BuildTree}};
  return kinds;
}

const Kind& FindKind(const std::string& name) {
  for (const Kind& kind : Kinds()) {
    if (name == kind.name) return kind;
  }
  ThrowError("model", "'" + name + "'", "one of " + Joined(ModelKinds(), ", "));
}

void CheckMaterial(const std::string& material) {
  const std::vector<std::string>& known = MaterialNames();
  if (material.empty() || std::find(known.begin(), known.end(), material) != known.end()) return;
  ThrowError("material", "'" + material + "'", "one of " + Joined(known, ", "));
}

Eigen::Vector3d FindSize(const ModelDescription& description, const Kind& kind) {
  const Eigen::Vector3d& size_m = description.size_m;
  if (size_m.isZero(0.0)) return kind.usual_size_m;
  if (!(size_m.allFinite() && size_m.minCoeff() > 0.0)) {
    ThrowError("size_m of " + description.kind,
               StrCat(size_m.x(), " ", size_m.y(), " ", size_m.z()),
               "three positive lengths, or none");
  }
  const bool is_ball = description.kind == "ball";
  if (is_ball && (size_m.x() != size_m.y() || size_m.x() != size_m.z())) {
    ThrowError("size_m of ball", StrCat(size_m.x(), " ", size_m.y(), " ", size_m.z()),
               "the same diameter three times");
  }
  return size_m;
}

Eigen::Vector3d BoundsOf(const Model& model) {
  Eigen::Vector3f low = model.parts.at(0).mesh.vertices.at(0).position;
  Eigen::Vector3f high = low;
  for (const Part& part : model.parts) {
    for (const Vertex& vertex : part.mesh.vertices) {
      low = low.cwiseMin(vertex.position);
      high = high.cwiseMax(vertex.position);
    }
  }
  return (high - low).cast<double>();
}

}  // namespace

const std::vector<std::string>& ModelKinds() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Kind& kind : Kinds()) all.emplace_back(kind.name);
    return all;
  }();
  return names;
}

Model MakeModel(const ModelDescription& description, Rng& look) {
  const Kind& kind = FindKind(description.kind);
  CheckMaterial(description.material);
  const Eigen::Vector3d size_m = FindSize(description, kind);
  Rng own(look.NextU64(), description.kind);
  Model model = kind.build({size_m, description.material, description.file}, own);
  const bool ours = description.kind != "mesh";  // closed, with outward normals
  for (Part& part : model.parts) part.mesh.two_sided = !ours;
  FitTo(model, size_m.isZero(0.0) ? BoundsOf(model) : size_m);
  return model;
}

Texture MaterialOr(const BuildRequest& request, const std::string& usual, Rng& look) {
  return MakeTexture(request.material.empty() ? usual : request.material, look);
}

}  // namespace cvo::synth
