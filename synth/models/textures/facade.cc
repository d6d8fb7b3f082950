// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "synth/models/textures/painters.h"

namespace cvo::synth {
namespace {

constexpr float kSide = 1024.0f;  // of the canvas, which shows 12 m: four floors
constexpr int kFloors = 4;
constexpr int kWindows = 5;
constexpr float kFloor = kSide / kFloors;
constexpr float kBay = kSide / kWindows;

struct FacadeColours {
  const Palette* palette;
  Rgb wall;
  Rgb frame;
};

void DrawCurtains(cv::Mat& canvas, const cv::Rect2f& glass, const Palette& palette, Rng& rng) {
  const Rgb cloth = Mix(palette.Any(rng), {240, 236, 228}, 0.4);
  const auto left = static_cast<float>(rng.Uniform(0.0, 0.45));
  const auto right = static_cast<float>(rng.Uniform(0.0, 0.45));
  FillBox(canvas, {glass.x, glass.y, left * glass.width, glass.height}, cloth);
  FillBox(canvas,
          {glass.x + (1.0f - right) * glass.width, glass.y, right * glass.width, glass.height},
          cloth);
  if (rng.Uniform() < 0.4) {
    const auto blind = static_cast<float>(rng.Uniform(0.15, 0.8));
    FillBox(canvas, {glass.x, glass.y, glass.width, blind * glass.height}, Vary(cloth, 0.3, rng));
  }
}

void DrawFlowerBox(cv::Mat& canvas, const cv::Rect2f& window, const Palette& palette, Rng& rng) {
  const float y = window.y + window.height;
  FillBox(canvas, {window.x, y, window.width, 14}, {96, 72, 56});
  for (int i = 0; i < 16; ++i) {
    const cv::Point2f at = RandomPoint(cv::Rect2f(window.x, y - 20.0f, window.width, 22.0f), rng);
    const double radius = rng.Uniform(4.0, 9.0);
    const Rgb colour = rng.Uniform() < 0.5 ? Vary({72, 104, 52}, 0.3, rng) : palette.Any(rng);
    FillDisc(canvas, at, radius, colour);
  }
}

void DrawShutters(cv::Mat& canvas, const cv::Rect2f& window, const Rgb& colour) {
  const float width = 0.4f * window.width;
  for (const float x : {window.x - width - 4.0f, window.x + window.width + 4.0f}) {
    FillBox(canvas, {x, window.y, width, window.height}, colour);
    for (float y = window.y + 8; y < window.y + window.height - 8; y += 20) {
      FillBox(canvas, {x + 5, y, width - 10, 8}, colour * 0.6f);
    }
  }
}

void DrawWindow(cv::Mat& canvas, const cv::Rect2f& window, const FacadeColours& colours, Rng& rng) {
  const float rim = 7.0f;
  FillBox(canvas, {window.x - rim, window.y - rim, window.width + 2 * rim, window.height + 2 * rim},
          colours.frame);
  const cv::Rect2f glass(window.x, window.y, window.width, window.height);
  FillBox(canvas, glass, Vary({58, 70, 84}, 0.35, rng));
  FillPolygon(canvas,
              {{glass.x, glass.y + 0.7f * glass.height},
               {glass.x + 0.6f * glass.width, glass.y},
               {glass.x + 0.9f * glass.width, glass.y},
               {glass.x, glass.y + glass.height}},
              Vary({118, 138, 156}, 0.3, rng));
  if (rng.Uniform() < 0.8) DrawCurtains(canvas, glass, *colours.palette, rng);
  const auto split = static_cast<float>(rng.Uniform(0.25, 0.5));
  FillBox(canvas, {glass.x + 0.5f * glass.width - 3, glass.y, 6, glass.height}, colours.frame);
  FillBox(canvas, {glass.x, glass.y + split * glass.height - 3, glass.width, 6}, colours.frame);
  FillBox(canvas, {window.x - 12, window.y + window.height + rim - 2, window.width + 24, 9},
          colours.frame * 0.75f);
  if (rng.Uniform() < 0.35) DrawFlowerBox(canvas, window, *colours.palette, rng);
}

// Draws a shop window with goods and a sign above it.
void DrawShop(cv::Mat& canvas, const cv::Rect2f& bay, const Palette& palette, Rng& rng) {
  FillBox(canvas, {bay.x + 6, bay.y + 70, bay.width - 12, bay.height - 84}, {40, 46, 54});
  const cv::Rect2f goods(bay.x + 16, bay.y + 90, bay.width - 32, bay.height - 120);
  for (int i = 0; i < 14; ++i) {
    const cv::Point2f at = RandomPoint(goods, rng);
    DrawStamp(canvas, {at, rng.Uniform(8.0, 26.0), 0.0, palette.Any(rng)}, rng);
  }
  FillBox(canvas, {bay.x, bay.y + 26, bay.width, 48}, Vary(palette.Mid(rng), 0.2, rng));
  for (float x = bay.x + 24; x < bay.x + bay.width - 20; x += 27) {
    const Rgb& print = rng.Uniform() < 0.7 ? palette.light() : palette.dark();
    DrawStamp(canvas, {{x, bay.y + 50}, 14.0, 0.0, print}, rng);
  }
}

void DrawDoor(cv::Mat& canvas, const cv::Rect2f& bay, const FacadeColours& colours, Rng& rng) {
  const cv::Rect2f door(bay.x + 0.26f * bay.width, bay.y + 60, 0.48f * bay.width, bay.height - 60);
  FillBox(canvas, {door.x - 9, door.y - 9, door.width + 18, door.height + 9}, colours.frame);
  const Rgb colour = Vary(colours.palette->Mid(rng), 0.2, rng);
  FillBox(canvas, door, colour);
  for (int i = 0; i < 4; ++i) {
    const cv::Rect2f panel(door.x + (i % 2 == 0 ? 0.1f : 0.55f) * door.width,
                           door.y + (i < 2 ? 0.08f : 0.55f) * door.height, 0.35f * door.width,
                           0.38f * door.height);
    FillBox(canvas, panel, i < 2 ? Rgb(70, 84, 98) : colour * 0.6f);
  }
}

void DrawWall(cv::Mat& canvas, const FacadeColours& colours, Rng& rng) {
  const bool bricks = rng.Uniform() < 0.5;
  const float height = bricks ? 16.0f : 32.0f;
  const float width = bricks ? 40.0f : 73.1429f;
  for (float y = 0; y < kSide; y += height) {
    const float shift = std::fmod(y / height, 2.0f) < 0.5f ? 0.0f : 0.5f * width;
    for (float x = 0; x < kSide - 1; x += width) {
      const auto gain = static_cast<float>(rng.Uniform() < 0.05 ? rng.Uniform(0.8, 0.88)
                                                                : rng.Uniform(0.96, 1.04));
      FillBox(canvas, {x + shift + 1, y + 1, width - 2, height - 2}, colours.wall * gain);
    }
  }
  Stain(canvas, MakeNoise(canvas.size(), {8, 4}, 4, rng), 0.1, 0.5, colours.wall * 0.7f, 0.7);
  for (int floor = 0; floor < kFloors; ++floor) {
    FillBox(canvas, {0, static_cast<float>(floor) * kFloor, kSide, 12}, colours.frame * 0.85f);
  }
}

}  // namespace

Texture PaintFacade(Rng& rng) {
  const Palette& palette = RandomPalette(rng);
  const Rgb& tone = palette.Mid(rng);
  const Rgb wall = Mix(tone, palette.light(), rng.Uniform(0.2, 0.7));
  FacadeColours colours{&palette, wall, Mix(palette.light(), {255, 255, 255}, 0.3)};
  cv::Mat canvas = MakeCanvas({static_cast<int>(kSide), static_cast<int>(kSide)}, wall * 0.9f);
  DrawWall(canvas, colours, rng);
  const bool shops = rng.Uniform() < 0.6;
  const bool shutters = rng.Uniform() < 0.4;
  const Rgb shutter = Vary(palette.Mid(rng), 0.2, rng) * 0.8f;
  const auto wide = static_cast<float>(rng.Uniform(0.38, 0.5));
  const auto tall = static_cast<float>(rng.Uniform(0.48, 0.6));
  for (int floor = 0; floor < kFloors; ++floor) {
    for (int i = 0; i < kWindows; ++i) {
      const cv::Rect2f bay(static_cast<float>(i) * kBay, static_cast<float>(floor) * kFloor, kBay,
                           kFloor);
      if (floor == kFloors - 1 && (i == 1 || i == 4)) {
        DrawDoor(canvas, bay, colours, rng);
      } else if (floor == kFloors - 1 && shops) {
        DrawShop(canvas, bay, palette, rng);
      } else {
        const cv::Rect2f window(bay.x + 0.5f * (1.0f - wide) * bay.width,
                                bay.y + 0.22f * bay.height, wide * bay.width, tall * bay.height);
        if (shutters) DrawShutters(canvas, window, shutter);
        DrawWindow(canvas, window, colours, rng);
      }
    }
  }
  return {canvas, {12.0, 12.0}};
}

}  // namespace cvo::synth
