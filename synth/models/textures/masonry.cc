// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "synth/models/textures/painters.h"

namespace cvo::synth {
namespace {

// Draws one of a few patterns of cement tiles, in random rotation and colours.
void DrawTile(cv::Mat& canvas, const cv::Rect2f& box, const Palette& palette, Rng& rng) {
  const Rgb ground = Mix(palette.Any(rng), palette.light(), 0.5);
  FillBox(canvas, box, Vary(ground, 0.08, rng));
  const Rgb figure = Mix(palette.Any(rng), palette.light(), 0.25);
  const Rgb second = Mix(palette.Any(rng), palette.light(), 0.25);
  const cv::Point2f middle = 0.5f * (box.tl() + box.br());
  const double half = 0.5 * box.width;
  switch (rng.UniformInt(5)) {
    case 0:
      FillDisc(canvas, middle, 0.8 * half, figure);
      FillDisc(canvas, middle, 0.45 * half, second);
      break;
    case 1:
      FillPolygon(canvas, {box.tl(), {box.x + box.width, box.y}, {box.x, box.y + box.height}},
                  figure);
      break;
    case 2:
      for (const cv::Point2f& corner : {box.tl(), box.br()}) {
        FillPolygon(canvas, {corner, {middle.x, corner.y}, middle, {corner.x, middle.y}}, figure);
      }
      break;
    default:
      DrawStamp(canvas,
                {middle, 0.85 * half, 0.785 * static_cast<double>(rng.UniformInt(4)), figure}, rng);
      FillDisc(canvas, middle, 0.3 * half, second);
  }
}

}  // namespace

Texture PaintTiles(Rng& rng) {
  constexpr int kTiles = 16;
  constexpr float kSide = 512.0f / kTiles;
  const Palette& palette = RandomPalette(rng);
  const Rgb grout = Mix(palette.light(), {128, 124, 118}, 0.6);
  cv::Mat canvas = MakeCanvas({512, 512}, grout);
  for (int row = 0; row < kTiles; ++row) {
    for (int column = 0; column < kTiles; ++column) {
      const cv::Rect2f box(static_cast<float>(column) * kSide + 1.0f,
                           static_cast<float>(row) * kSide + 1.0f, kSide - 2.0f, kSide - 2.0f);
      DrawTile(canvas, box, palette, rng);
    }
  }
  Shade(canvas, MakeNoise(canvas.size(), {6, 6}, 4, rng), 0.25);
  return {canvas, {2.4, 2.4}};
}

Texture PaintBrick(Rng& rng) {
  constexpr int kRows = 24;
  constexpr int kColumns = 8;
  const std::vector<Rgb> clays = {{168, 88, 64}, {150, 74, 58}, {186, 128, 92}, {132, 92, 78}};
  const Rgb& clay = clays[rng.UniformInt(clays.size())];
  cv::Mat canvas = MakeCanvas({512, 512}, {204, 196, 184});
  const float height = 512.0f / kRows;
  const float width = 512.0f / kColumns;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const float shift = row % 2 == 0 ? 0.0f : 0.5f;
      const cv::Rect2f box((static_cast<float>(column) + shift) * width + 1.5f,
                           static_cast<float>(row) * height + 1.5f, width - 3.0f, height - 3.0f);
      const double kind = rng.Uniform();
      const Rgb brick = kind < 0.2    ? clay * 0.5f
                        : kind > 0.85 ? Mix(clay, {235, 215, 190}, 0.55)
                                      : Vary(clay, 0.22, rng);
      FillBox(canvas, box, brick);
      const int chips = static_cast<int>(rng.UniformInt(4));
      for (int i = 0; i < chips; ++i) {
        const cv::Point2f at = RandomPoint(box, rng);
        const double radius = rng.Uniform(2.5, 6.0);
        const Rgb chip = rng.Uniform() < 0.5 ? brick * 0.45f : Rgb(214, 202, 186);
        FillPolygon(canvas, RandomBlob(at, radius, rng), chip);
      }
    }
  }
  Shade(canvas, MakeNoise(canvas.size(), {5, 5}, 4, rng), 0.3);
  return {canvas, {1.92, 1.92}};
}

Texture PaintPlaster(Rng& rng) {
  const Palette& palette = RandomPalette(rng);
  const Rgb base = Vary(Mix(palette.light(), palette.Mid(rng), 0.15), 0.05, rng);
  cv::Mat canvas = MakeCanvas({512, 512}, base);
  Stain(canvas, MakeNoise(canvas.size(), {16, 16}, 3, rng), 0.22, 0.05, base * 0.84f, 1.0);
  Stain(canvas, MakeNoise(canvas.size(), {24, 24}, 3, rng), 0.22, 0.05,
        Mix(base, {255, 255, 255}, 0.5), 1.0);
  Scatter(canvas, {160, 3.0, 7.0}, {base * 0.62f, base * 0.75f}, rng);
  for (int i = 0; i < 6; ++i) {
    const cv::Point2f from = RandomPoint(canvas.size(), rng);
    const double length = rng.Uniform(40.0, 150.0);
    DrawCrack(canvas, from, length, 2.4, base * 0.5f, rng);
  }
  Shade(canvas, MakeNoise(canvas.size(), {4, 4}, 4, rng), 0.12);
  return {canvas, {1.6, 1.6}};
}

Texture PaintConcrete(Rng& rng) {
  const Rgb base = Vary({158, 156, 150}, 0.15, rng);
  cv::Mat canvas = MakeCanvas({512, 512}, base);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      FillBox(canvas,
              {static_cast<float>(128 * column + 2), static_cast<float>(128 * row + 2), 124, 124},
              Vary(base, 0.14, rng));
    }
  }
  Stain(canvas, MakeNoise(canvas.size(), {10, 10}, 4, rng), 0.2, 0.06, base * 0.66f, 0.9);
  Stain(canvas, MakeNoise(canvas.size(), {14, 14}, 4, rng), 0.22, 0.06, {214, 210, 202}, 0.9);
  Scatter(canvas, {240, 3.0, 9.0}, {base * 0.4f, base * 0.6f, base * 1.3f}, rng);
  for (int i = 0; i < 8; ++i) {
    const cv::Point2f from = RandomPoint(canvas.size(), rng);
    const double length = rng.Uniform(60.0, 200.0);
    DrawCrack(canvas, from, length, 3.0, base * 0.4f, rng);
  }
  Shade(canvas, MakeNoise(canvas.size(), {64, 64}, 2, rng), 0.15);
  return {canvas, {2.4, 2.4}};
}

Texture PaintRoof(Rng& rng) {
  const std::vector<Rgb> clays = {{150, 78, 58}, {96, 92, 96}, {122, 84, 66}};
  const Rgb& clay = clays[rng.UniformInt(clays.size())];
  cv::Mat canvas = MakeCanvas({256, 256}, clay * 0.5f);
  for (int row = 0; row < 16; ++row) {
    for (int column = 0; column < 16; ++column) {
      const float shift = row % 2 == 0 ? 0.0f : 8.0f;
      FillBox(canvas,
              {static_cast<float>(16 * column) + shift + 1.0f, static_cast<float>(16 * row) + 1.0f,
               14, 13},
              clay * static_cast<float>(rng.Uniform(0.6, 1.4)));
    }
  }
  Shade(canvas, MakeNoise(canvas.size(), {6, 6}, 3, rng), 0.3);
  return {canvas, {4.8, 4.8}};
}

}  // namespace cvo::synth
