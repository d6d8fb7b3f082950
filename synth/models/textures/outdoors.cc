// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "synth/models/textures/painters.h"

namespace cvo::synth {

// Low contrast, as on real roads, so that corners are found on vehicles instead.
Texture PaintAsphalt(Rng& rng) {
  const Rgb base = {104, 104, 107};
  cv::Mat canvas = MakeCanvas({1024, 1024}, base);
  Stain(canvas, MakeNoise(canvas.size(), {5, 5}, 4, rng), 0.0, 0.5, base * 0.8f, 0.7);
  Stain(canvas, MakeNoise(canvas.size(), {4, 4}, 4, rng), 0.0, 0.5, base * 1.2f, 0.7);
  for (int i = 0; i < 7; ++i) {
    const cv::Point2f at = RandomPoint(canvas.size(), rng);
    const auto w = static_cast<float>(rng.Uniform(60.0, 220.0));
    const auto h = static_cast<float>(rng.Uniform(50.0, 130.0));
    const Rgb patch = base * static_cast<float>(rng.Uniform(0.76, 0.88));
    FillBox(canvas, {at.x, at.y, w, h}, patch * 0.75f);
    FillBox(canvas, {at.x + 3, at.y + 3, w - 6, h - 6}, patch);
  }
  Scatter(canvas, {60, 4.0, 18.0}, {base * 0.7f, base * 0.8f}, rng);
  for (int i = 0; i < 7; ++i) {
    const cv::Point2f from = RandomPoint(canvas.size(), rng);
    const double length = rng.Uniform(120.0, 420.0);
    DrawCrack(canvas, from, length, 3.0, base * 0.6f, rng);
  }
  for (int i = 0; i < 2; ++i) {
    const cv::Point2f at = RandomPoint(canvas.size(), rng);
    FillDisc(canvas, at, 26.0, base * 0.5f);
    FillDisc(canvas, at, 21.0, base * 0.85f);
    FillPolygon(canvas, RandomShape(at, 15.0, 0.0, rng), base * 0.5f);
  }
  Shade(canvas, MakeNoise(canvas.size(), {256, 256}, 1, rng), 0.05);
  return {canvas, {12.8, 12.8}};
}

Texture PaintPavement(Rng& rng) {
  const Rgb base = Vary({168, 163, 152}, 0.06, rng);
  cv::Mat canvas = MakeCanvas({512, 512}, base * 0.82f);
  for (int row = 0; row < 16; ++row) {
    for (int column = 0; column < 16; ++column) {
      const float shift = row % 2 == 0 ? 0.0f : 16.0f;
      const auto gain = static_cast<float>(rng.Uniform() < 0.08 ? 0.8 : rng.Uniform(0.95, 1.05));
      FillBox(canvas,
              {static_cast<float>(32 * column) + shift + 1.0f, static_cast<float>(32 * row) + 1.0f,
               30, 30},
              base * gain);
    }
  }
  Scatter(canvas, {50, 2.5, 11.0}, {base * 0.65f, base * 0.78f}, rng);
  Shade(canvas, MakeNoise(canvas.size(), {6, 6}, 3, rng), 0.2);
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
  cv::Mat canvas = MakeCanvas({256, 256}, green * 0.55f);
  for (int i = 0; i < 950; ++i) {
    const double depth = static_cast<double>(i) / 950;  // later leaves are nearer to the light
    const double shade = rng.Uniform(0.6, 0.8);
    const auto gain = static_cast<float>(shade + depth * rng.Uniform(0.0, 0.45));
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

}  // namespace cvo::synth
