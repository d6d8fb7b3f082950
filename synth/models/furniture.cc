// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "synth/models/build.h"

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

// A cross-section of the car, as fractions of its length, half width and height.
struct Station {
  double x;      // -0.5 ... 0.5
  double roof;   // highest point
  double width;  // at the belt line
};

constexpr double kBelt = 0.62;
constexpr double kSill = 0.14;
constexpr std::array<Station, 13> kStations = {{{-0.5, 0.52, 0.86},
                                                {-0.485, 0.64, 0.93},
                                                {-0.44, 0.68, 0.97},
                                                {-0.33, 0.94, 0.985},
                                                {-0.24, 0.99, 0.99},
                                                {-0.1, 1.0, 1.0},
                                                {0.02, 0.98, 1.0},
                                                {0.08, 0.93, 1.0},
                                                {0.22, 0.66, 0.99},
                                                {0.34, 0.62, 0.98},
                                                {0.44, 0.57, 0.95},
                                                {0.485, 0.5, 0.9},
                                                {0.5, 0.4, 0.84}}};
constexpr int kColumns = 9;

// Outline of a cross-section, from the right sill over the roof to the left sill.
std::vector<Vector3d> CutAt(const Station& station, const Vector3d& size) {
  const double x = station.x * size.x();
  const double half = 0.5 * size.y() * station.width;
  const double top = station.roof * size.z();
  const double belt = std::min(kBelt * size.z(), 0.94 * top);
  const double rise = top - belt;
  const double inset = std::min(0.3 * half, 0.55 * rise + 0.04 * half);
  const std::array<Eigen::Vector2d, 5> half_cut = {{{0.96 * half, kSill * size.z()},
                                                    {half, 0.5 * belt + 0.5 * kSill * size.z()},
                                                    {0.985 * half, belt},
                                                    {half - inset, top - 0.12 * rise},
                                                    {0.0, top}}};
  std::vector<Vector3d> cut;
  for (const Eigen::Vector2d& p : half_cut) cut.emplace_back(x, -p.x(), p.y());
  for (int i = 3; i >= 0; --i) cut.emplace_back(x, half_cut[i].x(), half_cut[i].y());
  return cut;
}

bool IsGlass(std::size_t row, int column) {
  const bool side = column == 2 || column == 5;
  const bool cabin = row >= 2 && row <= 7;
  const bool screen = (row == 2 || row == 7) && (column == 3 || column == 4);
  return (side && row >= 3 && row <= 6) || (screen && cabin);
}

void AddShell(Part& paint, Part& glass, const Pen& paint_pen, const Pen& glass_pen,
              const Vector3d& size) {
  Lattice body{static_cast<int>(kStations.size()), kColumns, {}};
  for (const Station& station : kStations) {
    for (const Vector3d& p : CutAt(station, size)) body.points.push_back(p);
  }
  Mesh whole;
  AddLattice(whole, paint_pen, body);
  // Glass faces form a part of their own.
  const auto at = [&](std::size_t r, int c) { return body.points[r * kColumns + c]; };
  paint.mesh.vertices = whole.vertices;
  for (std::size_t r = 0; r + 1 < kStations.size(); ++r) {
    for (int c = 0; c + 1 < kColumns; ++c) {
      const std::size_t first = (r * (kColumns - 1) + c) * 6;
      if (!IsGlass(r, c)) {
        for (std::size_t i = 0; i < 6; ++i) paint.mesh.indices.push_back(whole.indices[first + i]);
      } else {
        AddLattice(glass.mesh, glass_pen,
                   {2, 2, {at(r, c), at(r, c + 1), at(r + 1, c), at(r + 1, c + 1)}});
      }
    }
  }
}

// Closes the shell at the nose, tail and floor.
void AddClosings(Part& paint, Part& dark, const Pen& pen, const Vector3d& size) {
  for (const std::size_t row : {std::size_t{0}, kStations.size() - 1}) {
    const std::vector<Vector3d> cut = CutAt(kStations[row], size);
    Lattice cap{2, 5, {}};
    for (int i = 0; i < 5; ++i) cap.points.push_back(cut[i]);
    for (int i = 0; i < 5; ++i) cap.points.push_back(cut[8 - i]);
    if (row == 0) {
      for (int i = 0; i < 5; ++i) std::swap(cap.points[i], cap.points[5 + i]);
    }
    AddLattice(paint.mesh, pen, cap);
  }
  AddBox(dark.mesh, {}, {-0.48 * size.x(), -0.44 * size.y(), 0.11 * size.z()},
         {0.48 * size.x(), 0.44 * size.y(), 0.2 * size.z()});
}

void AddWheels(Part& tyre, Part& hub, const Vector3d& size) {
  const double radius = 0.215 * size.z();
  const double width = 0.12 * size.y();
  for (const double x : {-0.31 * size.x(), 0.31 * size.x()}) {
    for (const double side : {-1.0, 1.0}) {
      const double turn = -side * 0.5 * 3.14159265358979;
      Pen pen;
      const double inner = side * (0.5 * size.y() - width);
      pen.model_from_piece =
          RigidTransform(ExpSo3(Vector3d(turn, 0, 0)), Vector3d(x, inner, radius));
      const Cylinder wheel{radius, radius, width, 20};
      AddCylinder(tyre.mesh, pen, wheel);
      AddCylinderEnds(hub.mesh, pen, wheel);
      // The dark inside of the wheel arch, just outside the painted side.
      const Cylinder arch{1.12 * radius, 1.12 * radius, 0.92 * width, 20};
      pen.model_from_piece =
          RigidTransform(ExpSo3(Vector3d(turn, 0, 0)), Vector3d(x, inner, 1.08 * radius));
      AddCylinder(tyre.mesh, pen, arch);
      AddCylinderEnds(tyre.mesh, pen, arch);
    }
  }
}

void AddLights(Part& white, Part& red, Part& plate, const Vector3d& size) {
  const double front = 0.5 * size.x();
  for (const double side : {-1.0, 1.0}) {
    const double y = side * 0.3 * size.y();
    const Vector3d half(0.012 * size.x(), 0.07 * size.y(), 0.045 * size.z());
    const Vector3d head(front + 0.012 - half.x(), y, 0.36 * size.z());
    AddBox(white.mesh, {}, head - half, head + half);
    const Vector3d tail(-front - 0.012 + half.x(), y, 0.46 * size.z());
    AddBox(red.mesh, {}, tail - half, tail + half);
  }
  const double w = 0.145 * size.y();
  const double z = 0.3 * size.z();
  const Vector3d down(0, 0, -0.08 * size.z());
  AddPicture(plate.mesh, {}, {{front + 0.008, -w, z}, {0, 2 * w, 0}, down});
  AddPicture(plate.mesh, {}, {{-front - 0.008, w, z}, {0, -2 * w, 0}, down});
}

}  // namespace

Model BuildCrate(const ModelDescription& request, Rng& look) {
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
Model BuildChair(const ModelDescription& request, Rng& look) {
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
Model BuildTable(const ModelDescription& request, Rng& look) {
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

Model BuildShelf(const ModelDescription& request, Rng& look) {
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

Model BuildCar(const ModelDescription& request, Rng& look) {
  const Texture paint_texture = MaterialOr(request, "paint", look);
  const Texture glass_texture = MakeCarGlassTexture(look);
  const Vector3d& size = request.size_m;
  std::array<Part, 8> parts;
  auto& [paint, glass, dark, tyre, hub, white, red, plate] = parts;
  paint.texture = paint_texture.image;
  glass.texture = glass_texture.image;
  dark.texture = MakeSolidTexture({36, 36, 38}, look).image;
  tyre.texture = dark.texture;
  hub.texture = MakeWheelTexture(look).image;
  white.texture = MakeSolidTexture({246, 244, 232}, look).image;
  red.texture = MakeSolidTexture({176, 30, 32}, look).image;
  plate.texture = MakePlateTexture(look).image;
  paint.gloss = 0.35f;
  glass.gloss = 0.6f;
  const Pen paint_pen{paint_texture.size_m, {look.Uniform(), look.Uniform()}, {}};
  const Pen glass_pen{glass_texture.size_m, {look.Uniform(), look.Uniform()}, {}};
  AddShell(paint, glass, paint_pen, glass_pen, size);
  AddClosings(paint, dark, paint_pen, size);
  AddWheels(tyre, hub, size);
  AddLights(white, red, plate, size);
  Model model;
  for (Part& part : parts) model.parts.push_back(std::move(part));
  const double half = 0.5 * size.y();
  model.shapes.push_back(
      MakeBoxShape({-0.5 * size.x(), -half, 0.0}, {0.5 * size.x(), half, 0.66 * size.z()}));
  model.shapes.push_back(MakeBoxShape({-0.42 * size.x(), -0.95 * half, 0.6 * size.z()},
                                      {0.2 * size.x(), 0.95 * half, size.z()}));
  return model;
}

}  // namespace cvo::synth
