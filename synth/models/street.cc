// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "synth/models/builders.h"
#include "synth/models/street_ground.h"
#include "synth/models/street_map.h"
#include "synth/models/surroundings.h"

namespace cvo::synth {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

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

// A place beside a road, with x along the road and y away from it.
struct Place {
  Vector2d kerb;     // point on the edge of the carriageway
  Vector2d forward;  // along the road
  Vector2d away;     // away from the road
};

Place PlaceAt(const StreetState& state, const Side& side, std::size_t index) {
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
bool TryBuilding(StreetState& state, const Place& place, const Vector3d& size, Rng& look) {
  const double setback = state.map.pavement_m + look.Uniform(0.4, 2.2);
  const Vector2d middle = place.kerb + (setback + 0.5 * size.x()) * place.away;
  const Plot plot{middle, -place.away, {0.5 * size.x(), 0.5 * size.y()}};
  if (!state.map.IsFree(plot, state.map.pavement_m + 0.2)) return false;
  state.map.plots.push_back(plot);
  const Texture& facade = AnyOf(state.textures.facades, look);
  const Texture& roof = AnyOf(state.textures.roofs, look);
  PutOnGround(state, MakeBuilding(size, facade, roof, look), middle, -place.away);
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
      const Place place = PlaceAt(state, side, middle);
      built = TryBuilding(state, place, {depth, width, 3.0 * floors + 0.5}, look);
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
  const Place place = PlaceAt(state, side, index);
  const Vector2d middle = place.kerb + thing.out_m * place.away;
  const Plot plot{middle, -place.away, {thing.half_m, thing.half_m}};
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
    const Place place = PlaceAt(state, side, index);
    const Texture& leaves = AnyOf(state.textures.leaves, look);
    PutOnGround(state,
                MakeTree({2.0 * half, 2.0 * half, height}, leaves, state.textures.bark, look),
                place.kerb + out * place.away, -place.away);
  }
}

void AddPosts(StreetState& state, const Side& side, Rng& look) {
  const auto points = state.map.roads[side.road].line.size();
  for (double at = look.Uniform(2.0, 12.0); at < static_cast<double>(points);
       at += look.Uniform(9.0, 16.0)) {
    const auto index = static_cast<std::size_t>(at);
    const Place place = PlaceAt(state, side, index);
    if (look.Uniform() < 0.45) {
      if (!TakePlot(state, side, index, {0.98, 0.8})) continue;
      PutOnGround(state,
                  MakeLampPost(look.Uniform(5.0, 5.6), state.textures.metal, state.textures.lamp),
                  place.kerb + 0.98 * place.away, -place.away);
    } else {
      if (!TakePlot(state, side, index, {0.85, 0.65})) continue;
      const Texture& picture = AnyOf(state.textures.pictures, look);
      PutOnGround(state, MakeSign(picture, state.textures.metal, look),
                  place.kerb + 0.85 * place.away, -side.sign * place.forward);
    }
  }
}

// Adds hedges where there is no building.
void AddHedges(StreetState& state, const Side& side, Rng& look) {
  const auto points = state.map.roads[side.road].line.size();
  for (std::size_t index = 2; index < points; index += 4) {
    const Place place = PlaceAt(state, side, index);
    const double length = look.Uniform(3.2, 3.9);
    const Vector3d size(0.7, length, look.Uniform(0.8, 1.5));
    const Vector2d middle = place.kerb + (state.map.pavement_m + 0.5 + 0.5 * size.x()) * place.away;
    const Plot plot{middle, -place.away, {0.5 * size.x(), 0.5 * size.y()}};
    if (!state.map.IsFree(plot, state.map.pavement_m + 0.1)) continue;
    state.map.plots.push_back(plot);
    const Texture& leaves = AnyOf(state.textures.leaves, look);
    PutOnGround(state, MakeHedge(size, leaves, look), middle, -place.away);
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
