// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "synth/models/textures/painters.h"

namespace cvo::synth {

Texture PaintAsphalt(Rng& rng) {
  const Rgb base = {112, 112, 114};
  cv::Mat canvas = MakeCanvas({1024, 1024}, base);
  Stain(canvas, MakeNoise(canvas.size(), {10, 10}, 4, rng), 0.15, 0.1, base * 0.75f, 1.0);
  Stain(canvas, MakeNoise(canvas.size(), {14, 14}, 4, rng), 0.18, 0.1, base * 1.3f, 0.8);
  for (int i = 0; i < 34; ++i) {
    const cv::Point2f at = RandomPoint(canvas.size(), rng);
    const auto w = static_cast<float>(rng.Uniform(30.0, 150.0));
    const auto h = static_cast<float>(rng.Uniform(30.0, 110.0));
    const Rgb patch =
        base * static_cast<float>(rng.Uniform() < 0.6 ? rng.Uniform(0.55, 0.8) : 1.25);
    FillBox(canvas, {at.x, at.y, w, h}, patch * 0.6f);
    FillBox(canvas, {at.x + 3, at.y + 3, w - 6, h - 6}, patch);
  }
  Scatter(canvas, {900, 4.0, 22.0}, {base * 0.5f, base * 0.68f, base * 1.3f, base * 1.5f}, rng);
  for (int i = 0; i < 26; ++i) {
    const cv::Point2f from = RandomPoint(canvas.size(), rng);
    const double length = rng.Uniform(120.0, 420.0);
    DrawCrack(canvas, from, length, 4.0, base * 0.4f, rng);
  }
  for (int i = 0; i < 5; ++i) {
    const cv::Point2f at = RandomPoint(canvas.size(), rng);
    FillDisc(canvas, at, 26.0, base * 0.5f);
    FillDisc(canvas, at, 21.0, base * 0.85f);
    FillPolygon(canvas, RandomShape(at, 15.0, 0.0, rng), base * 0.5f);
  }
  Shade(canvas, MakeNoise(canvas.size(), {128, 128}, 2, rng), 0.18);
  return {canvas, {12.8, 12.8}};
}

Texture PaintPavement(Rng& rng) {
  const Rgb base = Vary({170, 164, 152}, 0.08, rng);
  cv::Mat canvas = MakeCanvas({512, 512}, base * 0.55f);
  for (int row = 0; row < 16; ++row) {
    for (int column = 0; column < 16; ++column) {
      const float shift = row % 2 == 0 ? 0.0f : 16.0f;
      const auto gain = static_cast<float>(rng.Uniform() < 0.15 ? 0.6 : rng.Uniform(0.8, 1.2));
      FillBox(canvas,
              {static_cast<float>(32 * column) + shift + 1.0f, static_cast<float>(32 * row) + 1.0f,
               30, 30},
              base * gain);
    }
  }
  Scatter(canvas, {420, 2.5, 13.0}, {base * 0.5f, base * 0.7f, base * 1.35f}, rng);
  Shade(canvas, MakeNoise(canvas.size(), {8, 8}, 4, rng), 0.3);
  return {canvas, {8.0, 8.0}};
}

Texture PaintGrass(Rng& rng) {
  const Rgb base = {104, 128, 66};
  cv::Mat canvas = MakeCanvas({1024, 1024}, base);
  Stain(canvas, MakeNoise(canvas.size(), {12, 12}, 5, rng), 0.1, 0.1, {140, 152, 84}, 1.0);
  Stain(canvas, MakeNoise(canvas.size(), {18, 18}, 5, rng), 0.15, 0.1, {70, 96, 48}, 1.0);
  Stain(canvas, MakeNoise(canvas.size(), {9, 9}, 5, rng), 0.3, 0.08, {146, 122, 88}, 0.9);
  Scatter(canvas, {2600, 3.0, 16.0}, {{62, 86, 44}, {84, 110, 52}, {150, 164, 92}, {52, 72, 40}},
          rng);
  Scatter(canvas, {260, 2.5, 7.0}, {{232, 224, 196}, {226, 196, 92}, {176, 168, 156}}, rng);
  Shade(canvas, MakeNoise(canvas.size(), {128, 128}, 2, rng), 0.25);
  return {canvas, {16.0, 16.0}};
}

Texture PaintLeaves(Rng& rng) {
  const std::vector<Rgb> greens = {{58, 92, 44}, {72, 104, 48}, {88, 104, 40}, {52, 88, 60}};
  const Rgb green = greens[rng.UniformInt(greens.size())];
  cv::Mat canvas = MakeCanvas({256, 256}, green * 0.4f);
  for (int i = 0; i < 950; ++i) {
    const double depth = static_cast<double>(i) / 950;  // later ones lie nearer to the light
    const double shade = rng.Uniform(0.45, 0.9);
    const auto gain = static_cast<float>(shade + depth * rng.Uniform(0.0, 1.1));
    const cv::Point2f at = RandomPoint(canvas.size(), rng);
    const double angle = rng.Uniform(0.0, 6.28);
    const double length = rng.Uniform(5.0, 12.0);
    const cv::Point2f along(static_cast<float>(length * std::cos(angle)),
                            static_cast<float>(length * std::sin(angle)));
    const cv::Point2f side(-0.45f * along.y, 0.45f * along.x);
    FillPolygon(canvas, {at - along, at + side, at + along, at - side}, green * gain);
  }
  return {canvas, {3.2, 3.2}};
}

Texture PaintBark(Rng& rng) {
  const Rgb base = Vary({104, 84, 66}, 0.15, rng);
  cv::Mat canvas = MakeCanvas({256, 256}, base);
  Stain(canvas, MakeNoise(canvas.size(), {24, 8}, 3, rng), 0.1, 0.06, base * 0.5f, 1.0);
  Stain(canvas, MakeNoise(canvas.size(), {24, 8}, 3, rng), 0.12, 0.06, base * 1.5f, 1.0);
  Scatter(canvas, {170, 4.0, 12.0}, {base * 0.5f, base * 1.4f, {128, 132, 104}}, rng);
  return {canvas, {1.6, 1.6}};
}

Texture PaintCarPaint(Rng& rng) {
  const Palette& palette = RandomPalette(rng);
  const Rgb base = rng.Uniform() < 0.25 ? palette.light() : palette.Mid(rng);
  cv::Mat canvas = MakeCanvas({512, 512}, base);
  for (int i = 0; i < 3; ++i) {
    const auto y = static_cast<float>(rng.Uniform(0.0, 512.0));
    const auto height = static_cast<float>(rng.Uniform(14.0, 40.0));
    FillBox(canvas, {0, y, 512, height}, palette.Any(rng));
  }
  DrawCollage(canvas, {0, 0, 512, 512}, {8.0, 40.0, 200}, palette, rng);
  Stain(canvas, MakeNoise(canvas.size(), {8, 8}, 4, rng), 0.3, 0.3, {120, 104, 84}, 0.7);
  return {canvas, {2.56, 2.56}};
}

}  // namespace cvo::synth
