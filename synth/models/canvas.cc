// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/models/canvas.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

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

// A polygon from x and y of each corner.
Outline Corners(std::initializer_list<float> numbers) {
  Outline outline;
  for (const float* xy = numbers.begin(); xy != numbers.end(); xy += 2) {
    outline.emplace_back(xy[0], xy[1]);
  }
  return outline;
}

// A leaf, pointed at both ends.
Outline MakeLeaf() {
  return Corners(
      {-1, 0, -0.6f, 0.25f, 0, 0.36f, 0.6f, 0.25f, 1, 0, 0.6f, -0.25f, 0, -0.36f, -0.6f, -0.25f});
}

const std::vector<Outline>& Outlines() {
  static const std::vector<Outline> outlines = {
      MakeStar(24, 1.0), MakeStar(3, 1.0), MakeStar(10, 0.45), MakeStar(8, 0.5), MakeHalfDisc(),
      MakeLeaf(), Corners({-0.7f, -0.7f, 0.7f, -0.7f, 0.7f, 0.7f, -0.7f, 0.7f}),
      Corners({-1, -0.35f, 1, -0.35f, 1, 0.35f, -1, 0.35f}),
      Corners({-0.25f, -1, 0.25f, -1, 0.25f, 1, -0.25f, 1}),
      // Letters: L, T, E, H, Z, cross.
      Corners({-0.6f, -1, -0.1f, -1, -0.1f, 0.5f, 0.7f, 0.5f, 0.7f, 1, -0.6f, 1}),
      Corners({-0.8f, -1, 0.8f, -1, 0.8f, -0.5f, 0.25f, -0.5f, 0.25f, 1, -0.25f, 1, -0.25f, -0.5f,
               -0.8f, -0.5f}),
      Corners({-0.6f, -1,   0.6f,  -1,   0.6f,  -0.6f, -0.1f, -0.6f, -0.1f, -0.2f, 0.5f,  -0.2f,
               0.5f,  0.2f, -0.1f, 0.2f, -0.1f, 0.6f,  0.6f,  0.6f,  0.6f,  1,     -0.6f, 1}),
      Corners({-0.7f, -1, -0.25f, -1, -0.25f, -0.22f, 0.25f,  -0.22f, 0.25f,  -1, 0.7f,  -1,
               0.7f,  1,  0.25f,  1,  0.25f,  0.22f,  -0.25f, 0.22f,  -0.25f, 1,  -0.7f, 1}),
      Corners({-0.8f, -0.9f, 0.8f,  -0.9f, 0.8f,  -0.5f, -0.1f, 0.5f,  0.8f,  0.5f,
               0.8f,  0.9f,  -0.8f, 0.9f,  -0.8f, 0.5f,  0.1f,  -0.5f, -0.8f, -0.5f}),
      Corners({-0.3f, -0.9f, 0.3f, -0.9f, 0.3f, -0.3f, 0.9f, -0.3f, 0.9f,  0.3f,  0.3f, 0.3f, 0.3f,
               0.9f,  -0.3f, 0.9f, -0.3f, 0.3f, -0.9f, 0.3f, -0.9f, -0.3f, -0.3f, -0.3f})};
  return outlines;
}

constexpr int kFractionBits = 4;  // of coordinates passed to OpenCV

cv::Scalar ToScalar(const Rgb& colour) { return {colour[0], colour[1], colour[2]}; }

cv::Point ToFixed(cv::Point2f p, float dx, float dy) {
  constexpr float kOne = 1 << kFractionBits;
  return {static_cast<int>(std::lround((p.x + dx) * kOne)),
          static_cast<int>(std::lround((p.y + dy) * kOne))};
}

// Calls draw(dx, dy) for each shift by whole canvas sides that brings the box onto the canvas.
template <typename Draw>
void ForEachWrap(const cv::Mat& canvas, const cv::Rect2f& box, Draw draw) {
  const auto width = static_cast<float>(canvas.cols);
  const auto height = static_cast<float>(canvas.rows);
  for (float dy = -height; dy <= height; dy += height) {
    if (box.y + dy >= height || box.y + box.height + dy < 0.0f) continue;
    for (float dx = -width; dx <= width; dx += width) {
      if (box.x + dx >= width || box.x + box.width + dx < 0.0f) continue;
      draw(dx, dy);
    }
  }
}

cv::Rect2f BoxAround(const std::vector<cv::Point2f>& points) {
  cv::Point2f low = points.front();
  cv::Point2f high = low;
  for (const cv::Point2f& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return {low.x - 1.0f, low.y - 1.0f, high.x - low.x + 2.0f, high.y - low.y + 2.0f};
}

// Interpolation along one side: the lattice points before and after each pixel, and the weight of
// the latter.
struct LatticeTable {
  std::vector<int> before;
  std::vector<int> after;
  std::vector<float> weight;
};

LatticeTable MakeLatticeTable(int pixels, int cells) {
  LatticeTable table;
  for (int i = 0; i < pixels; ++i) {
    const double at = static_cast<double>(i) * cells / pixels;
    const int cell = static_cast<int>(at);
    const double t = at - cell;
    table.before.push_back(cell % cells);
    table.after.push_back((cell + 1) % cells);
    table.weight.push_back(static_cast<float>(t * t * (3.0 - 2.0 * t)));
  }
  return table;
}

void AddOctave(cv::Mat1f& noise, cv::Size cells, float strength, Rng& rng) {
  cv::Mat1f lattice(cells);
  for (float& value : lattice) value = strength * static_cast<float>(rng.Uniform(-1.0, 1.0));
  const LatticeTable across = MakeLatticeTable(noise.cols, cells.width);
  const LatticeTable down = MakeLatticeTable(noise.rows, cells.height);
  std::vector<float> line(cells.width);
  for (int y = 0; y < noise.rows; ++y) {
    const float* upper = lattice[down.before[y]];
    const float* lower = lattice[down.after[y]];
    for (int c = 0; c < cells.width; ++c) {
      line[c] = upper[c] + down.weight[y] * (lower[c] - upper[c]);
    }
    float* out = noise[y];
    for (int x = 0; x < noise.cols; ++x) {
      const float before = line[across.before[x]];
      out[x] += before + across.weight[x] * (line[across.after[x]] - before);
    }
  }
}

const std::vector<Palette>& Palettes() {
  static const std::vector<Palette> palettes = {
      {{{{240, 234, 214}, {33, 45, 64}, {196, 78, 58}, {224, 164, 88}, {92, 130, 140}}}},
      {{{{245, 240, 228}, {44, 36, 48}, {122, 70, 92}, {214, 158, 140}, {104, 128, 92}}}},
      {{{{236, 232, 222}, {28, 42, 48}, {38, 98, 110}, {214, 140, 62}, {170, 190, 170}}}},
      {{{{250, 244, 230}, {36, 52, 70}, {232, 112, 78}, {120, 176, 158}, {246, 206, 120}}}},
      {{{{238, 240, 242}, {26, 34, 52}, {52, 88, 140}, {226, 190, 86}, {178, 66, 62}}}},
      {{{{248, 242, 226}, {42, 54, 60}, {124, 160, 92}, {240, 196, 96}, {206, 88, 72}}}},
      {{{{250, 238, 222}, {48, 34, 62}, {94, 72, 136}, {222, 132, 112}, {150, 178, 190}}}},
      {{{{232, 238, 232}, {22, 50, 58}, {58, 124, 128}, {164, 196, 176}, {226, 120, 86}}}}};
  return palettes;
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

const Palette& RandomPalette(Rng& rng) { return Palettes()[rng.UniformInt(Palettes().size())]; }

Rgb Mix(const Rgb& a, const Rgb& b, double part_of_b) {
  const auto t = static_cast<float>(part_of_b);
  return a * (1.0f - t) + b * t;
}

Rgb Vary(const Rgb& colour, double part, Rng& rng) {
  return colour * static_cast<float>(1.0 + rng.Uniform(-part, part));
}

cv::Mat MakeCanvas(cv::Size size, const Rgb& colour) { return {size, CV_8UC3, ToScalar(colour)}; }

void FillPolygon(cv::Mat& canvas, const std::vector<cv::Point2f>& points, const Rgb& colour) {
  std::vector<std::vector<cv::Point>> outline(1);
  ForEachWrap(canvas, BoxAround(points), [&](float dx, float dy) {
    outline[0].clear();
    for (const cv::Point2f& p : points) outline[0].push_back(ToFixed(p, dx, dy));
    cv::fillPoly(canvas, outline, ToScalar(colour), cv::LINE_AA, kFractionBits);
  });
}

void FillDisc(cv::Mat& canvas, cv::Point2f centre, double radius, const Rgb& colour) {
  const auto r = static_cast<float>(radius);
  const cv::Rect2f box(centre.x - r - 1, centre.y - r - 1, 2 * r + 2, 2 * r + 2);
  ForEachWrap(canvas, box, [&](float dx, float dy) {
    cv::circle(canvas, ToFixed(centre, dx, dy),
               std::max(1, static_cast<int>(std::lround(r * (1 << kFractionBits)))),
               ToScalar(colour), cv::FILLED, cv::LINE_AA, kFractionBits);
  });
}

void FillBox(cv::Mat& canvas, const cv::Rect2f& box, const Rgb& colour) {
  const cv::Point2f a = box.tl();
  const cv::Point2f b = box.br();
  FillPolygon(canvas, {a, {b.x, a.y}, b, {a.x, b.y}}, colour);
}

void DrawLine(cv::Mat& canvas, cv::Point2f a, cv::Point2f b, double width, const Rgb& colour) {
  const cv::Point2f along = b - a;
  const double length = std::sqrt(along.dot(along));
  if (length < 1e-3) return;
  const auto scale = static_cast<float>(0.5 * width / length);
  const cv::Point2f aside(-along.y * scale, along.x * scale);
  FillPolygon(canvas, {a + aside, b + aside, b - aside, a - aside}, colour);
}

cv::Point2f RandomPoint(cv::Size size, Rng& rng) {
  return RandomPoint(
      cv::Rect2f(0, 0, static_cast<float>(size.width), static_cast<float>(size.height)), rng);
}

cv::Point2f RandomPoint(const cv::Rect2f& box, Rng& rng) {
  const double x = rng.Uniform(box.x, box.x + box.width);
  const double y = rng.Uniform(box.y, box.y + box.height);
  return {static_cast<float>(x), static_cast<float>(y)};
}

void DrawStamp(cv::Mat& canvas, const Stamp& stamp, Rng& rng) {
  FillPolygon(canvas, RandomShape(stamp.centre, stamp.radius, stamp.angle_rad, rng), stamp.colour);
}

void DrawCollage(cv::Mat& canvas, const cv::Rect2f& area, const CollageOptions& options,
                 const Palette& palette, Rng& rng) {
  std::vector<double> radii(options.shapes);
  for (double& radius : radii) {
    const double t = rng.Uniform();
    radius = options.smallest_px * std::pow(options.largest_px / options.smallest_px, t * t);
  }
  std::sort(radii.rbegin(), radii.rend());
  for (const double radius : radii) {
    const auto x = static_cast<float>(rng.Uniform(area.x, area.x + area.width));
    const auto y = static_cast<float>(rng.Uniform(area.y, area.y + area.height));
    const double angle = rng.Uniform() < 0.5 ? 0.0 : rng.Uniform(0.0, 6.28);
    const Rgb& colour = palette.Any(rng);
    const auto shape = RandomShape({x, y}, radius, angle, rng);
    FillPolygon(canvas, shape, Vary(colour, 0.1, rng));
  }
}

void DrawCrack(cv::Mat& canvas, cv::Point2f from, double length_px, double width_px,
               const Rgb& colour, Rng& rng) {
  double heading = rng.Uniform(0.0, 6.28);
  const double step = std::max(4.0, length_px / 14.0);
  for (double done = 0.0; done < length_px; done += step) {
    heading += rng.Uniform(-0.8, 0.8);
    const cv::Point2f to = from + cv::Point2f(static_cast<float>(step * std::cos(heading)),
                                              static_cast<float>(step * std::sin(heading)));
    DrawLine(canvas, from, to, width_px * (1.0 - 0.5 * done / length_px), colour);
    if (rng.Uniform() < 0.15) {
      DrawCrack(canvas, to, 0.4 * (length_px - done), 0.7 * width_px, colour, rng);
    }
    from = to;
  }
}

cv::Mat1f MakeNoise(cv::Size size, cv::Size cells, int octaves, Rng& rng) {
  cv::Mat1f noise(size, 0.0f);
  double total = 0.0;
  for (int octave = 0; octave < octaves; ++octave) total += std::ldexp(1.0, -octave);
  for (int octave = 0; octave < octaves; ++octave) {
    const cv::Size finer(std::min(size.width, cells.width << octave),
                         std::min(size.height, cells.height << octave));
    AddOctave(noise, finer, static_cast<float>(std::ldexp(1.0, -octave) / total), rng);
  }
  return noise;
}

void Shade(cv::Mat& canvas, const cv::Mat1f& noise, double strength) {
  const auto factor = static_cast<float>(strength);
  for (int y = 0; y < canvas.rows; ++y) {
    auto* pixel = canvas.ptr<cv::Vec3b>(y);
    const float* n = noise[y];
    for (int x = 0; x < canvas.cols; ++x) {
      const float gain = 1.0f + factor * n[x];
      for (int c = 0; c < 3; ++c) {
        pixel[x][c] = static_cast<uchar>(
            std::min(255.0f, std::max(0.0f, static_cast<float>(pixel[x][c]) * gain + 0.5f)));
      }
    }
  }
}

void Stain(cv::Mat& canvas, const cv::Mat1f& noise, double level, double softness,
           const Rgb& colour, double strength) {
  const auto offset = static_cast<float>(level);
  const auto slope = static_cast<float>(1.0 / softness);
  const auto most = static_cast<float>(strength);
  for (int y = 0; y < canvas.rows; ++y) {
    auto* pixel = canvas.ptr<cv::Vec3b>(y);
    const float* n = noise[y];
    for (int x = 0; x < canvas.cols; ++x) {
      const float blend = most * std::min(1.0f, std::max(0.0f, (n[x] - offset) * slope));
      if (blend <= 0.0f) continue;
      for (int c = 0; c < 3; ++c) {
        const auto value = static_cast<float>(pixel[x][c]);
        pixel[x][c] = static_cast<uchar>(std::min(255.0f, value + blend * (colour[c] - value)));
      }
    }
  }
}

}  // namespace cvo::synth
