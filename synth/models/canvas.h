// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/base/rng.h"
#include "synth/models/build.h"

namespace cvo::synth {

using Rgb = cv::Vec3f;  // 0 ... 255

// Matching colours: light, dark and three in between.
struct Palette {
  std::array<Rgb, 5> colours;
  const Rgb& light() const { return colours[0]; }
  const Rgb& dark() const { return colours[1]; }
  const Rgb& Any(Rng& rng) const { return colours[rng.UniformInt(5)]; }
  const Rgb& Mid(Rng& rng) const { return colours[2 + rng.UniformInt(3)]; }
};

const Palette& RandomPalette(Rng& rng);
Rgb Mix(const Rgb& a, const Rgb& b, double part_of_b);
// Returns the colour, lighter or darker by up to the fraction `part`.
Rgb Vary(const Rgb& colour, double part, Rng& rng);

// A canvas is CV_8UC3 and tileable: what crosses one side continues at the opposite side.
cv::Mat MakeCanvas(cv::Size size, const Rgb& colour);
// Calls draw(cell, row, column) for every cell of a grid over the canvas, row by row.
template <typename Draw>
void ForEachCell(const cv::Mat& canvas, int rows, int columns, const Draw& draw) {
  const float width = static_cast<float>(canvas.cols) / static_cast<float>(columns);
  const float height = static_cast<float>(canvas.rows) / static_cast<float>(rows);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      draw(cv::Rect2f(static_cast<float>(column) * width, static_cast<float>(row) * height, width,
                      height),
           row, column);
    }
  }
}
void FillPolygon(cv::Mat& canvas, const std::vector<cv::Point2f>& points, const Rgb& colour);
void FillDisc(cv::Mat& canvas, cv::Point2f centre, double radius, const Rgb& colour);
void FillBox(cv::Mat& canvas, const cv::Rect2f& box, const Rgb& colour);
void DrawLine(cv::Mat& canvas, cv::Point2f a, cv::Point2f b, double width, const Rgb& colour);

cv::Point2f RandomPoint(cv::Size size, Rng& rng);
cv::Point2f RandomPoint(const cv::Rect2f& box, Rng& rng);
// Returns a triangle, box, star, cross, half disc, letter, ... around `centre`, rotated by
// `angle_rad`.
std::vector<cv::Point2f> RandomShape(cv::Point2f centre, double radius, double angle_rad, Rng& rng);

struct Stamp {
  cv::Point2f centre;
  double radius;
  double angle_rad;
  Rgb colour;
};
// Draws a random shape.
void DrawStamp(cv::Mat& canvas, const Stamp& stamp, Rng& rng);
// Returns an irregular polygon with 7 to 11 corners.
std::vector<cv::Point2f> RandomBlob(cv::Point2f centre, double radius, Rng& rng);

struct ScatterOptions {
  int count;
  double smallest_px;  // radii; small ones are more frequent
  double largest_px;
};
// Draws blobs of these colours all over the canvas.
void Scatter(cv::Mat& canvas, const ScatterOptions& options, const std::vector<Rgb>& colours,
             Rng& rng);

struct CollageOptions {
  double smallest_px = 4.0;  // radii; small ones are more frequent
  double largest_px = 60.0;
  int shapes = 300;
};
// Draws overlapping shapes, large ones first, which give corners at every scale.
void DrawCollage(cv::Mat& canvas, const cv::Rect2f& area, const CollageOptions& options,
                 const Palette& palette, Rng& rng);
// Draws an irregular line with branches.
void DrawCrack(cv::Mat& canvas, cv::Point2f from, double length_px, double width_px,
               const Rgb& colour, Rng& rng);

// Returns smooth tileable noise in [-1, 1]. The first octave has `cells` lattice points along the
// sides; each further one is twice as fine and half as strong.
cv::Mat1f MakeNoise(cv::Size size, cv::Size cells, int octaves, Rng& rng);
// Multiplies each pixel by 1 + strength * noise.
void Shade(cv::Mat& canvas, const cv::Mat1f& noise, double strength);
// Blends towards `colour` where noise > level, with a transition of width `softness` up to
// `strength`.
void Stain(cv::Mat& canvas, const cv::Mat1f& noise, double level, double softness,
           const Rgb& colour, double strength);

// Each function paints one material. Texture sizes in metres are those of the real material.
Texture PaintWood(Rng& rng);
Texture PaintParquet(Rng& rng);
Texture PaintFabric(Rng& rng);
Texture PaintCarpet(Rng& rng);
Texture PaintTiles(Rng& rng);
Texture PaintPoster(Rng& rng);
Texture PaintWallpaper(Rng& rng);
Texture PaintEmbossed(Rng& rng);
Texture PaintPlaster(Rng& rng);
Texture PaintBlock(Rng& rng);

Texture PaintBrick(Rng& rng);
Texture PaintConcrete(Rng& rng);
Texture PaintAsphalt(Rng& rng);
Texture PaintPavement(Rng& rng);
Texture PaintGrass(Rng& rng);
Texture PaintLeaves(Rng& rng);
Texture PaintBark(Rng& rng);
Texture PaintCarPaint(Rng& rng);
Texture PaintFacade(Rng& rng);
Texture PaintRoof(Rng& rng);

}  // namespace cvo::synth
