// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "synth/models/cube_map.h"
#include "synth/models/textures/painters.h"

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

}  // namespace cvo::synth
