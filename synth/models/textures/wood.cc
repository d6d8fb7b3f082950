// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "synth/models/textures/painters.h"

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

}  // namespace cvo::synth
