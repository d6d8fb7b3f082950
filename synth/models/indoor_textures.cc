// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "synth/models/canvas.h"

namespace cvo::synth {
namespace {

const Rgb& RandomTimber(Rng& rng) {
  static const std::vector<Rgb> timbers = {{178, 126, 76}, {146, 96, 58},  {204, 164, 112},
                                           {120, 78, 52},  {188, 142, 96}, {158, 118, 82}};
  return timbers[rng.UniformInt(timbers.size())];
}

// Draws rings elongated along u around a dark centre.
void DrawKnot(cv::Mat& canvas, cv::Point2f centre, double radius, const Rgb& timber, Rng& rng) {
  for (const double part : {1.0, 0.78, 0.55, 0.3}) {
    std::vector<cv::Point2f> ring;
    const double r = radius * part;
    for (int i = 0; i < 14; ++i) {
      const double angle = 2.0 * 3.14159265358979 * i / 14;
      const double wobble = rng.Uniform(0.85, 1.15);
      ring.push_back(centre + cv::Point2f(static_cast<float>(1.9 * r * wobble * std::cos(angle)),
                                          static_cast<float>(r * wobble * std::sin(angle))));
    }
    const bool dark = part == 1.0 || part == 0.55 || part == 0.3;
    FillPolygon(canvas, ring, timber * (dark ? (part == 0.3 ? 0.3f : 0.5f) : 1.1f));
  }
}

// Draws short dark strokes along the grain.
void DrawFlecks(cv::Mat& canvas, const cv::Rect2f& board, const Rgb& timber, float flecks_per_px2,
                Rng& rng) {
  const int flecks = static_cast<int>(board.area() * flecks_per_px2);
  for (int i = 0; i < flecks; ++i) {
    const double length = rng.Uniform(6.0, 22.0);
    const cv::Rect2f within(board.x, board.y + 4.0f, board.width - static_cast<float>(length),
                            board.height - 8.0f);
    const cv::Point2f at = RandomPoint(within, rng);
    const auto gain = static_cast<float>(rng.Uniform() < 0.7 ? rng.Uniform(0.4, 0.65) : 1.4);
    DrawLine(canvas, at, at + cv::Point2f(static_cast<float>(length), 0.0f), rng.Uniform(2.0, 4.5),
             timber * gain);
  }
}

struct BoardOptions {
  float height_px;
  double shortest_px;
  double longest_px;
  double tint;  // variation between boards
  float flecks_per_px2;
  float knots_per_px2;
};

void DrawBoard(cv::Mat& canvas, const cv::Rect2f& board, const Rgb& timber,
               const BoardOptions& options, Rng& rng) {
  FillBox(canvas, board, timber);
  DrawFlecks(canvas, board, timber, options.flecks_per_px2, rng);
  const int knots = static_cast<int>(board.area() * options.knots_per_px2 + rng.Uniform());
  for (int i = 0; i < knots; ++i) {
    const double radius = rng.Uniform(0.1, 0.24) * board.height;
    const auto r = static_cast<float>(radius);
    const cv::Rect2f within(board.x + 2.0f * r, board.y + 1.3f * r, board.width - 4.0f * r,
                            board.height - 2.6f * r);
    const cv::Point2f at = RandomPoint(within, rng);
    DrawKnot(canvas, at, radius, timber, rng);
  }
  const Rgb gap = timber * 0.35f;
  FillBox(canvas, {board.x, board.y, board.width, 2.0f}, gap);
  FillBox(canvas, {board.x, board.y, 2.5f, board.height}, gap);
}

cv::Mat PaintBoards(cv::Size size, const BoardOptions& options, Rng& rng) {
  const Rgb timber = RandomTimber(rng);
  cv::Mat canvas = MakeCanvas(size, timber);
  const auto width = static_cast<float>(size.width);
  for (float y = 0; y < static_cast<float>(size.height); y += options.height_px) {
    const auto start = static_cast<float>(rng.Uniform(0.0, width));
    for (float x = 0; x < width;) {
      auto length = static_cast<float>(rng.Uniform(options.shortest_px, options.longest_px));
      if (width - x - length < options.shortest_px) length = width - x;
      const Rgb tint = Vary(timber, options.tint, rng);
      DrawBoard(canvas, {start + x, y, length, options.height_px}, tint, options, rng);
      x += length;
    }
  }
  Shade(canvas, MakeNoise(size, {5, 64}, 3, rng), 0.28);
  return canvas;
}

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

Texture PaintWood(Rng& rng) {
  return {
      PaintBoards({512, 512}, {42.66667f, 90.0, 300.0, 0.26, 1.0f / 520.0f, 1.0f / 5000.0f}, rng),
      {1.28, 1.28}};
}

Texture PaintParquet(Rng& rng) {
  // Large boards of low contrast, so that bodies on them stand out.
  const BoardOptions boards = {64.0f, 200.0, 480.0, 0.28, 1.0f / 650.0f, 1.0f / 8000.0f};
  return {PaintBoards({1024, 1024}, boards, rng), {2.56, 2.56}};
}

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
