// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "synth/models/textures/painters.h"

namespace cvo::synth {
namespace {

cv::Point2f Jitter(double amount, Rng& rng) {
  const double x = rng.Uniform(-amount, amount);
  const double y = rng.Uniform(-amount, amount);
  return {static_cast<float>(x), static_cast<float>(y)};
}

// Broad stripes both ways, as in a plaid.
void DrawPlaid(cv::Mat& canvas, const Palette& palette, Rng& rng) {
  const auto side = static_cast<float>(canvas.cols);
  for (int i = 0; i < 5; ++i) {
    const Rgb colour = Vary(palette.Mid(rng), 0.15, rng);
    const auto at = static_cast<float>(rng.Uniform(0.0, side));
    const auto width = static_cast<float>(rng.Uniform(0.02, 0.07)) * side;
    if (i % 2 == 0) {
      FillBox(canvas, {at, 0, width, side}, colour);
    } else {
      FillBox(canvas, {0, at, side, width}, colour);
    }
  }
}

// A motif per cell of a loose grid, each with its own shapes, size, turn and colours.
void DrawMotifs(cv::Mat& canvas, int cells, const Palette& palette, Rng& rng) {
  const double cell = static_cast<double>(canvas.cols) / cells;
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      const double shift = row % 2 == 0 ? 0.25 : 0.75;
      const cv::Point2f centre(static_cast<float>((column + shift) * cell),
                               static_cast<float>((row + 0.5) * cell));
      const cv::Point2f at = centre + Jitter(0.14 * cell, rng);
      const double radius = cell * rng.Uniform(0.3, 0.5);
      const bool bright = rng.Uniform() < 0.5;  // one on the other, so that grey shows both
      const Rgb outer = Vary(bright ? palette.light() : palette.dark(), 0.2, rng);
      const Rgb inner = Mix(bright ? palette.dark() : palette.light(), palette.Any(rng), 0.3);
      DrawStamp(canvas, {at, radius, rng.Uniform(0.0, 6.28), outer}, rng);
      DrawStamp(canvas, {at, 0.5 * radius, rng.Uniform(0.0, 6.28), inner}, rng);
    }
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

}  // namespace

Texture PaintFabric(Rng& rng) {
  const Palette& palette = RandomPalette(rng);
  cv::Mat canvas = MakeCanvas({256, 256}, Vary(palette.Mid(rng), 0.15, rng));
  DrawPlaid(canvas, palette, rng);
  DrawMotifs(canvas, 12, palette, rng);
  Shade(canvas, MakeNoise(canvas.size(), {64, 64}, 2, rng), 0.16);
  return {canvas, {0.64, 0.64}};
}

Texture PaintCarpet(Rng& rng) {
  const Palette& palette = RandomPalette(rng);
  cv::Mat canvas = MakeCanvas({512, 512}, palette.dark());
  for (float y = 0; y < 512.0f;) {
    auto height = static_cast<float>(32.0 * (1.0 + static_cast<double>(rng.UniformInt(3))));
    height = std::min(height, 512.0f - y);
    DrawKilimRow(canvas, {y, height, 6 + static_cast<int>(rng.UniformInt(6))}, palette, rng);
    y += height;
  }
  Shade(canvas, MakeNoise(canvas.size(), {24, 96}, 2, rng), 0.2);
  return {canvas, {2.0, 2.0}};
}

Texture PaintWallpaper(Rng& rng) {
  const Palette& palette = RandomPalette(rng);
  const Rgb base = Vary(Mix(palette.light(), palette.Mid(rng), 0.12), 0.05, rng);
  const Rgb stem = Mix(base, palette.dark(), 0.45);
  cv::Mat canvas = MakeCanvas({1024, 1024}, base);
  constexpr int kCells = 12;
  constexpr float kCell = 1024.0f / kCells;
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) {
      const cv::Point2f centre((static_cast<float>(column) + (row % 2 == 0 ? 0.3f : 0.8f)) * kCell,
                               (static_cast<float>(row) + 0.5f) * kCell);
      const cv::Point2f at = centre + Jitter(0.22 * kCell, rng);
      const Rgb petal = Mix(base, rng.Uniform() < 0.8 ? palette.Mid(rng) : palette.dark(), 0.6);
      if (rng.Uniform() < 0.5) DrawLine(canvas, at, centre + Jitter(0.6 * kCell, rng), 3.0, stem);
      const double radius = kCell * rng.Uniform(0.2, 0.36);
      const Rgb heart = Mix(base, palette.Any(rng), 0.7);
      DrawFlower(canvas, at, radius, petal, heart, rng);
    }
  }
  Shade(canvas, MakeNoise(canvas.size(), {4, 4}, 3, rng), 0.1);
  return {canvas, {2.56, 2.56}};
}

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
