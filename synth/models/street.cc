// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "synth/models/build.h"
#include "synth/models/model.h"

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
  constexpr double kGrassCell_m = 12.0;
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
  for (double x = low.x() - kMargin_m; x < high.x() + kMargin_m; x += kGrassCell_m) {
    for (double y = low.y() - kMargin_m; y < high.y() + kMargin_m; y += kGrassCell_m) {
      AddGround(part.mesh, pen,
                {{x, y, kGrass_m},
                 {x + kGrassCell_m, y, kGrass_m},
                 {x + kGrassCell_m, y + kGrassCell_m, kGrass_m},
                 {x, y + kGrassCell_m, kGrass_m}});
    }
  }
  return part;
}

std::vector<Part> MakeStreetGround(const StreetMap& map, Rng& look) {
  std::vector<Part> parts;
  parts.push_back(MakeGrass(map, MakeTexture("grass", look)));
  parts.push_back(MakeCarriageways(map, MakeTexture("asphalt", look)));
  parts.push_back(MakePavements(map, MakeTexture("pavement", look)));
  parts.push_back(MakeKerbs(map, MakeTexture("concrete", look)));
  parts.push_back(MakeMarkings(map, MakeSolidTexture({226, 224, 214}, look)));
  return parts;
}

// Textures that many models share.
struct StreetTextures {
  std::vector<Texture> facades;
  std::vector<Texture> roofs;
  std::vector<Texture> leaves;
  std::vector<Texture> pictures;
  Texture bark;
  Texture metal;
  Texture lamp;
};

std::vector<Texture> MakeTextures(const char* material, int count, Rng& look) {
  std::vector<Texture> textures;
  for (int i = 0; i < count; ++i) textures.push_back(MakeTexture(material, look));
  return textures;
}

StreetTextures MakeStreetTextures(Rng& look) {
  StreetTextures textures;
  textures.facades = MakeTextures("facade", 8, look);
  textures.roofs = MakeTextures("roof", 2, look);
  textures.leaves = MakeTextures("leaves", 4, look);
  textures.pictures = MakeTextures("poster", 6, look);
  textures.bark = MakeTexture("bark", look);
  textures.metal = MakeSolidTexture({70, 74, 80}, look);
  textures.lamp = MakeSolidTexture({236, 230, 206}, look);
  return textures;
}

const Texture& AnyOf(const std::vector<Texture>& textures, Rng& look) {
  return textures[look.UniformInt(textures.size())];
}

struct StreetState {
  const StreetDescription& street;
  StreetMap map;
  StreetTextures textures;
  Surroundings out;
};

// One side of one road.
struct Side {
  int road;
  double sign;  // 1: to the left of the road's direction, -1: to the right
};

// A spot beside a road, with x along the road and y away from it.
struct Spot {
  Vector2d kerb;     // point on the edge of the carriageway
  Vector2d forward;  // along the road
  Vector2d away;     // away from the road
};

Spot SpotAt(const StreetState& state, const Side& side, std::size_t index) {
  const Road& road = state.map.roads[side.road];
  const Vector2d& forward = road.tangents[index];
  const Vector2d away = side.sign * Vector2d(-forward.y(), forward.x());
  return {road.line[index] + road.half_width_m * away, forward, away};
}

// Puts the model on the ground with its x axis along `front`.
void PutOnGround(StreetState& state, Model model, const Vector2d& at, const Vector2d& front) {
  Eigen::Matrix3d turn;
  turn << front.x(), -front.y(), 0, front.y(), front.x(), 0, 0, 0, 1;
  const Vector3d middle(at.x(), at.y(), 0.5 * model.size_m.z());
  state.out.placed.push_back({std::move(model), RigidTransform(turn, middle)});
}

// Tries to add a building with depth `size.x()` away from the road and width `size.y()` along it.
bool TryBuilding(StreetState& state, const Spot& spot, const Vector3d& size, Rng& look) {
  const double setback = state.map.pavement_m + look.Uniform(0.4, 2.2);
  const Vector2d middle = spot.kerb + (setback + 0.5 * size.x()) * spot.away;
  const Plot plot{middle, -spot.away, {0.5 * size.x(), 0.5 * size.y()}};
  if (!state.map.IsFree(plot, state.map.pavement_m + 0.2)) return false;
  state.map.plots.push_back(plot);
  const Texture& facade = AnyOf(state.textures.facades, look);
  const Texture& roof = AnyOf(state.textures.roofs, look);
  PutOnGround(state, MakeBuilding(size, facade, roof, look), middle, -spot.away);
  return true;
}

void AddBuildings(StreetState& state, const Side& side, Rng& look) {
  const auto points = state.map.roads[side.road].line.size();
  std::size_t index = look.UniformInt(4);
  while (index < points) {
    const double floors =
        std::max(1.0, std::round(state.street.building_height_m / 3.0 * look.Uniform(0.65, 1.35)));
    const double depth = look.Uniform(7.0, 10.0);
    bool built = false;
    double width = 2.4 * static_cast<double>(4 + look.UniformInt(4)) + 0.5;
    for (; !built && width > 6.0; width -= 2.4) {
      const std::size_t middle = index + static_cast<std::size_t>(0.5 * width);
      if (middle >= points) continue;
      const Spot spot = SpotAt(state, side, middle);
      built = TryBuilding(state, spot, {depth, width, 3.0 * floors + 0.5}, look);
    }
    const double gap = look.Uniform() < 0.6 ? look.Uniform(0.3, 1.5) : look.Uniform(3.0, 8.0);
    index += built ? static_cast<std::size_t>(width + 2.4 + gap) + 1 : 3;
  }
}

// A thing on the pavement takes `half_m` around a point `out_m` from the kerb.
struct Furniture {
  double out_m;
  double half_m;
};

bool TakePlot(StreetState& state, const Side& side, std::size_t index, const Furniture& thing) {
  const Spot spot = SpotAt(state, side, index);
  const Vector2d middle = spot.kerb + thing.out_m * spot.away;
  const Plot plot{middle, -spot.away, {thing.half_m, thing.half_m}};
  if (state.map.IsOnRoad(middle, state.map.pavement_m + thing.half_m + 0.3, side.road))
    return false;
  if (!state.map.IsFree(plot, 0.15)) return false;
  state.map.plots.push_back(plot);
  return true;
}

void AddTrees(StreetState& state, const Side& side, Rng& look) {
  const auto points = state.map.roads[side.road].line.size();
  if (state.street.trees_per_100m <= 0.0) return;
  const double spacing = 100.0 / state.street.trees_per_100m;
  const double out = std::max(0.8, 0.6 * state.map.pavement_m);
  for (double at = look.Uniform(0.0, spacing); at < static_cast<double>(points);
       at += spacing * look.Uniform(0.75, 1.25)) {
    const auto index = static_cast<std::size_t>(at);
    const double half = std::min(out - 0.2, look.Uniform(0.9, 1.5));
    const double height = look.Uniform(4.5, 7.0);
    if (!TakePlot(state, side, index, {out, half})) continue;
    const Spot spot = SpotAt(state, side, index);
    const Texture& leaves = AnyOf(state.textures.leaves, look);
    PutOnGround(state,
                MakeTree({2.0 * half, 2.0 * half, height}, leaves, state.textures.bark, look),
                spot.kerb + out * spot.away, -spot.away);
  }
}

void AddPosts(StreetState& state, const Side& side, Rng& look) {
  const auto points = state.map.roads[side.road].line.size();
  for (double at = look.Uniform(2.0, 12.0); at < static_cast<double>(points);
       at += look.Uniform(9.0, 16.0)) {
    const auto index = static_cast<std::size_t>(at);
    const Spot spot = SpotAt(state, side, index);
    if (look.Uniform() < 0.45) {
      if (!TakePlot(state, side, index, {0.98, 0.8})) continue;
      PutOnGround(state,
                  MakeLampPost(look.Uniform(5.0, 5.6), state.textures.metal, state.textures.lamp),
                  spot.kerb + 0.98 * spot.away, -spot.away);
    } else {
      if (!TakePlot(state, side, index, {0.85, 0.65})) continue;
      const Texture& picture = AnyOf(state.textures.pictures, look);
      PutOnGround(state, MakeSign(picture, state.textures.metal, look),
                  spot.kerb + 0.85 * spot.away, -side.sign * spot.forward);
    }
  }
}

// Adds hedges where there is no building.
void AddHedges(StreetState& state, const Side& side, Rng& look) {
  const auto points = state.map.roads[side.road].line.size();
  for (std::size_t index = 2; index < points; index += 4) {
    const Spot spot = SpotAt(state, side, index);
    const double length = look.Uniform(3.2, 3.9);
    const Vector3d size(0.7, length, look.Uniform(0.8, 1.5));
    const Vector2d middle = spot.kerb + (state.map.pavement_m + 0.5 + 0.5 * size.x()) * spot.away;
    const Plot plot{middle, -spot.away, {0.5 * size.x(), 0.5 * size.y()}};
    if (!state.map.IsFree(plot, state.map.pavement_m + 0.1)) continue;
    state.map.plots.push_back(plot);
    const Texture& leaves = AnyOf(state.textures.leaves, look);
    PutOnGround(state, MakeHedge(size, leaves, look), middle, -spot.away);
  }
}

}  // namespace

Surroundings MakeStreet(const StreetDescription& street, Rng& look) {
  Rng own(look.NextU64(), "street");
  StreetState state{street, MakeStreetMap(street), MakeStreetTextures(own), {}};
  state.out.shell = MakeStreetGround(state.map, own);
  using Step = void (*)(StreetState&, const Side&, Rng&);
  for (const Step step : {Step{AddBuildings}, Step{AddTrees}, Step{AddPosts}, Step{AddHedges}}) {
    for (int road = 0; road < static_cast<int>(state.map.roads.size()); ++road) {
      for (const double sign : {1.0, -1.0}) step(state, {road, sign}, own);
    }
  }
  return std::move(state.out);
}

}  // namespace cvo::synth
