// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "synth/models/canvas.h"

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

constexpr float kSide = 1024.0f;  // of the canvas, which shows 12 m: four floors
constexpr int kFloors = 4;
constexpr int kWindows = 5;
constexpr float kFloor = kSide / kFloors;

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

Texture PaintTiles(Rng& rng) {
  const Palette& palette = RandomPalette(rng);
  const Rgb grout = Mix(palette.light(), {128, 124, 118}, 0.6);
  cv::Mat canvas = MakeCanvas({512, 512}, grout);
  ForEachCell(canvas, 16, 16, [&](const cv::Rect2f& cell, int, int) {
    DrawTile(canvas, {cell.x + 1.0f, cell.y + 1.0f, cell.width - 2.0f, cell.height - 2.0f}, palette,
             rng);
  });
  Shade(canvas, MakeNoise(canvas.size(), {6, 6}, 4, rng), 0.25);
  return {canvas, {2.4, 2.4}};
}

Texture PaintBrick(Rng& rng) {
  const std::vector<Rgb> clays = {{168, 88, 64}, {150, 74, 58}, {186, 128, 92}, {132, 92, 78}};
  const Rgb& clay = clays[rng.UniformInt(clays.size())];
  cv::Mat canvas = MakeCanvas({512, 512}, {204, 196, 184});
  ForEachCell(canvas, 24, 8, [&](const cv::Rect2f& cell, int row, int) {
    const float shift = row % 2 == 0 ? 0.0f : 0.5f * cell.width;
    const cv::Rect2f box(cell.x + shift + 1.5f, cell.y + 1.5f, cell.width - 3.0f,
                         cell.height - 3.0f);
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
  });
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
  ForEachCell(canvas, 4, 4, [&](const cv::Rect2f& cell, int, int) {
    FillBox(canvas, {cell.x + 2, cell.y + 2, 124, 124}, Vary(base, 0.14, rng));
  });
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
  ForEachCell(canvas, 16, 16, [&](const cv::Rect2f& cell, int row, int) {
    const float shift = row % 2 == 0 ? 0.0f : 8.0f;
    FillBox(canvas, {cell.x + shift + 1.0f, cell.y + 1.0f, 14, 13},
            clay * static_cast<float>(rng.Uniform(0.6, 1.4)));
  });
  Shade(canvas, MakeNoise(canvas.size(), {6, 6}, 3, rng), 0.3);
  return {canvas, {4.8, 4.8}};
}

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
  ForEachCell(canvas, 16, 16, [&](const cv::Rect2f& cell, int row, int) {
    const float shift = row % 2 == 0 ? 0.0f : 16.0f;
    const auto gain = static_cast<float>(rng.Uniform() < 0.08 ? 0.8 : rng.Uniform(0.95, 1.05));
    FillBox(canvas, {cell.x + shift + 1.0f, cell.y + 1.0f, 30, 30}, base * gain);
  });
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
  ForEachCell(canvas, kFloors, kWindows, [&](const cv::Rect2f& bay, int floor, int i) {
    if (floor == kFloors - 1 && (i == 1 || i == 4)) {
      DrawDoor(canvas, bay, colours, rng);
    } else if (floor == kFloors - 1 && shops) {
      DrawShop(canvas, bay, palette, rng);
    } else {
      const cv::Rect2f window(bay.x + 0.5f * (1.0f - wide) * bay.width, bay.y + 0.22f * bay.height,
                              wide * bay.width, tall * bay.height);
      if (shutters) DrawShutters(canvas, window, shutter);
      DrawWindow(canvas, window, colours, rng);
    }
  });
  return {canvas, {12.0, 12.0}};
}

}  // namespace cvo::synth
