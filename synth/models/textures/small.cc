// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "synth/models/textures/painters.h"

namespace cvo::synth {

Texture MakeSolidTexture(const cv::Vec3f& rgb, Rng& look) {
  Rng own(look.NextU64(), "solid");
  cv::Mat canvas = MakeCanvas({64, 64}, rgb);
  Shade(canvas, MakeNoise(canvas.size(), {8, 8}, 2, own), 0.2);
  return {canvas, {0.5, 0.5}};
}

Texture MakeWindowViewTexture(Rng& look) {
  Rng own(look.NextU64(), "window view");
  cv::Mat canvas = MakeCanvas({256, 256}, {196, 216, 236});
  Stain(canvas, MakeNoise(canvas.size(), {4, 6}, 4, own), 0.05, 0.2, {248, 250, 252}, 1.0);
  for (int i = 0; i < 7; ++i) {
    const auto x = static_cast<float>(own.Uniform(0.0, 230.0));
    const auto top = static_cast<float>(own.Uniform(90.0, 160.0));
    const auto width = static_cast<float>(own.Uniform(24.0, 50.0));
    const Rgb wall = Vary({176, 140, 112}, 0.3, own);
    FillBox(canvas, {x, top, std::min(width, 255.0f - x), 254.0f - top}, wall);
    for (float y = top + 8; y < 240.0f; y += 16) {
      for (float u = x + 5; u < x + width - 8 && u < 246; u += 12) {
        FillBox(canvas, {u, y, 6, 9}, own.Uniform() < 0.8 ? Rgb(62, 72, 88) : Rgb(236, 214, 150));
      }
    }
  }
  for (int i = 0; i < 260; ++i) {
    const cv::Point2f at = RandomPoint(cv::Rect2f(6, 200, 244, 48), own);
    const double radius = own.Uniform(3.0, 8.0);
    FillDisc(canvas, at, radius, Vary({76, 108, 58}, 0.45, own));
  }
  return {canvas, {1.0, 1.0}};
}

Texture MakeDoorTexture(Rng& look) {
  Rng own(look.NextU64(), "door");
  const Palette& palette = RandomPalette(own);
  const Rgb wood = Mix(palette.Mid(own), palette.light(), 0.25);
  cv::Mat canvas = MakeCanvas({256, 256}, wood);
  for (int i = 0; i < 6; ++i) {
    const float x = i % 2 == 0 ? 28.0f : 142.0f;
    const float y = 16.0f + static_cast<float>(i / 2) * 82.0f;
    FillBox(canvas, {x, y, 86, 66}, wood * 0.62f);
    FillBox(canvas, {x + 8, y + 5, 70, 56}, Vary(wood, 0.12, own));
    DrawStamp(canvas, {{x + 43, y + 33}, 20.0, 0.0, palette.Any(own)}, own);
  }
  FillDisc(canvas, {238, 130}, 8.0, palette.dark());
  Shade(canvas, MakeNoise(canvas.size(), {48, 6}, 2, own), 0.14);
  return {canvas, {1.0, 1.0}};
}

// Dark, with reflections of the sky and the roadside, and a few stickers.
Texture MakeCarGlassTexture(Rng& look) {
  Rng own(look.NextU64(), "car glass");
  cv::Mat canvas = MakeCanvas({256, 256}, {40, 48, 58});
  Stain(canvas, MakeNoise(canvas.size(), {6, 6}, 3, own), 0.05, 0.1, {92, 108, 124}, 1.0);
  for (int i = 0; i < 130; ++i) {
    const cv::Point2f at = RandomPoint(canvas.size(), own);
    const Rgb colour = i % 2 == 0 ? Rgb(16, 20, 26) : Rgb(164, 184, 200);
    const double radius = own.Uniform(3.5, 12.0);
    const double angle = own.Uniform(0.0, 6.28);
    DrawStamp(canvas, {at, radius, angle, Vary(colour, 0.2, own)}, own);
  }
  return {canvas, {1.6, 1.6}};
}

Texture MakeWheelTexture(Rng& look) {
  Rng own(look.NextU64(), "wheel");
  cv::Mat canvas = MakeCanvas({128, 128}, {34, 34, 36});
  const cv::Point2f middle(64, 64);
  FillDisc(canvas, middle, 42.0, {150, 152, 156});
  const int spokes = 5 + static_cast<int>(own.UniformInt(3));
  for (int i = 0; i < spokes; ++i) {
    const double angle = 2.0 * 3.14159265358979 * (i + own.Uniform(-0.1, 0.1)) / spokes;
    const cv::Point2f out(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
    FillDisc(canvas, middle + 27.0f * out, own.Uniform(6.0, 9.5), {48, 48, 52});
  }
  FillDisc(canvas, middle, 9.0, {96, 98, 104});
  return {canvas, {1.0, 1.0}};
}

Texture MakeBooksTexture(Rng& look) {
  Rng own(look.NextU64(), "books");
  const Palette& palette = RandomPalette(own);
  const Palette& second = RandomPalette(own);
  cv::Mat canvas = MakeCanvas({512, 512}, palette.dark());
  for (int i = 0; i < kBookColumns * kBookRows; ++i) {
    const Palette& colours = own.Uniform() < 0.6 ? palette : second;
    const auto x = static_cast<float>(i % kBookColumns) * 32.0f;
    const auto y = static_cast<float>(i / kBookColumns) * 256.0f;
    const Rgb cloth = Vary(colours.Any(own), 0.15, own);
    FillBox(canvas, {x, y, 32, 256}, cloth);
    const Rgb title = Vary(colours.Any(own), 0.1, own);
    const Rgb print = cloth[1] > 128.0f ? colours.dark() : colours.light();
    const auto band = static_cast<float>(own.Uniform(16.0, 60.0));
    FillBox(canvas, {x, y + band, 32, static_cast<float>(own.Uniform(14.0, 40.0))}, title);
    FillBox(canvas, {x, y + 212, 32, 10}, title);
    for (float at = band + 50; at < 200; at += 24) {
      DrawStamp(canvas, {{x + 16, y + at}, own.Uniform(8.0, 13.0), 0.0, print}, own);
    }
    FillBox(canvas, {x, y, 1.5f, 256}, cloth * 0.4f);
  }
  return {canvas, {1.0, 1.0}};
}

Texture MakePlateTexture(Rng& look) {
  Rng own(look.NextU64(), "plate");
  cv::Mat canvas = MakeCanvas({128, 32}, {240, 240, 234});
  FillBox(canvas, {0, 0, 12, 32}, {40, 70, 150});
  for (int i = 0; i < 7; ++i) {
    FillPolygon(canvas, RandomShape({23.0f + 15.5f * static_cast<float>(i), 16.0f}, 9.0, 0.0, own),
                {24, 24, 28});
  }
  return {canvas, {1.0, 1.0}};
}

}  // namespace cvo::synth
