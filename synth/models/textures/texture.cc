// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/models/textures/texture.h"

#include "core/base/error.h"
#include "core/base/lists.h"
#include "synth/models/make_model.h"
#include "synth/models/textures/painters.h"

namespace cvo::synth {
namespace {

struct Material {
  const char* name;
  Texture (*paint)(Rng&);
};

constexpr Material kMaterials[] = {
    {"asphalt", PaintAsphalt},   {"ball", MakeBallTexture},     {"bark", PaintBark},
    {"block", PaintBlock},       {"brick", PaintBrick},         {"carpet", PaintCarpet},
    {"concrete", PaintConcrete}, {"embossed", PaintEmbossed},   {"fabric", PaintFabric},
    {"facade", PaintFacade},     {"grass", PaintGrass},         {"leaves", PaintLeaves},
    {"paint", PaintCarPaint},    {"parquet", PaintParquet},     {"pavement", PaintPavement},
    {"plaster", PaintPlaster},   {"poster", PaintPoster},       {"roof", PaintRoof},
    {"tiles", PaintTiles},       {"wallpaper", PaintWallpaper}, {"wood", PaintWood}};

}  // namespace

const std::vector<std::string>& MaterialNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Material& material : kMaterials) all.emplace_back(material.name);
    return all;
  }();
  return names;
}

Texture MakeTexture(const std::string& material, Rng& look) {
  // A separate stream, so that the number of draws for one texture does not change the next.
  Rng own(look.NextU64(), material);
  for (const Material& known : kMaterials) {
    if (material == known.name) return known.paint(own);
  }
  ThrowError("material", "'" + material + "'", "one of " + Joined(MaterialNames(), ", "));
}

}  // namespace cvo::synth
