// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "synth/models/build.h"
#include "synth/models/model.h"

namespace cvo::synth {
namespace {

using Eigen::Vector3d;

struct Kind {
  const char* name;
  Eigen::Vector3d usual_size_m;
  Model (*build)(const ModelDescription&, Rng&);
};

const std::vector<Kind>& Kinds() {
  static const std::vector<Kind> kinds = {
      {"ball", {0.6, 0.6, 0.6}, BuildBall},          {"block", {0.4, 0.4, 0.4}, BuildBlock},
      {"building", {9.0, 12.0, 9.5}, BuildBuilding}, {"car", {4.2, 1.8, 1.5}, BuildCar},
      {"chair", {0.5, 0.5, 0.95}, BuildChair},       {"crate", {0.45, 0.6, 0.4}, BuildCrate},
      {"shelf", {0.35, 1.0, 1.9}, BuildShelf},       {"table", {0.7, 1.2, 0.75}, BuildTable},
      {"tower", {0.5, 0.5, 1.6}, BuildTower},        {"tree", {3.0, 3.0, 6.0}, BuildTree}};
  return kinds;
}

const Kind& FindKind(const std::string& name) {
  for (const Kind& kind : Kinds()) {
    if (name == kind.name) return kind;
  }
  ThrowError("model", "'" + name + "'", "one of " + Joined(ModelKinds(), ", "));
}

}  // namespace

Model BuildBall(const ModelDescription& request, Rng& look) {
  Model model;
  const double radius = 0.5 * request.size_m.x();
  Part part = MakePart(MaterialOr(request, "ball", look));
  AddBall(part.mesh, {}, radius, 14);
  part.gloss = 0.15f;
  model.parts.push_back(std::move(part));
  CollisionShape shape;
  shape.radius_m = radius;
  shape.half_size_m = Vector3d::Constant(radius);
  model.shapes.push_back(shape);
  return model;
}

// Shows six pictures unless a material is requested.
Model BuildBlock(const ModelDescription& request, Rng& look) {
  Model model;
  const Vector3d low = Vector3d::Zero();
  const Vector3d& high = request.size_m;
  if (request.material.empty()) {
    for (int face = 0; face < 6; ++face) {
      Part part = MakePart(MakeTexture("block", look));
      AddPicture(part.mesh, {}, BoxFace(low, high, face));
      model.parts.push_back(std::move(part));
    }
  } else {
    const Texture texture = MakeTexture(request.material, look);
    Part part = MakePart(texture);
    AddBox(part.mesh, PenFor(texture, look), low, high);
    model.parts.push_back(std::move(part));
  }
  model.shapes.push_back(MakeBoxShape(low, high));
  return model;
}

// A stack of boxes, the upper ones a little smaller.
Model BuildTower(const ModelDescription& request, Rng& look) {
  Model model;
  const Vector3d& size = request.size_m;
  const int storeys = std::max(2, static_cast<int>(size.z() / 0.4 + 0.5));
  const double height = size.z() / storeys;
  std::vector<Texture> textures;
  for (int i = 0; i < 3; ++i) textures.push_back(MaterialOr(request, "block", look));
  model.parts.resize(textures.size());
  for (std::size_t i = 0; i < textures.size(); ++i) model.parts[i].texture = textures[i].image;
  for (int i = 0; i < storeys; ++i) {
    const std::size_t which = static_cast<std::size_t>(i) % textures.size();
    const double part = i == 0 ? 1.0 : look.Uniform(0.82, 0.97);
    const Vector3d half(0.5 * part * size.x(), 0.5 * part * size.y(), 0.0);
    const Pen pen{textures[which].size_m, {look.Uniform(), look.Uniform()}, {}};
    const Vector3d low = Vector3d(0, 0, i * height) - half;
    AddBox(model.parts[which].mesh, pen, low, half + Vector3d(0, 0, (i + 1) * height));
  }
  model.shapes.push_back(MakeBoxShape(Vector3d(-0.5 * size.x(), -0.5 * size.y(), 0.0),
                                      Vector3d(0.5 * size.x(), 0.5 * size.y(), size.z())));
  return model;
}

Model MakeTree(const Vector3d& size_m, const Texture& leaves, const Texture& bark, Rng& look) {
  const double trunk = 0.05 * size_m.head<2>().minCoeff() + 0.02 * size_m.z();
  const double crown = 0.36 * size_m.z();  // height of its lower end
  Model model;
  Part stem = MakePart(bark);
  Part foliage = MakePart(leaves);
  AddCylinder(stem.mesh, PenFor(bark, look), {trunk, 0.6 * trunk, 0.75 * size_m.z(), 10});
  const Vector3d half(0.5 * size_m.x(), 0.5 * size_m.y(), 0.5 * (size_m.z() - crown));
  const Vector3d middle(0, 0, crown + half.z());
  for (int i = 0; i < 5; ++i) {
    Pen pen = PenFor(leaves, look);
    const double angle = 1.57 * i + look.Uniform(-0.4, 0.4);
    const double out = i == 0 ? 0.0 : look.Uniform(0.3, 0.45);
    const double up = i == 0 ? 0.3 : look.Uniform(-0.4, 0.15);
    const double part = i == 0 ? 0.7 : look.Uniform(0.5, 0.62);
    const Vector3d at(out * std::cos(angle), out * std::sin(angle), up);
    pen.model_from_piece = RigidTransform(ExpSo3(Vector3d(0, 0, look.Uniform(0.0, 6.28))),
                                          middle + at.cwiseProduct(half));
    AddBlob(foliage.mesh, pen, part * half, 0.35, look);
  }
  model.parts = {std::move(stem), std::move(foliage)};
  model.shapes.push_back(MakeBoxShape({-trunk, -trunk, 0.0}, {trunk, trunk, crown}));
  model.shapes.push_back(MakeBoxShape(middle - half, middle + half));
  FitTo(model, size_m);
  return model;
}

Model MakeBuilding(const Vector3d& size_m, const Texture& facade, const Texture& roof, Rng& look) {
  constexpr double kFloor_m = 3.0;
  constexpr double kBay_m = 2.4;
  const double eaves = 0.25;
  const double height = size_m.z() - 0.5;
  Model model;
  Part walls = MakePart(facade);
  Part top = MakePart(roof);
  const Vector3d low(eaves, eaves, 0.0);
  const Vector3d high(size_m.x() - eaves, size_m.y() - eaves, height);
  for (int face = 0; face < 4; ++face) {
    const Rectangle side = BoxFace(low, high, face);
    // Whole bays, and whole floors up to the edge of the roof with the ground floor at the bottom.
    const double bays = std::max(1.0, std::round(side.right.norm() / kBay_m));
    const double floors = std::max(1.0, std::round(height / kFloor_m));
    Pen pen;
    pen.texture_size_m = {side.right.norm() / bays * 5.0, height / floors * 4.0};
    pen.uv_offset = {0.2 * static_cast<double>(look.UniformInt(5)), 1.0 - floors / 4.0};
    pen.largest_cell_m = 4.0;
    AddRectangle(walls.mesh, pen, side);
  }
  const Pen roof_pen{roof.size_m, {0, 0}, {}};
  AddBox(top.mesh, roof_pen, {0, 0, height}, {size_m.x(), size_m.y(), height + 0.35});
  const double chimney = 0.35 + 0.15;
  AddBox(top.mesh, roof_pen, {0.3 * size_m.x(), 0.3 * size_m.y(), height},
         {0.3 * size_m.x() + 0.9, 0.3 * size_m.y() + 0.7, height + chimney});
  model.parts = {std::move(walls), std::move(top)};
  model.shapes.push_back(MakeBoxShape(Vector3d::Zero(), size_m));
  FitTo(model, size_m);
  return model;
}

Model MakeHedge(const Vector3d& size_m, const Texture& leaves, Rng& look) {
  Model model;
  Part part = MakePart(leaves);
  AddBox(part.mesh, PenFor(leaves, look), Vector3d::Zero(), size_m);
  model.parts.push_back(std::move(part));
  model.shapes.push_back(MakeBoxShape(Vector3d::Zero(), size_m));
  FitTo(model, size_m);
  return model;
}

Model MakeLampPost(double height_m, const Texture& metal, const Texture& lamp) {
  Model model;
  Part post = MakePart(metal);
  Part light = MakePart(lamp);
  const Pen pen{metal.size_m, {0, 0}, {}};
  AddCylinder(post.mesh, pen, {0.1, 0.06, height_m - 0.2, 8});
  AddCylinder(post.mesh, pen, {0.16, 0.14, 0.8, 8});
  AddBox(post.mesh, pen, {-0.06, -0.06, height_m - 0.24}, {1.2, 0.06, height_m - 0.12});
  AddBox(light.mesh, {}, {0.6, -0.16, height_m - 0.3}, {1.4, 0.16, height_m});
  model.parts = {std::move(post), std::move(light)};
  model.shapes.push_back(MakeBoxShape({-0.16, -0.16, 0}, {0.16, 0.16, height_m}));
  FitTo(model, {1.56, 0.32, height_m});
  return model;
}

Model MakeSign(const Texture& picture, const Texture& metal, Rng& look) {
  const double height = look.Uniform(2.2, 2.8);
  Model model;
  Part post = MakePart(metal);
  Part board = MakePart(picture);
  const Pen pen{metal.size_m, {0, 0}, {}};
  AddCylinder(post.mesh, pen, {0.05, 0.05, height - 0.02, 8});
  AddBox(post.mesh, pen, {0.05, -0.62, height - 1.22}, {0.09, 0.62, height});
  const Vector3d low(0.04, -0.58, height - 1.18);
  const Vector3d high(0.1, 0.58, height - 0.04);
  for (int face = 0; face < 2; ++face) AddPicture(board.mesh, {}, BoxFace(low, high, face));
  model.parts = {std::move(post), std::move(board)};
  model.shapes.push_back(MakeBoxShape({-0.08, -0.62, 0}, {0.08, 0.62, height}));
  FitTo(model, {0.15, 1.24, height});
  return model;
}

Model BuildTree(const ModelDescription& request, Rng& look) {
  const Texture leaves = MaterialOr(request, "leaves", look);
  const Texture bark = MakeTexture("bark", look);
  return MakeTree(request.size_m, leaves, bark, look);
}

Model BuildBuilding(const ModelDescription& request, Rng& look) {
  const Texture facade = MaterialOr(request, "facade", look);
  const Texture roof = MakeTexture("roof", look);
  return MakeBuilding(request.size_m, facade, roof, look);
}

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
  ModelDescription request = description;
  if (request.size_m.isZero(0.0)) request.size_m = kind.usual_size_m;
  const Eigen::Vector3d& size_m = request.size_m;
  if (request.kind == "ball" && size_m.minCoeff() != size_m.maxCoeff()) {
    ThrowError("size_m of ball", StrCat(size_m.x(), " ", size_m.y(), " ", size_m.z()),
               "the same diameter three times");
  }
  Rng own(look.NextU64(), request.kind);
  Model model = kind.build(request, own);
  for (Part& part : model.parts) part.mesh.two_sided = false;  // closed, with outward normals
  FitTo(model, size_m);
  return model;
}

Texture MaterialOr(const ModelDescription& request, const std::string& usual, Rng& look) {
  return MakeTexture(request.material.empty() ? usual : request.material, look);
}

}  // namespace cvo::synth
