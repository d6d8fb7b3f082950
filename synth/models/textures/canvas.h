// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/base/rng.h"

namespace cvo::synth {

using Rgb = cv::Vec3f;  // 0 ... 255

// Colours that go together: light, dark and three between.
struct Palette {
  std::array<Rgb, 5> colours;
  const Rgb& light() const { return colours[0]; }
  const Rgb& dark() const { return colours[1]; }
  const Rgb& Any(Rng& rng) const { return colours[rng.UniformInt(5)]; }
  const Rgb& Mid(Rng& rng) const { return colours[2 + rng.UniformInt(3)]; }
};

const Palette& RandomPalette(Rng& rng);
Rgb Mix(const Rgb& a, const Rgb& b, double part_of_b);
// A colour as given, lighter or darker by up to `part`.
Rgb Vary(const Rgb& colour, double part, Rng& rng);

// A canvas is CV_8UC3 and tileable: what crosses one side continues at the opposite one.
cv::Mat MakeCanvas(cv::Size size, const Rgb& colour);
void FillPolygon(cv::Mat& canvas, const std::vector<cv::Point2f>& points, const Rgb& colour);
void FillDisc(cv::Mat& canvas, cv::Point2f centre, double radius, const Rgb& colour);
void FillBox(cv::Mat& canvas, const cv::Rect2f& box, const Rgb& colour);
void DrawLine(cv::Mat& canvas, cv::Point2f a, cv::Point2f b, double width, const Rgb& colour);

cv::Point2f RandomPoint(cv::Size size, Rng& rng);
cv::Point2f RandomPoint(const cv::Rect2f& box, Rng& rng);
// A triangle, box, star, cross, half disc, letter, ... around `centre`, turned by `angle_rad`.
std::vector<cv::Point2f> RandomShape(cv::Point2f centre, double radius, double angle_rad, Rng& rng);

struct Stamp {
  cv::Point2f centre;
  double radius;
  double angle_rad;
  Rgb colour;
};
// A random shape.
void DrawStamp(cv::Mat& canvas, const Stamp& stamp, Rng& rng);
// A rounded patch without straight edges.
std::vector<cv::Point2f> RandomBlob(cv::Point2f centre, double radius, Rng& rng);

struct ScatterOptions {
  int count;
  double smallest_px;  // radii; small ones are more frequent
  double largest_px;
};
// Blobs of these colours all over the canvas.
void Scatter(cv::Mat& canvas, const ScatterOptions& options, const std::vector<Rgb>& colours,
             Rng& rng);

struct CollageOptions {
  double smallest_px = 4.0;  // radii; as many per octave, more of the small ones
  double largest_px = 60.0;
  int shapes = 300;
};
// Overlapping shapes, large ones first: corners at every scale.
void DrawCollage(cv::Mat& canvas, const cv::Rect2f& area, const CollageOptions& options,
                 const Palette& palette, Rng& rng);
// An irregular line with branches.
void DrawCrack(cv::Mat& canvas, cv::Point2f from, double length_px, double width_px,
               const Rgb& colour, Rng& rng);

// Smooth tileable noise in [-1, 1] with `cells` lattice points along the sides; `octaves` of it,
// each twice as fine and half as strong.
cv::Mat1f MakeNoise(cv::Size size, cv::Size cells, int octaves, Rng& rng);
// Multiplies each pixel by 1 + strength * noise.
void Shade(cv::Mat& canvas, const cv::Mat1f& noise, double strength);
// Blends to `colour` where noise > level, over a seam of width `softness`.
void Stain(cv::Mat& canvas, const cv::Mat1f& noise, double level, double softness,
           const Rgb& colour, double strength);

}  // namespace cvo::synth
