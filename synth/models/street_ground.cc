// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/models/street_ground.h"

#include <algorithm>
#include <cmath>

#include "synth/models/mesh_builder.h"

namespace cvo::synth {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kGrass_m = -0.06;
constexpr double kPavement_m = 0.12;
constexpr double kMarking_m = 0.02;

Vector2d Beside(const Road& road, std::size_t index, double left_m) {
  const Vector2d& along = road.tangents[index];
  return road.line[index] + left_m * Vector2d(-along.y(), along.x());
}

Vector3d At(const Vector2d& p, double z) { return {p.x(), p.y(), z}; }

// The cell between two points of the centre line and two offsets to the left of it.
std::vector<Vector3d> Cell(const Road& road, std::size_t index, std::size_t end, double from_m,
                           double to_m, double z) {
  return {At(Beside(road, index, from_m), z), At(Beside(road, end, from_m), z),
          At(Beside(road, end, to_m), z), At(Beside(road, index, to_m), z)};
}

std::vector<Vector3d> Cell(const Road& road, std::size_t index, double from_m, double to_m,
                           double z) {
  return Cell(road, index, index + 1, from_m, to_m, z);
}

// Returns the end of the straight stretch of road that begins at `index`, within a few metres.
std::size_t EndOfStretch(const Road& road, std::size_t index) {
  constexpr std::size_t kLongest = 8;
  std::size_t end = index + 1;
  while (end + 1 < road.line.size() && end < index + kLongest &&
         road.tangents[end + 1].dot(road.tangents[index]) > 1.0 - 1e-9 &&
         road.tangents[end].dot(road.tangents[index]) > 1.0 - 1e-9) {
    ++end;
  }
  return end;
}

Vector2d MiddleOf(const std::vector<Vector3d>& corners) {
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& p : corners) sum += p;
  return (sum / static_cast<double>(corners.size())).head<2>();
}

Pen PenFor(const Texture& texture) { return {texture.size_m, {0, 0}, {}}; }

// Wider than the road itself, so that it shows where pavements leave gaps at crossings.
Part MakeCarriageways(const StreetMap& map, const Texture& asphalt) {
  Part part = MakeShellPart(asphalt);
  for (const Road& road : map.roads) {
    const double edge = road.half_width_m + 0.6;
    for (std::size_t i = 0, end = 0; i + 1 < road.line.size(); i = end) {
      end = EndOfStretch(road, i);
      AddGround(part.mesh, PenFor(asphalt), Cell(road, i, end, -edge, edge, 0.0));
    }
  }
  return part;
}

void AddPavementCell(Mesh& mesh, const Texture& slabs, const StreetMap& map, int road,
                     const std::vector<Vector3d>& corners) {
  if (map.IsOnRoad(MiddleOf(corners), 0.0, road)) return;
  AddGround(mesh, PenFor(slabs), corners);
}

Part MakePavements(const StreetMap& map, const Texture& slabs) {
  Part part = MakeShellPart(slabs);
  const int strips = std::max(1, static_cast<int>(std::ceil(map.pavement_m / 0.75)));
  const double width = map.pavement_m / strips;
  for (int r = 0; r < static_cast<int>(map.roads.size()); ++r) {
    const Road& road = map.roads[r];
    const double far = road.half_width_m + map.pavement_m;
    for (std::size_t i = 0, end = 0; i + 1 < road.line.size(); i = end) {
      end = EndOfStretch(road, i);
      // In one piece, unless the carriageway of another road may have to be cut out.
      if (!map.IsOnRoad(MiddleOf(Cell(road, i, end, -1.0, 1.0, 0.0)), far + 5.0, r)) {
        AddGround(part.mesh, PenFor(slabs),
                  Cell(road, i, end, road.half_width_m, far, kPavement_m));
        AddGround(part.mesh, PenFor(slabs),
                  Cell(road, i, end, -far, -road.half_width_m, kPavement_m));
        continue;
      }
      end = i + 1;
      for (int strip = 0; strip < strips; ++strip) {
        const double near = road.half_width_m + strip * width;
        AddPavementCell(part.mesh, slabs, map, r, Cell(road, i, near, near + width, kPavement_m));
        AddPavementCell(part.mesh, slabs, map, r, Cell(road, i, -near - width, -near, kPavement_m));
      }
    }
  }
  return part;
}

// Upright stones between carriageway and pavement, with a lip on top.
Part MakeKerbs(const StreetMap& map, const Texture& stone) {
  Part part = MakeShellPart(stone);
  for (int r = 0; r < static_cast<int>(map.roads.size()); ++r) {
    const Road& road = map.roads[r];
    for (const double sign : {1.0, -1.0}) {
      double along = 0.0;
      for (std::size_t i = 0; i + 1 < road.line.size(); ++i) {
        const Vector2d a = Beside(road, i, sign * road.half_width_m);
        const Vector2d b = Beside(road, i + 1, sign * road.half_width_m);
        const double length = (b - a).norm();
        along += length;
        if (length < 1e-6 || map.IsOnRoad(0.5 * (a + b), 0.0, r)) continue;
        const bool left = sign > 0.0;
        Pen pen = PenFor(stone);
        pen.uv_offset.x() = along / stone.size_m.x();
        AddRectangle(part.mesh, pen,
                     {At(left ? a : b, kPavement_m + 0.02),
                      At(left ? b - a : a - b, 0.0),
                      {0, 0, -kPavement_m - 0.02}});
        const double edge = sign * road.half_width_m;
        AddGround(part.mesh, pen,
                  Cell(road, i, std::min(edge, edge + 0.2 * sign),
                       std::max(edge, edge + 0.2 * sign), kPavement_m + 0.02));
      }
    }
  }
  return part;
}

// Dashes in the middle and lines along the sides.
Part MakeMarkings(const StreetMap& map, const Texture& paint) {
  Part part = MakeShellPart(paint);
  const Pen pen = PenFor(paint);
  for (int r = 0; r < static_cast<int>(map.roads.size()); ++r) {
    const Road& road = map.roads[r];
    const double side = road.half_width_m - 0.35;
    for (std::size_t i = 0; i + 1 < road.line.size(); ++i) {
      if (map.IsOnRoad(road.line[i], 0.8, r) || map.IsOnRoad(road.line[i + 1], 0.8, r)) continue;
      if (i % 6 < 3) AddGround(part.mesh, pen, Cell(road, i, -0.07, 0.07, kMarking_m));
      for (const double left : {side - 0.06, -side - 0.06}) {
        if (i % 9 == 8) continue;
        AddGround(part.mesh, pen, Cell(road, i, left, left + 0.12, kMarking_m));
      }
    }
  }
  return part;
}

Part MakeGrass(const StreetMap& map, const Texture& grass) {
  constexpr double kMargin_m = 150.0;
  constexpr double kCell_m = 12.0;
  Vector2d low = map.roads.front().line.front();
  Vector2d high = low;
  for (const Road& road : map.roads) {
    for (const Vector2d& p : road.line) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  Part part = MakeShellPart(grass);
  const Pen pen = PenFor(grass);
  for (double x = low.x() - kMargin_m; x < high.x() + kMargin_m; x += kCell_m) {
    for (double y = low.y() - kMargin_m; y < high.y() + kMargin_m; y += kCell_m) {
      AddGround(part.mesh, pen,
                {{x, y, kGrass_m},
                 {x + kCell_m, y, kGrass_m},
                 {x + kCell_m, y + kCell_m, kGrass_m},
                 {x, y + kCell_m, kGrass_m}});
    }
  }
  return part;
}

}  // namespace

std::vector<Part> MakeStreetGround(const StreetMap& map, Rng& look) {
  std::vector<Part> parts;
  parts.push_back(MakeGrass(map, MakeTexture("grass", look)));
  parts.push_back(MakeCarriageways(map, MakeTexture("asphalt", look)));
  parts.push_back(MakePavements(map, MakeTexture("pavement", look)));
  parts.push_back(MakeKerbs(map, MakeTexture("concrete", look)));
  parts.push_back(MakeMarkings(map, MakeSolidTexture({226, 224, 214}, look)));
  return parts;
}

}  // namespace cvo::synth
