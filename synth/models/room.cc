// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "synth/models/build.h"
#include "synth/models/model.h"

namespace cvo::synth {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kRail_m = 1.0;
constexpr double kCell_m = 1.0;

// A wall seen from inside: `start` is its lower left corner.
struct Wall {
  Vector3d start;
  Vector3d right;   // unit
  Vector3d inward;  // unit
  double length_m;
};

std::vector<Wall> MakeWalls(const Vector3d& size_m) {
  const double x = 0.5 * size_m.x();
  const double y = 0.5 * size_m.y();
  return {{{x, y, 0}, {0, -1, 0}, {-1, 0, 0}, size_m.y()},
          {{x, -y, 0}, {-1, 0, 0}, {0, 1, 0}, size_m.x()},
          {{-x, -y, 0}, {0, 1, 0}, {1, 0, 0}, size_m.y()},
          {{-x, y, 0}, {1, 0, 0}, {0, -1, 0}, size_m.x()}};
}

// An area on a wall or on the floor.
struct Area {
  Vector2d low;
  Vector2d high;
};

bool Overlap(const Area& a, const Area& b, double gap_m) {
  return (a.low.array() < b.high.array() + gap_m).all() &&
         (b.low.array() < a.high.array() + gap_m).all();
}

bool IsFree(const Area& area, const std::vector<Area>& taken, double gap_m) {
  return std::none_of(taken.begin(), taken.end(),
                      [&](const Area& other) { return Overlap(area, other, gap_m); });
}

struct RoomState {
  const RoomDescription& room;
  std::vector<Wall> walls;
  std::vector<Area> floor_taken;              // in x and y
  std::vector<std::vector<Area>> wall_taken;  // per wall: position along it, and height
  Surroundings out;
};

// A rectangle on a wall, `off` in front of it. `area` is the position along the wall and the
// height.
Rectangle OnWall(const Wall& wall, const Area& area, double off) {
  const Vector3d corner =
      wall.start + area.low.x() * wall.right + Vector3d(0, 0, area.high.y()) + off * wall.inward;
  return {corner, (area.high.x() - area.low.x()) * wall.right,
          Vector3d(0, 0, area.low.y() - area.high.y())};
}

// Adds a flat board on a wall.
void AddBoard(Mesh& mesh, const Pen& pen, const Wall& wall, const Area& area, double thickness) {
  const Rectangle front = OnWall(wall, area, thickness);
  const Vector3d a = front.corner;
  const Vector3d b = front.corner + front.right + front.down - thickness * wall.inward;
  AddBox(mesh, pen, a.cwiseMin(b), a.cwiseMax(b));
}

void AddFrame(Mesh& mesh, const Pen& pen, const Wall& wall, const Area& hole) {
  constexpr double kWidth = 0.07;
  constexpr double kThickness = 0.035;
  const Vector2d& low = hole.low;
  const Vector2d& high = hole.high;
  for (const Area& bar :
       {Area{{low.x() - kWidth, low.y()}, {low.x(), high.y()}},
        Area{{high.x(), low.y()}, {high.x() + kWidth, high.y()}},
        Area{{low.x() - kWidth, high.y()}, {high.x() + kWidth, high.y() + kWidth}}}) {
    AddBoard(mesh, pen, wall, bar, kThickness);
  }
}

void AddShell(RoomState& state, Rng& look) {
  const Vector3d& size = state.room.size_m;
  const Texture floor = MakeTexture(look.Uniform() < 0.75 ? "parquet" : "tiles", look);
  const Texture ceiling = MakeTexture("plaster", look);
  const Texture trim = MakeSolidTexture({104, 74, 52}, look);
  Part ground = MakeShellPart(floor);
  Part above = MakeShellPart(ceiling);
  Part skirting = MakeShellPart(trim);
  const Vector3d low(-0.5 * size.x(), -0.5 * size.y(), 0.0);
  const Vector3d high(0.5 * size.x(), 0.5 * size.y(), size.z());
  // The floor is the top face of a box below it, the ceiling the bottom face of a box above it.
  AddRectangle(ground.mesh, {floor.size_m, {0, 0}, {}, kCell_m},
               BoxFace(low, {high.x(), high.y(), 0.0}, 4));
  AddRectangle(above.mesh, {ceiling.size_m, {0, 0}, {}, kCell_m},
               BoxFace({low.x(), low.y(), high.z()}, high, 5));
  // Textured wallpaper behind the bodies and a plain wall above it, so that corners are spread over
  // the image.
  const Texture paper = MakeTexture("wallpaper", look);
  const Texture calm = MakeTexture("embossed", look);
  const double rail = std::min(kRail_m, size.z());
  for (const Wall& wall : state.walls) {
    const Eigen::Vector2d offset(look.Uniform(), look.Uniform());
    Part lower = MakeShellPart(paper);
    AddRectangle(lower.mesh, {paper.size_m, offset, {}, kCell_m},
                 OnWall(wall, {{0, 0}, {wall.length_m, rail}}, 0.0));
    Part upper = MakeShellPart(calm);
    AddRectangle(upper.mesh, {calm.size_m, offset, {}, kCell_m},
                 OnWall(wall, {{0, rail}, {wall.length_m, size.z()}}, 0.0));
    const Pen trim_pen{trim.size_m, {look.Uniform(), 0}, {}, kCell_m};
    AddBoard(skirting.mesh, trim_pen, wall, {{0, 0}, {wall.length_m, 0.09}}, 0.015);
    AddBoard(skirting.mesh, trim_pen, wall, {{0, rail}, {wall.length_m, rail + 0.05}}, 0.012);
    state.out.shell.push_back(std::move(lower));
    state.out.shell.push_back(std::move(upper));
    Eigen::Vector4d plane;
    plane << wall.inward, -wall.inward.dot(wall.start);
    state.out.walls.push_back(plane);
  }
  state.out.walls.emplace_back(0, 0, 1, 0);
  state.out.walls.emplace_back(0, 0, -1, size.z());
  for (Part* part : {&ground, &above, &skirting}) state.out.shell.push_back(std::move(*part));
}

void AddCarpet(RoomState& state, Rng& look) {
  const Vector3d& size = state.room.size_m;
  const Vector3d half(0.27 * size.x(), 0.25 * size.y(), 0.0);
  Part part = MakeShellPart(MakeTexture("carpet", look));
  const Vector3d up(0, 0, 0.005);
  AddPicture(part.mesh, {{1, 1}, {0, 0}, {}, kCell_m}, BoxFace(-half, half + up, 4));
  state.out.shell.push_back(std::move(part));
}

// Adds a door in one wall and windows in two others. No furniture stands in front of the door.
void AddOpenings(RoomState& state, Rng& look) {
  const double height = state.room.size_m.z();
  Part frames = MakeShellPart(MakeSolidTexture({104, 74, 52}, look));
  const Pen pen{{1.28, 1.28}, {0, 0}, {}};
  const std::size_t first = look.UniformInt(4);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t index = (first + i) % 4;
    const Wall& wall = state.walls[index];
    const bool door = i == 0;
    const double width = door ? 0.9 : look.Uniform(0.9, 1.3);
    if (wall.length_m < width + 0.8 || height < 1.9) continue;
    const double at = look.Uniform(0.3, wall.length_m - width - 0.3);
    const Area hole{{at, door ? 0.0 : 0.95}, {at + width, std::min(2.05, height - 0.25)}};
    Part picture = MakeShellPart(door ? MakeDoorTexture(look) : MakeWindowViewTexture(look));
    AddPicture(picture.mesh, {{1, 1}, {0, 0}, {}, kCell_m}, OnWall(wall, hole, 0.012));
    AddFrame(frames.mesh, pen, wall, hole);
    if (!door) {
      const double middle = at + 0.5 * width;
      AddBoard(frames.mesh, pen, wall, {{middle - 0.02, 0.95}, {middle + 0.02, hole.high.y()}},
               0.03);
      AddBoard(frames.mesh, pen, wall, {{at - 0.1, 0.9}, {at + width + 0.1, 0.95}}, 0.05);
    } else {
      const Vector3d a = wall.start + at * wall.right;
      const Vector3d b = a + width * wall.right + 0.7 * wall.inward;
      state.floor_taken.push_back({a.cwiseMin(b).head<2>(), a.cwiseMax(b).head<2>()});
    }
    state.wall_taken[index].push_back(
        {hole.low - Vector2d(0.12, 0.1), hole.high + Vector2d(0.12, 0.1)});
    state.out.shell.push_back(std::move(picture));
  }
  state.out.shell.push_back(std::move(frames));
}

// A piece of furniture, with x away from the wall, y along it and z up.
struct Piece {
  std::string kind;
  Vector3d size_m;
};

bool TryPlace(RoomState& state, const Piece& piece, std::size_t index, double at, Rng& look) {
  constexpr double kGap_m = 0.03;  // to the wall, for the skirting
  const Wall& wall = state.walls[index];
  const Vector3d a = wall.start + at * wall.right + kGap_m * wall.inward;
  const Vector3d b = a + piece.size_m.y() * wall.right + piece.size_m.x() * wall.inward;
  const Area floor{a.cwiseMin(b).head<2>(), a.cwiseMax(b).head<2>()};
  const Area against{{at, 0.0}, {at + piece.size_m.y(), piece.size_m.z()}};
  if (!IsFree(floor, state.floor_taken, 0.06)) return false;
  if (!IsFree(against, state.wall_taken[index], 0.0)) return false;
  Eigen::Matrix3d turn;
  turn << wall.inward, Vector3d::UnitZ().cross(wall.inward), Vector3d::UnitZ();
  const Vector3d middle = 0.5 * (a + b) + Vector3d(0, 0, 0.5 * piece.size_m.z());
  ModelDescription description;
  description.kind = piece.kind;
  description.size_m = piece.size_m;
  state.out.placed.push_back({MakeModel(description, look), RigidTransform(turn, middle)});
  state.floor_taken.push_back(floor);
  state.wall_taken[index].push_back(against);
  return true;
}

bool PlaceSomewhere(RoomState& state, const Piece& piece, Rng& look) {
  for (int attempt = 0; attempt < 200; ++attempt) {
    const std::size_t index = look.UniformInt(4);
    const double room = state.walls[index].length_m - piece.size_m.y() - 0.06;
    if (room < 0.0) continue;
    if (TryPlace(state, piece, index, 0.03 + look.Uniform(0.0, room), look)) return true;
  }
  for (std::size_t index = 0; index < 4; ++index) {
    const double room = state.walls[index].length_m - piece.size_m.y() - 0.06;
    for (double at = 0.0; at <= room; at += 0.05) {
      if (TryPlace(state, piece, index, 0.03 + at, look)) return true;
    }
  }
  return false;
}

// How deep, wide and high the pieces of a kind are.
struct Assortment {
  const char* kind;
  int count;
  Vector3d least_m;
  Vector3d most_m;
};

// Returns false if a piece does not fit.
bool AddFurniture(RoomState& state, Rng& look) {
  const RoomDescription& room = state.room;
  const double depth = room.furniture_depth_m - 0.03;
  const double tallest = room.size_m.z() - 0.25;
  for (const Assortment& kind :
       {Assortment{"shelf", room.shelves, {0.28, 0.8, 1.4}, {0.36, 1.15, 2.1}},
        Assortment{"table", room.tables, {0.45, 0.9, 0.85}, {0.6, 1.25, 0.98}},
        Assortment{"crate", room.crates, {0.32, 0.35, 0.3}, {0.46, 0.6, 0.5}}}) {
    for (int i = 0; i < kind.count; ++i) {
      Vector3d size_m;
      for (int k = 0; k < 3; ++k) size_m[k] = look.Uniform(kind.least_m[k], kind.most_m[k]);
      size_m = size_m.cwiseMin(Vector3d(depth, size_m.y(), tallest));
      if (!PlaceSomewhere(state, {kind.kind, size_m}, look)) return false;
    }
  }
  return true;
}

// Puts posters on free parts of the walls. A poster that does not fit is left out.
void AddPosters(RoomState& state, Rng& look) {
  const double height = state.room.size_m.z();
  for (int i = 0; i < state.room.posters; ++i) {
    const Texture picture = MakeTexture("poster", look);
    const double width = look.Uniform(0.4, 0.75);
    const double tall = std::min(0.5 * height, width * look.Uniform(0.8, 1.4));
    for (int attempt = 0; attempt < 60; ++attempt) {
      const std::size_t index = look.UniformInt(4);
      const Wall& wall = state.walls[index];
      const double room = wall.length_m - width - 0.2;
      const double rise = height - tall - 0.15;
      if (room < 0.0 || rise < 0.3) continue;
      const double at = 0.1 + look.Uniform(0.0, room);
      const double low = look.Uniform(std::min(0.6, 0.5 * rise), rise);
      const Area area{{at, low}, {at + width, low + tall}};
      if (!IsFree(area, state.wall_taken[index], 0.06)) continue;
      Part part = MakeShellPart(picture);
      AddPicture(part.mesh, {{1, 1}, {0, 0}, {}, kCell_m}, OnWall(wall, area, 0.012));
      state.out.shell.push_back(std::move(part));
      state.wall_taken[index].push_back(area);
      break;
    }
  }
}

}  // namespace

Surroundings MakeRoom(const RoomDescription& room, Rng& look) {
  if (room.size_m.head<2>().minCoeff() < 2.0 || room.size_m.z() < 1.8) {
    ThrowError("room.size_m", StrCat(room.size_m.transpose()),
               "at least 2 m by 2 m and 1.8 m high");
  }
  Rng own(look.NextU64(), "room");
  // Doors and windows may leave too little wall for the furniture. If so, try again.
  const double least_m = 0.8 * room.shelves + 0.9 * room.tables + 0.35 * room.crates;
  const int attempts = least_m < 2.0 * (room.size_m.x() + room.size_m.y()) ? 12 : 0;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    RoomState state{room, MakeWalls(room.size_m), {}, {}, {}};
    state.wall_taken.resize(state.walls.size());
    AddOpenings(state, own);
    if (!AddFurniture(state, own)) continue;
    AddShell(state, own);
    AddCarpet(state, own);
    AddPosters(state, own);
    return std::move(state.out);
  }
  ThrowError("room",
             StrCat("no place along the walls for ", room.shelves, " shelves, ", room.tables,
                    " tables and ", room.crates, " crates"),
             "a larger room or less furniture");
}

}  // namespace cvo::synth
