// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "synth/models/textures/canvas.h"

namespace cvo::synth {
namespace {

using Outline = std::vector<cv::Point2f>;

// Corners on the unit circle, with every second one moved in to radius `inner` (1: a regular
// polygon).
Outline MakeStar(int corners, double inner) {
  Outline outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * 3.14159265358979 * i / corners;
    const double radius = i % 2 == 0 ? 1.0 : inner;
    outline.emplace_back(static_cast<float>(radius * std::cos(angle)),
                         static_cast<float>(radius * std::sin(angle)));
  }
  return outline;
}

Outline MakeHalfDisc() {
  Outline outline;
  for (int i = 0; i <= 10; ++i) {
    const double angle = 3.14159265358979 * i / 10;
    outline.emplace_back(static_cast<float>(std::cos(angle)),
                         static_cast<float>(std::sin(angle) - 0.5));
  }
  return outline;
}

// A leaf, pointed at both ends.
Outline MakeLeaf() {
  return {{-1, 0}, {-0.6f, 0.25f}, {0, 0.36f},  {0.6f, 0.25f},
          {1, 0},  {0.6f, -0.25f}, {0, -0.36f}, {-0.6f, -0.25f}};
}

const std::vector<Outline>& Outlines() {
  static const std::vector<Outline> outlines = {
      MakeStar(24, 1.0),
      MakeStar(3, 1.0),
      MakeStar(10, 0.45),
      MakeStar(8, 0.5),
      MakeHalfDisc(),
      MakeLeaf(),
      {{-0.7f, -0.7f}, {0.7f, -0.7f}, {0.7f, 0.7f}, {-0.7f, 0.7f}},
      {{-1, -0.35f}, {1, -0.35f}, {1, 0.35f}, {-1, 0.35f}},
      {{-0.25f, -1}, {0.25f, -1}, {0.25f, 1}, {-0.25f, 1}},
      // Letters: L, T, E, H, Z, cross.
      {{-0.6f, -1}, {-0.1f, -1}, {-0.1f, 0.5f}, {0.7f, 0.5f}, {0.7f, 1}, {-0.6f, 1}},
      {{-0.8f, -1},
       {0.8f, -1},
       {0.8f, -0.5f},
       {0.25f, -0.5f},
       {0.25f, 1},
       {-0.25f, 1},
       {-0.25f, -0.5f},
       {-0.8f, -0.5f}},
      {{-0.6f, -1},
       {0.6f, -1},
       {0.6f, -0.6f},
       {-0.1f, -0.6f},
       {-0.1f, -0.2f},
       {0.5f, -0.2f},
       {0.5f, 0.2f},
       {-0.1f, 0.2f},
       {-0.1f, 0.6f},
       {0.6f, 0.6f},
       {0.6f, 1},
       {-0.6f, 1}},
      {{-0.7f, -1},
       {-0.25f, -1},
       {-0.25f, -0.22f},
       {0.25f, -0.22f},
       {0.25f, -1},
       {0.7f, -1},
       {0.7f, 1},
       {0.25f, 1},
       {0.25f, 0.22f},
       {-0.25f, 0.22f},
       {-0.25f, 1},
       {-0.7f, 1}},
      {{-0.8f, -0.9f},
       {0.8f, -0.9f},
       {0.8f, -0.5f},
       {-0.1f, 0.5f},
       {0.8f, 0.5f},
       {0.8f, 0.9f},
       {-0.8f, 0.9f},
       {-0.8f, 0.5f},
       {0.1f, -0.5f},
       {-0.8f, -0.5f}},
      {{-0.3f, -0.9f},
       {0.3f, -0.9f},
       {0.3f, -0.3f},
       {0.9f, -0.3f},
       {0.9f, 0.3f},
       {0.3f, 0.3f},
       {0.3f, 0.9f},
       {-0.3f, 0.9f},
       {-0.3f, 0.3f},
       {-0.9f, 0.3f},
       {-0.9f, -0.3f},
       {-0.3f, -0.3f}}};
  return outlines;
}

}  // namespace

std::vector<cv::Point2f> RandomShape(cv::Point2f centre, double radius, double angle_rad,
                                     Rng& rng) {
  Outline outline = Outlines()[rng.UniformInt(Outlines().size())];
  const auto c = static_cast<float>(radius * std::cos(angle_rad));
  const auto s = static_cast<float>(radius * std::sin(angle_rad));
  for (cv::Point2f& p : outline) p = centre + cv::Point2f(c * p.x - s * p.y, s * p.x + c * p.y);
  return outline;
}

std::vector<cv::Point2f> RandomBlob(cv::Point2f centre, double radius, Rng& rng) {
  const int corners = 7 + static_cast<int>(rng.UniformInt(5));
  const double stretch = rng.Uniform(0.5, 1.0);
  const double turn = rng.Uniform(0.0, 6.28);
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  Outline outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * 3.14159265358979 * i / corners;
    const double r = radius * rng.Uniform(0.65, 1.15);
    const double x = r * std::cos(angle);
    const double y = stretch * r * std::sin(angle);
    outline.push_back(
        centre + cv::Point2f(static_cast<float>(c * x - s * y), static_cast<float>(s * x + c * y)));
  }
  return outline;
}

void Scatter(cv::Mat& canvas, const ScatterOptions& options, const std::vector<Rgb>& colours,
             Rng& rng) {
  for (int i = 0; i < options.count; ++i) {
    const double t = rng.Uniform();
    const double radius =
        options.smallest_px + t * t * t * (options.largest_px - options.smallest_px);
    const cv::Point2f at = RandomPoint(canvas.size(), rng);
    const Rgb colour = Vary(colours[rng.UniformInt(colours.size())], 0.12, rng);
    FillPolygon(canvas, RandomBlob(at, radius, rng), colour);
  }
}

}  // namespace cvo::synth
