// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "synth/models/textures/painters.h"

namespace cvo::synth {
namespace {

cv::Point2f Jitter(double amount, Rng& rng) {
  const double x = rng.Uniform(-amount, amount);
  const double y = rng.Uniform(-amount, amount);
  return {static_cast<float>(x), static_cast<float>(y)};
}

struct SpotOptions {
  double smallest_px;  // radii
  double largest_px;
  double apart_px;  // minimum distance of centres
};

// Draws separate random shapes, light on dark and dark on light. Each gives corners, even in
// shadow, and no two rows are the same.
void DrawSpots(cv::Mat& canvas, const SpotOptions& options, const Palette& palette, Rng& rng) {
  constexpr int kTrials = 3000;
  const cv::Mat ground = canvas.clone();
  const auto side = static_cast<float>(canvas.cols);
  std::vector<cv::Point2f> centres;
  for (int i = 0; i < kTrials; ++i) {
    const cv::Point2f at = RandomPoint(canvas.size(), rng);
    const bool near = std::any_of(centres.begin(), centres.end(), [&](const cv::Point2f& other) {
      const float dx = side / 2 - std::abs(std::abs(at.x - other.x) - side / 2);  // repeating
      const float dy = side / 2 - std::abs(std::abs(at.y - other.y) - side / 2);
      return std::hypot(dx, dy) < options.apart_px;
    });
    if (near) continue;
    centres.push_back(at);
    const cv::Vec3b under = ground.at<cv::Vec3b>(static_cast<int>(at.y), static_cast<int>(at.x));
    const bool dark = 0.299 * under[0] + 0.587 * under[1] + 0.114 * under[2] < 120.0;
    const Rgb colour = Mix(dark ? palette.light() : palette.dark(), palette.Any(rng), 0.1);
    const double radius = rng.Uniform(options.smallest_px, options.largest_px);
    DrawStamp(canvas, {at, radius, rng.Uniform(0.0, 6.28), colour}, rng);
  }
}

void DrawFlower(cv::Mat& canvas, cv::Point2f at, double radius, const Rgb& petal, const Rgb& heart,
                Rng& rng) {
  const int petals = 4 + static_cast<int>(rng.UniformInt(4));
  const double turn = rng.Uniform(0.0, 6.28);
  for (int i = 0; i < petals; ++i) {
    const double angle = turn + 2.0 * 3.14159265358979 * i / petals;
    const cv::Point2f out(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
    const cv::Point2f side(-out.y, out.x);
    const auto r = static_cast<float>(radius * rng.Uniform(0.85, 1.15));
    FillPolygon(canvas,
                {at + 0.15f * r * out, at + 0.65f * r * out + 0.28f * r * side, at + r * out,
                 at + 0.65f * r * out - 0.28f * r * side},
                petal);
  }
  FillDisc(canvas, at, 0.22 * radius, heart);
}

struct KilimRow {
  float top;
  float height;
  int shapes;
};

void DrawKilimRow(cv::Mat& canvas, const KilimRow& row, const Palette& palette, Rng& rng) {
  const auto side = static_cast<float>(canvas.cols);
  FillBox(canvas, {0, row.top, side, row.height}, Mix(palette.Any(rng), palette.dark(), 0.2));
  const float width = side / static_cast<float>(row.shapes);
  for (int i = 0; i < row.shapes; ++i) {
    const cv::Point2f at((static_cast<float>(i) + 0.5f) * width, row.top + 0.5f * row.height);
    for (const double part : {0.48, 0.3, 0.14}) {
      const auto w = static_cast<float>(part * width * rng.Uniform(0.8, 1.0));
      const auto h = static_cast<float>(part * row.height * rng.Uniform(0.8, 1.0));
      FillPolygon(canvas,
                  {at - cv::Point2f(w, 0), at - cv::Point2f(0, h), at + cv::Point2f(w, 0),
                   at + cv::Point2f(0, h)},
                  Vary(palette.Any(rng), 0.15, rng));
    }
  }
}

// Flowers on a light ground. `contrast` blends from the ground (0) to their own colours (1).
Texture PaintFlowers(double contrast, Rng& rng) {
  const Palette& palette = RandomPalette(rng);
  const Rgb base = Vary(Mix(palette.light(), palette.Mid(rng), 0.12), 0.05, rng);
  const Rgb stem = Mix(base, palette.dark(), 0.75 * contrast);
  cv::Mat canvas = MakeCanvas({1024, 1024}, base);
  constexpr int kCells = 18;
  constexpr float kCell = 1024.0f / kCells;
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) {
      const cv::Point2f centre((static_cast<float>(column) + (row % 2 == 0 ? 0.3f : 0.8f)) * kCell,
                               (static_cast<float>(row) + 0.5f) * kCell);
      const cv::Point2f at = centre + Jitter(0.22 * kCell, rng);
      const Rgb& own = rng.Uniform() < 0.6 ? palette.Mid(rng) : palette.dark();
      if (rng.Uniform() < 0.5) DrawLine(canvas, at, centre + Jitter(0.6 * kCell, rng), 3.0, stem);
      const double radius = kCell * rng.Uniform(0.22, 0.42);
      const Rgb heart = Mix(base, palette.Any(rng), contrast);
      DrawFlower(canvas, at, radius, Mix(base, own, contrast), heart, rng);
    }
  }
  Shade(canvas, MakeNoise(canvas.size(), {4, 4}, 3, rng), 0.1);
  return {canvas, {2.56, 2.56}};
}

}  // namespace

Texture PaintFabric(Rng& rng) {
  const Palette& palette = RandomPalette(rng);
  cv::Mat canvas = MakeCanvas({256, 256}, Mix(palette.Mid(rng), palette.dark(), 0.7));
  DrawCollage(canvas, {0, 0, 256, 256}, {40.0, 80.0, 6}, palette, rng);
  DrawSpots(canvas, {6.0, 13.0, 22.0}, palette, rng);
  Shade(canvas, MakeNoise(canvas.size(), {64, 64}, 2, rng), 0.16);
  return {canvas, {0.64, 0.64}};
}

Texture PaintCarpet(Rng& rng) {
  const Palette& palette = RandomPalette(rng);
  cv::Mat canvas = MakeCanvas({512, 512}, palette.dark());
  for (float y = 0; y < 512.0f;) {
    auto height = static_cast<float>(48.0 * (1.0 + static_cast<double>(rng.UniformInt(3))));
    height = std::min(height, 512.0f - y);
    DrawKilimRow(canvas, {y, height, 4 + static_cast<int>(rng.UniformInt(4))}, palette, rng);
    y += height;
  }
  Shade(canvas, MakeNoise(canvas.size(), {24, 96}, 2, rng), 0.06);
  return {canvas, {2.0, 2.0}};
}

Texture PaintWallpaper(Rng& rng) { return PaintFlowers(0.6, rng); }

// Too faint for corners, which should be found on posters and bodies instead.
Texture PaintEmbossed(Rng& rng) { return PaintFlowers(0.06, rng); }

Texture PaintPoster(Rng& rng) {
  const Palette& palette = RandomPalette(rng);
  cv::Mat canvas = MakeCanvas({256, 256}, Vary(palette.Any(rng), 0.1, rng));
  DrawCollage(canvas, {0, 0, 256, 256}, {6.0, 100.0, 110}, palette, rng);
  Shade(canvas, MakeNoise(canvas.size(), {4, 4}, 3, rng), 0.2);
  const Rgb frame = rng.Uniform() < 0.5 ? palette.light() : palette.dark();
  for (const cv::Rect2f& edge : {cv::Rect2f(0, 0, 256, 9), cv::Rect2f(0, 247, 256, 9),
                                 cv::Rect2f(0, 0, 9, 256), cv::Rect2f(247, 0, 9, 256)}) {
    FillBox(canvas, edge, frame);
  }
  return {canvas, {0.7, 0.7}};
}

Texture PaintBlock(Rng& rng) {
  const Palette& palette = RandomPalette(rng);
  cv::Mat canvas = MakeCanvas({256, 256}, palette.Mid(rng));
  DrawCollage(canvas, {0, 0, 256, 256}, {6.0, 75.0, 130}, palette, rng);
  Shade(canvas, MakeNoise(canvas.size(), {6, 6}, 3, rng), 0.25);
  return {canvas, {0.6, 0.6}};
}

}  // namespace cvo::synth
