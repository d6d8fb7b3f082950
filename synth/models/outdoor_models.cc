// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "synth/models/builders.h"

namespace cvo::synth {
using Eigen::Vector3d;

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

Model BuildTree(const BuildRequest& request, Rng& look) {
  const Texture leaves = MaterialOr(request, "leaves", look);
  const Texture bark = MakeTexture("bark", look);
  return MakeTree(request.size_m, leaves, bark, look);
}

Model BuildBuilding(const BuildRequest& request, Rng& look) {
  const Texture facade = MaterialOr(request, "facade", look);
  const Texture roof = MakeTexture("roof", look);
  return MakeBuilding(request.size_m, facade, roof, look);
}

}  // namespace cvo::synth
