// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/preview/path_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"

namespace cvo::synth {
namespace {

constexpr int kMargin_px = 30;
constexpr int kSteps = 200;  // along each path

using Path = std::vector<Eigen::Vector2d>;

// Maps metres to the canvas. Coordinates are in sixteenths of a pixel, as drawing with 4 fractional
// bits needs.
class Chart {
 public:
  Chart(const std::vector<Path>& paths, const cv::Mat& canvas) : canvas_(canvas) {
    Eigen::Vector2d low = paths.front().front(), high = low;
    for (const Path& path : paths) {
      for (const Eigen::Vector2d& p : path) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
    }
    const Eigen::Vector2d extent = (high - low).cwiseMax(1.0);
    pixels_per_m_ = std::min((canvas.cols - 2.0 * kMargin_px) / extent.x(),
                             (canvas.rows - 2.5 * kMargin_px) / extent.y());
    middle_ = (low + high) / 2.0;
  }

  cv::Point At(const Eigen::Vector2d& p) const {
    const Eigen::Vector2d offset = pixels_per_m_ * (p - middle_);
    return {
        static_cast<int>(std::lround(16.0 * (canvas_.cols / 2.0 + offset.x()))),
        static_cast<int>(std::lround(16.0 * (canvas_.rows / 2.0 - kMargin_px / 4.0 - offset.y())))};
  }

  void Line(const Path& path, bool closed, const cv::Scalar& colour, int width_px) {
    std::vector<cv::Point> points;
    for (const Eigen::Vector2d& p : path) points.push_back(At(p));
    cv::polylines(canvas_, points, closed, colour, width_px, cv::LINE_AA, 4);
  }
  void Dot(const Eigen::Vector2d& p, int radius_px, const cv::Scalar& colour) {
    cv::circle(canvas_, At(p), 16 * radius_px, colour, cv::FILLED, cv::LINE_AA, 4);
  }
  double pixels_per_m() const { return pixels_per_m_; }

 private:
  cv::Mat canvas_;
  double pixels_per_m_ = 1.0;
  Eigen::Vector2d middle_ = Eigen::Vector2d::Zero();
};

double StepTime_s(const World& world, int first, int end, int step) {
  return world.Time_s(first) + (world.Time_s(end - 1) - world.Time_s(first)) * step / kSteps;
}

Path PathOf(const World& world, const Motion& motion, int first, int end) {
  Path path;
  for (int step = 0; step <= kSteps; ++step) {
    const MotionState state = motion.At(StepTime_s(world, first, end, step));
    path.emplace_back(state.world_from_body.translation().head<2>());
  }
  return path;
}

Path BoxFromAbove(const Body& body, const RigidTransform& world_from_body) {
  Path corners;
  for (const auto& [x, y] :
       {std::pair(1, 1), std::pair(-1, 1), std::pair(-1, -1), std::pair(1, -1)}) {
    const Eigen::Vector3d corner(x * body.size_m.x() / 2.0, y * body.size_m.y() / 2.0, 0.0);
    corners.emplace_back((world_from_body * corner).head<2>());
  }
  return corners;
}

// The camera's field of view at the start, as two short lines.
Path ViewWedge(const World& world, double time_s, double length_m) {
  const RigidTransform world_from_left = world.camera->At(time_s).world_from_body;
  const double slope = world.rig.width_px / 2.0 / world.rig.fx;
  Path wedge;
  for (const double side : {-slope, 0.0, slope}) {
    const Eigen::Vector3d p = side == 0.0 ? Eigen::Vector3d(0.0, 0.0, 0.0)
                                          : Eigen::Vector3d(side * length_m, 0.0, length_m);
    wedge.emplace_back((world_from_left * p).head<2>());
  }
  return wedge;
}

// Draws the longest of 0.1, 0.2, 0.5, 1, ... 100 m that takes at most a third of the width.
void DrawScaleBar(double pixels_per_m, cv::Mat& canvas) {
  double length_m = 0.1;
  for (const double step : {2.0, 2.5, 2.0, 2.0, 2.5, 2.0, 2.0, 2.5, 2.0}) {
    if (length_m * step * pixels_per_m > canvas.cols / 3.0) break;
    length_m *= step;
  }
  const cv::Point left(12, canvas.rows - 12);
  const cv::Point right = left + cv::Point(static_cast<int>(length_m * pixels_per_m), 0);
  cv::line(canvas, left, right, kInk, 2);
  for (const cv::Point& end : {left, right}) {
    cv::line(canvas, end - cv::Point(0, 4), end + cv::Point(0, 4), kInk, 2);
  }
  cv::putText(canvas, StrCat(length_m, " m"), right + cv::Point(10, 4), cv::FONT_HERSHEY_SIMPLEX,
              0.4, kInk, 1, cv::LINE_AA);
}

}  // namespace

std::vector<cv::Scalar> BodyColours(std::size_t bodies) {
  // Tableau's ten colours, which are easy to distinguish. They repeat in darker shades.
  constexpr std::array<std::array<int, 3>, 10> kRgb = {{{31, 119, 180},
                                                        {255, 127, 14},
                                                        {44, 160, 44},
                                                        {214, 39, 40},
                                                        {148, 103, 189},
                                                        {188, 189, 34},
                                                        {227, 119, 194},
                                                        {23, 190, 207},
                                                        {140, 86, 75},
                                                        {127, 127, 127}}};
  std::vector<cv::Scalar> colours;
  for (std::size_t i = 0; i < bodies; ++i) {
    const auto& [r, g, b] = kRgb[i % kRgb.size()];
    const double light = 1.0 / (1.0 + 0.35 * static_cast<double>(i / kRgb.size()));
    colours.emplace_back(light * b, light * g, light * r);
  }
  return colours;
}

void DrawPathMap(const World& world, int first, int end, const std::vector<cv::Scalar>& colours,
                 cv::Mat canvas) {
  canvas.setTo(cv::Scalar(255, 255, 255));
  cv::rectangle(canvas, cv::Rect(0, 0, canvas.cols, canvas.rows), cv::Scalar(215, 210, 205), 1);
  const double start_s = world.Time_s(first);
  std::vector<Path> shapes = {PathOf(world, *world.camera, first, end)};
  for (const Body& body : world.bodies) {
    shapes.push_back(PathOf(world, *body.motion, first, end));
    shapes.push_back(BoxFromAbove(body, body.motion->At(start_s).world_from_body));
  }
  Chart chart(shapes, canvas);
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const Path& path = shapes[1 + 2 * i];
    chart.Line(shapes[2 + 2 * i], true, colours[i], 1);
    chart.Line(path, false, colours[i], 2);
    chart.Dot(path.back(), 3, colours[i]);
  }
  chart.Line(ViewWedge(world, start_s, 45.0 / chart.pixels_per_m()), false, kInk, 1);
  chart.Line(shapes[0], false, kInk, 2);
  chart.Dot(shapes[0].back(), 4, kInk);
  DrawScaleBar(chart.pixels_per_m(), canvas);
}

}  // namespace cvo::synth
