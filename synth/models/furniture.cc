// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "synth/models/builders.h"

namespace cvo::synth {
namespace {

using Eigen::Vector3d;

void AddSolid(Part& part, Model& model, const Pen& pen, const Vector3d& low, const Vector3d& high) {
  AddBox(part.mesh, pen, low, high);
  model.shapes.push_back(MakeBoxShape(low, high));
}

void AddLegs(Part& part, Model& model, const Pen& pen, const Vector3d& size, double thickness) {
  const double x = 0.5 * size.x() - thickness;
  const double y = 0.5 * size.y() - thickness;
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      const Vector3d middle(sx * (x + 0.5 * thickness), sy * (y + 0.5 * thickness), 0.0);
      const Vector3d half(0.5 * thickness, 0.5 * thickness, 0.0);
      AddSolid(part, model, pen, middle - half, middle + half + Vector3d(0, 0, size.z()));
    }
  }
}

// Adds a book. All its faces show the same spine.
void AddBook(Mesh& mesh, const Vector3d& low, const Vector3d& high, Rng& look) {
  const auto cell = static_cast<int>(look.UniformInt(kBookColumns * kBookRows));
  for (int face = 0; face < 6; ++face) {
    const Rectangle rectangle = BoxFace(low, high, face);
    Pen pen;
    pen.texture_size_m = {kBookColumns * rectangle.right.norm(), kBookRows * rectangle.down.norm()};
    pen.uv_offset = {static_cast<double>(cell % kBookColumns) / kBookColumns,
                     static_cast<double>(cell / kBookColumns) / kBookRows};
    AddRectangle(mesh, pen, rectangle);
  }
}

// A board on which books and boxes stand side by side from y0 to y1, at `height` and with their
// fronts near x = depth.
struct Board {
  double depth;
  double y0;
  double y1;
  double height;
  double room;  // free height above it
};

void AddBooks(Mesh& mesh, const Board& board, Rng& look) {
  double y = board.y0 + look.Uniform(0.0, 0.04);
  while (y < board.y1 - 0.03) {
    const bool box = look.Uniform() < 0.12;
    double width = box ? look.Uniform(0.1, 0.22) : look.Uniform(0.028, 0.06);
    width = std::min(width, board.y1 - y);
    const double height = board.room * (box ? look.Uniform(0.4, 0.8) : look.Uniform(0.62, 0.93));
    const double front = board.depth * look.Uniform(0.82, 0.97);
    AddBook(mesh, {0.1 * board.depth, y, board.height}, {front, y + width, board.height + height},
            look);
    y += width + (look.Uniform() < 0.12 ? look.Uniform(0.02, 0.12) : 0.0015);
  }
}

}  // namespace

Model BuildCrate(const BuildRequest& request, Rng& look) {
  const Texture wood = MaterialOr(request, "wood", look);
  const Vector3d& size = request.size_m;
  const double board = 0.06 * size.minCoeff();
  Model model;
  Part part = MakePart(wood);
  Part label = MakePart(MakeTexture("poster", look));
  const Pen pen = PenFor(wood, look);
  const Vector3d rim(board, board, 0.0);
  AddBox(part.mesh, pen, rim, size - rim - Vector3d(0, 0, board));
  for (const double z : {0.0, size.z() - 0.22 * size.z()}) {
    AddBox(part.mesh, pen, {0, 0, z}, {size.x(), size.y(), z + 0.22 * size.z()});
  }
  for (int face = 0; face < 4; ++face) {
    Rectangle side =
        BoxFace(rim - Vector3d(0.004, 0.004, 0), size - rim + Vector3d(0.004, 0.004, 0), face);
    const double from = look.Uniform(0.1, 0.3);
    side.corner += from * side.right + 0.28 * side.down;
    side.right *= 0.5;
    side.down *= 0.44;
    AddPicture(label.mesh, {}, side);
  }
  model.parts = {std::move(part), std::move(label)};
  model.shapes.push_back(MakeBoxShape(Vector3d::Zero(), size));
  return model;
}

// Upholstered, because thin bars alone are hardly visible in a stereo pair. Background is visible
// through its box, between the legs and above the seat.
Model BuildChair(const BuildRequest& request, Rng& look) {
  const Texture wood = MaterialOr(request, "wood", look);
  const Texture cloth = MakeTexture("fabric", look);
  const Vector3d& size = request.size_m;
  const double leg = 0.1 * std::min(size.x(), size.y());
  const double x = 0.5 * size.x();
  const double y = 0.5 * size.y();
  const double seat_bottom = 0.36 * size.z();
  const double seat_top = 0.5 * size.z();
  const double back_bottom = 0.7 * size.z();
  const double back = -x + 0.2 * size.x();
  Model model;
  Part frame = MakePart(wood);
  AddLegs(frame, model, PenFor(wood, look), {size.x(), size.y(), seat_bottom}, leg);
  for (const double side : {-1.0, 1.0}) {
    const double middle = side * (y - leg);
    AddBox(frame.mesh, PenFor(wood, look), {-x + 0.02, middle - 0.5 * leg, seat_top},
           {-x + 0.02 + leg, middle + 0.5 * leg, back_bottom});
  }
  Part cushions = MakePart(cloth);
  AddBox(cushions.mesh, PenFor(cloth, look), {-x, -y, seat_bottom}, {x, y, seat_top});
  AddBox(cushions.mesh, PenFor(cloth, look), {-x, -y, back_bottom}, {back, y, size.z()});
  model.shapes.push_back(MakeBoxShape({-x, -y, seat_bottom}, {x, y, seat_top}));
  model.shapes.push_back(MakeBoxShape({-x, -y, seat_top}, {back, y, size.z()}));
  model.parts = {std::move(frame), std::move(cushions)};
  return model;
}

// The height of a table includes what lies on it.
Model BuildTable(const BuildRequest& request, Rng& look) {
  const Texture wood = MaterialOr(request, "wood", look);
  const Vector3d& size = request.size_m;
  const double things = std::min(0.22, 0.3 * size.z());
  const double top = size.z() - things;
  const double x = 0.5 * size.x();
  const double y = 0.5 * size.y();
  Model model;
  Part frame = MakePart(wood);
  Part books = MakePart(MakeBooksTexture(look));
  const Pen pen = PenFor(wood, look);
  AddLegs(frame, model, pen, {0.94 * size.x(), 0.96 * size.y(), top - 0.04}, 0.06);
  AddBox(frame.mesh, pen, {-0.45 * size.x(), -0.46 * size.y(), top - 0.1},
         {0.45 * size.x(), 0.46 * size.y(), top - 0.04});
  AddSolid(frame, model, pen, {-x, -y, top - 0.04}, {x, y, top});
  double at = -y + 0.06;
  bool highest = true;
  while (at < y - 0.2) {
    const double width = look.Uniform(0.12, 0.26);
    const double height = highest ? things : look.Uniform(0.2, 0.95) * things;
    const double depth = look.Uniform(0.2, 0.4) * size.x();
    const double middle = look.Uniform(-0.08, 0.08) * size.x();
    const Vector3d low(middle - 0.5 * depth, at, top);
    const Vector3d high(middle + 0.5 * depth, std::min(at + width, y - 0.04), top + height);
    AddBook(books.mesh, low, high, look);
    model.shapes.push_back(MakeBoxShape(low, high));
    highest = false;
    at += width + look.Uniform(0.03, 0.18);
  }
  if (highest) AddBook(books.mesh, {-0.3 * x, -0.3 * y, top}, {0.3 * x, 0.3 * y, size.z()}, look);
  model.parts = {std::move(frame), std::move(books)};
  return model;
}

Model BuildShelf(const BuildRequest& request, Rng& look) {
  const Texture wood = MaterialOr(request, "wood", look);
  const Vector3d& size = request.size_m;
  const double board = 0.025;
  const int boards = std::max(2, static_cast<int>(size.z() / 0.36));
  Model model;
  Part frame = MakePart(wood);
  Part books = MakePart(MakeBooksTexture(look));
  const Pen pen = PenFor(wood, look);
  AddBox(frame.mesh, pen, {0.003, board, 0}, {0.02, size.y() - board, size.z() - 0.01});
  for (const double y : {0.0, size.y() - board}) {
    AddBox(frame.mesh, pen, {0, y, 0}, {size.x(), y + board, size.z()});
  }
  const double pitch = (size.z() - board - 0.06) / boards;
  for (int i = 0; i <= boards; ++i) {
    const double z = 0.06 + i * pitch;
    AddBox(frame.mesh, pen, {0, board, z}, {size.x(), size.y() - board, z + board});
    if (i == boards) break;
    AddBooks(books.mesh, {size.x(), board, size.y() - board, z + board, pitch - board}, look);
  }
  model.parts = {std::move(frame), std::move(books)};
  model.shapes.push_back(MakeBoxShape(Vector3d::Zero(), size));
  return model;
}

}  // namespace cvo::synth
