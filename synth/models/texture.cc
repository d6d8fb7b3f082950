// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "synth/models/build.h"
#include "synth/models/canvas.h"
#include "synth/models/model.h"

namespace cvo::synth {
namespace {

constexpr int kTile = 256;
constexpr int kBlock = 16;  // side of a block of texels that share a list of leaves

// A shape on the unit sphere, in the tangent plane at `centre`.
struct SphereLeaf {
  Eigen::Vector3f centre;
  Eigen::Vector3f across;  // tangent axes
  Eigen::Vector3f up;
  float radius;
  int kind;  // disc, box, triangle, half disc, ring, cross
  cv::Vec3b colour;
};

Eigen::Vector3f RandomDirection(Rng& rng) {
  const double x = rng.Normal();
  const double y = rng.Normal();
  const double z = rng.Normal();
  return Eigen::Vector3d(x, y, z).normalized().cast<float>();
}

bool Covers(const SphereLeaf& leaf, const Eigen::Vector3f& direction) {
  const float x = leaf.across.dot(direction) / leaf.radius;
  const float y = leaf.up.dot(direction) / leaf.radius;
  const float square = x * x + y * y;
  if (leaf.centre.dot(direction) <= 0.0f || square > 1.0f) return false;
  switch (leaf.kind) {
    case 1:
      return std::max(std::abs(x), std::abs(y)) < 0.7f;
    case 2:
      return y > -0.5f && std::abs(x) * 1.732f < 1.0f - y;
    case 3:
      return y > 0.0f;
    case 4:
      return square > 0.36f;
    case 5:
      return std::min(std::abs(x), std::abs(y)) < 0.3f;
    default:
      return true;
  }
}

// Makes leaves from top (small) to bottom. The colour of the last is also the background.
std::vector<SphereLeaf> MakeLeaves(Rng& rng) {
  const Palette& palette = RandomPalette(rng);
  constexpr double kSmallest = 0.045;
  constexpr double kLargest = 0.45;
  std::vector<SphereLeaf> leaves(190);
  for (SphereLeaf& leaf : leaves) {
    leaf.centre = RandomDirection(rng);
    leaf.across = leaf.centre.cross(RandomDirection(rng)).normalized();
    leaf.up = leaf.centre.cross(leaf.across);
    const double t = rng.Uniform();
    leaf.radius = static_cast<float>(kSmallest * std::pow(kLargest / kSmallest, t * t));
    leaf.kind = static_cast<int>(rng.UniformInt(6));
    const Rgb colour = Vary(palette.Any(rng), 0.1, rng);
    for (int c = 0; c < 3; ++c) leaf.colour[c] = cv::saturate_cast<uchar>(colour[c]);
  }
  std::sort(leaves.begin(), leaves.end(),
            [](const SphereLeaf& a, const SphereLeaf& b) { return a.radius < b.radius; });
  return leaves;
}

Eigen::Vector3f TexelDirection(int face, double x, double y) {
  const double u = (2.0 * (x + 0.5) / kTile - 1.0) / kBallTileFill;
  const double v = (2.0 * (y + 0.5) / kTile - 1.0) / kBallTileFill;
  return CubeDirection(face, u, v).cast<float>();
}

void PaintBlockOfTile(cv::Mat& tile, int face, cv::Point corner,
                      const std::vector<SphereLeaf>& leaves, const cv::Vec3b& ground) {
  const double half = 0.5 * (kBlock - 1);
  const Eigen::Vector3f middle = TexelDirection(face, corner.x + half, corner.y + half);
  constexpr float kReach = 0.13f;  // more than half a block's diagonal, on the sphere
  std::vector<const SphereLeaf*> near;
  for (const SphereLeaf& leaf : leaves) {
    if ((leaf.centre - middle).norm() < 1.1f * leaf.radius + kReach) near.push_back(&leaf);
  }
  for (int y = corner.y; y < corner.y + kBlock; ++y) {
    for (int x = corner.x; x < corner.x + kBlock; ++x) {
      const Eigen::Vector3f direction = TexelDirection(face, x, y);
      const auto top = std::find_if(near.begin(), near.end(), [&](const SphereLeaf* leaf) {
        return Covers(*leaf, direction);
      });
      tile.at<cv::Vec3b>(y, x) = top == near.end() ? ground : (*top)->colour;
    }
  }
}

constexpr int kSide_px = 512;
constexpr int kCells = 10;  // along each side, with a decal in each
constexpr float kCell_px = static_cast<float>(kSide_px) / kCells;

// Colours of a car. The prints differ strongly from the ground in brightness.
struct Livery {
  Rgb ground;
  Rgb band;
  std::array<Rgb, 3> prints;
  const Rgb& Print(Rng& rng) const { return prints[rng.UniformInt(3)]; }
};

float GreyOf(const Rgb& rgb) { return 0.299f * rgb[0] + 0.587f * rgb[1] + 0.114f * rgb[2]; }

Livery MakeLivery(Rng& rng) {
  const std::vector<Rgb> grounds = {{236, 234, 228}, {214, 60, 48},   {40, 74, 140},
                                    {240, 190, 60},  {34, 110, 104},  {168, 176, 184},
                                    {120, 40, 60},   {232, 128, 56},  {88, 132, 80},
                                    {52, 56, 66},    {120, 170, 206}, {226, 214, 184}};
  const Palette& palette = RandomPalette(rng);
  Livery livery;
  livery.ground = Vary(grounds[rng.UniformInt(grounds.size())], 0.06, rng);
  const bool is_light = GreyOf(livery.ground) > 120.0f;
  const Rgb ink = is_light ? Rgb(22, 26, 36) : Rgb(250, 248, 240);
  livery.band = Mix(livery.ground, is_light ? Rgb(255, 255, 255) : Rgb(0, 0, 0), 0.25);
  Rgb accent = palette.Mid(rng);
  while (std::abs(GreyOf(accent) - GreyOf(livery.ground)) < 90.0f) accent = Mix(accent, ink, 0.25);
  livery.prints = {ink, is_light ? palette.dark() : palette.light(), accent};
  return livery;
}

// Draws a row of letters, horizontal or turned by 90 degrees.
void DrawWord(cv::Mat& canvas, cv::Point2f middle, double radius_px, const Rgb& colour, Rng& rng) {
  const int letters = 3 + static_cast<int>(rng.UniformInt(2));
  const auto radius = static_cast<float>(radius_px);
  const bool lies = rng.Uniform() < 0.5;
  for (int i = 0; i < letters; ++i) {
    const float along = (static_cast<float>(i) - 0.5f * static_cast<float>(letters - 1)) * 2.1f;
    const cv::Point2f at =
        middle + radius * (lies ? cv::Point2f(0.0f, along) : cv::Point2f(along, 0.0f));
    DrawStamp(canvas, {at, radius, lies ? 1.5708 : 0.0, colour}, rng);
  }
}

// Draws a disc or a plate with a sign on it.
void DrawBadge(cv::Mat& canvas, cv::Point2f middle, const Livery& livery, Rng& rng) {
  const double radius = rng.Uniform(12.0, 19.0);
  const Rgb& colour = livery.Print(rng);
  if (rng.Uniform() < 0.5) {
    FillDisc(canvas, middle, radius, colour);
  } else {
    const auto half = static_cast<float>(radius);
    FillBox(canvas, {middle.x - half, middle.y - 0.8f * half, 2.0f * half, 1.6f * half}, colour);
  }
  DrawStamp(canvas,
            {middle, 0.62 * radius, 0.7854 * static_cast<double>(rng.UniformInt(8)), livery.ground},
            rng);
}

void DrawDecal(cv::Mat& canvas, cv::Point2f middle, const Livery& livery, Rng& rng) {
  const double kind = rng.Uniform();
  if (kind < 0.35) {
    DrawWord(canvas, middle, rng.Uniform(5.0, 7.0), livery.Print(rng), rng);
  } else if (kind < 0.6) {
    DrawBadge(canvas, middle, livery, rng);
  } else {
    const double radius = rng.Uniform(9.0, 18.0);
    DrawStamp(canvas, {middle, radius, rng.Uniform(0.0, 6.28), livery.Print(rng)}, rng);
    const cv::Point2f beside = middle + cv::Point2f(static_cast<float>(rng.Uniform(-20.0, 20.0)),
                                                    static_cast<float>(rng.Uniform(-20.0, 20.0)));
    DrawStamp(canvas, {beside, rng.Uniform(4.0, 8.0), rng.Uniform(0.0, 6.28), livery.Print(rng)},
              rng);
  }
}

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

Texture MakeBallTexture(Rng& look) {
  const std::vector<SphereLeaf> leaves = MakeLeaves(look);
  const cv::Vec3b ground = leaves.back().colour;
  cv::Mat atlas(2 * kTile, 4 * kTile, CV_8UC3, cv::Scalar(128, 128, 128));
  for (int face = 0; face < 6; ++face) {
    cv::Mat tile = atlas(cv::Rect((face % 4) * kTile, (face / 4) * kTile, kTile, kTile));
    for (int y = 0; y < kTile; y += kBlock) {
      for (int x = 0; x < kTile; x += kBlock) PaintBlockOfTile(tile, face, {x, y}, leaves, ground);
    }
  }
  return {atlas, {1.2, 0.6}};
}

// A car covered with large prints: small ones give too few corners to track a body of some hundred
// pixels.
Texture PaintCarPaint(Rng& rng) {
  const Livery livery = MakeLivery(rng);
  cv::Mat canvas = MakeCanvas({kSide_px, kSide_px}, livery.ground);
  for (int i = 0; i < 2; ++i) {
    const auto y = static_cast<float>(rng.Uniform(0.0, kSide_px));
    FillBox(canvas, {0, y, kSide_px, static_cast<float>(rng.Uniform(20.0, 50.0))}, livery.band);
  }
  Stain(canvas, MakeNoise(canvas.size(), {6, 6}, 4, rng), 0.15, 0.4, {120, 108, 92}, 0.45);
  for (int i = 0; i < 110; ++i) {
    const cv::Point2f at = RandomPoint(canvas.size(), rng);
    DrawWord(canvas, at, rng.Uniform(2.6, 4.2), livery.Print(rng), rng);
  }
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) {
      const cv::Point2f middle((static_cast<float>(column) + 0.5f) * kCell_px,
                               (static_cast<float>(row) + 0.5f) * kCell_px);
      const cv::Point2f shift(static_cast<float>(rng.Uniform(-9.0, 9.0)),
                              static_cast<float>(rng.Uniform(-9.0, 9.0)));
      DrawDecal(canvas, middle + shift, livery, rng);
    }
  }
  return {canvas, {2.56, 2.56}};
}

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
