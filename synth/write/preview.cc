// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "synth/truth/truth.h"
#include "synth/write/dataset.h"

namespace cvo::synth {
namespace {

const cv::Scalar kInk(60, 50, 45);  // BGR, of lines and text
using Path = std::vector<Eigen::Vector2d>;

constexpr int kMargin_px = 30;
constexpr int kSteps = 200;  // along each path

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

constexpr int kCells = 12;  // the last one shows the map
constexpr int kGap_px = 8;
constexpr int kTitle_px = 54;
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
const cv::Scalar kPaper(250, 248, 246);

// A cell of the sheet and the scale from frame pixels to cell pixels.
struct Cell {
  cv::Mat canvas;
  double scale = 1.0;

  cv::Point At(double u, double v) const {
    return {static_cast<int>(std::lround((u + 0.5) * scale)),
            static_cast<int>(std::lround((v + 0.5) * scale))};
  }
};

// Blends in about a quarter of the body's colour: more would hide the texture.
void Tint(const cv::Mat& instances, const std::vector<cv::Scalar>& colours, cv::Mat& image) {
  for (int v = 0; v < image.rows; ++v) {
    const auto* ids = instances.ptr<std::uint16_t>(v);
    auto* pixels = image.ptr<cv::Vec3b>(v);
    for (int u = 0; u < image.cols; ++u) {
      if (ids[u] == 0) continue;
      const cv::Scalar& colour = colours[ids[u] - 1U];
      for (int k = 0; k < 3; ++k) {
        pixels[u][k] = cv::saturate_cast<unsigned char>(0.72 * pixels[u][k] + 0.28 * colour[k]);
      }
    }
  }
}

// Draws a name on a patch of the given colour, within the image.
void DrawName(const std::string& name, cv::Point corner, const cv::Scalar& colour,
              cv::Mat& canvas) {
  int below_px = 0;
  const cv::Size text = cv::getTextSize(name, kFont, 0.4, 1, &below_px);
  const cv::Size patch(text.width + 6, text.height + 7);
  corner.x = std::clamp(corner.x, 0, std::max(0, canvas.cols - patch.width));
  corner.y = std::clamp(corner.y - patch.height, 0, std::max(0, canvas.rows - patch.height));
  cv::rectangle(canvas, cv::Rect(corner, patch), colour, cv::FILLED);
  const double light = 0.114 * colour[0] + 0.587 * colour[1] + 0.299 * colour[2];
  cv::putText(canvas, name, corner + cv::Point(3, text.height + 3), kFont, 0.4,
              light > 140.0 ? kInk : kPaper, 1, cv::LINE_AA);
}

void DrawBodies(const World& world, const FrameTruth& truth, const std::vector<cv::Scalar>& colours,
                Cell& cell) {
  for (std::size_t i = 0; i < truth.bodies.size(); ++i) {
    const BodyTruth& body = truth.bodies[i];
    if (!body.visible_box) continue;
    const ImageBox& box = *body.visible_box;
    cv::rectangle(cell.canvas, cell.At(box.left_px, box.top_px),
                  cell.At(box.right_px, box.bottom_px), colours[i], 1, cv::LINE_AA);
  }
  for (std::size_t i = 0; i < truth.bodies.size(); ++i) {
    const auto& box = truth.bodies[i].visible_box;
    if (box && truth.bodies[i].visible_px >= 150) {
      DrawName(world.bodies[i].name, cell.At(box->left_px, box->top_px), colours[i], cell.canvas);
    }
  }
}

void DrawFrame(const World& world, int frame, const DrawingTools& tools,
               const std::vector<cv::Scalar>& colours, Cell cell) {
  const Rendering rendering = tools.draw(ViewAt(world, world.Time_s(frame)));
  cv::Mat image = ColourOf(rendering.left);
  Tint(rendering.instances, colours, image);
  cv::resize(image, cell.canvas, cell.canvas.size(), 0, 0, cv::INTER_AREA);
  DrawBodies(world, ComputeTruth(world, frame, rendering), colours, cell);
  const std::string caption =
      StrCat("frame ", frame, ", ", FormatFixed(world.Time_s(frame), 2), " s");
  DrawName(caption, {cell.canvas.cols, cell.canvas.rows}, kPaper, cell.canvas);
}

// Number of columns for a sheet of about 3 : 2.
int Columns(const World& world) { return world.rig.width_px > 2 * world.rig.height_px ? 2 : 4; }

}  // namespace

std::vector<cv::Scalar> BodyColours(std::size_t bodies) {
  // Tableau's ten colours, which are easy to distinguish. They repeat in darker shades.
  constexpr std::array<int, 10> kRgb = {0x1f77b4, 0xff7f0e, 0x2ca02c, 0xd62728, 0x9467bd,
                                        0xbcbd22, 0xe377c2, 0x17becf, 0x8c564b, 0x7f7f7f};
  std::vector<cv::Scalar> colours;
  for (std::size_t i = 0; i < bodies; ++i) {
    const int rgb = kRgb[i % kRgb.size()];
    const double light = 1.0 / (1.0 + 0.35 * static_cast<double>(i / kRgb.size()));
    colours.emplace_back(light * (rgb & 255), light * ((rgb >> 8) & 255), light * (rgb >> 16));
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
  chart.Line(shapes[0], false, kInk, 2);
  chart.Dot(shapes[0].back(), 4, kInk);
}

cv::Mat MakeContactSheet(const World& world, int first, int end, const DrawingTools& tools,
                         const WorkHooks& hooks) {
  Require(0 <= first && first < end && end <= world.frames, "contact sheet: no such frames");
  const int columns = Columns(world);
  const int rows = kCells / columns;
  const double scale = (columns == 2 ? 880.0 : 480.0) / world.rig.width_px;
  const cv::Size size(static_cast<int>(std::lround(world.rig.width_px * scale)),
                      static_cast<int>(std::lround(world.rig.height_px * scale)));
  cv::Mat sheet(kTitle_px + rows * (size.height + kGap_px),
                columns * (size.width + kGap_px) + kGap_px, CV_8UC3, kPaper);
  cv::putText(sheet,
              StrCat(world.name, ": ", end - first, " frames, ", world.rate_hz, " Hz, ",
                     world.rig.width_px, " x ", world.rig.height_px, " px, ", world.bodies.size(),
                     world.bodies.size() == 1 ? " body" : " bodies"),
              {kGap_px + 2, 35}, kFont, 0.8, kInk, 1, cv::LINE_AA);
  const std::vector<cv::Scalar> colours = BodyColours(world.bodies.size());
  for (int i = 0; i < kCells; ++i) {
    hooks.ThrowIfStopped();
    const cv::Rect place(kGap_px + i % columns * (size.width + kGap_px),
                         kTitle_px + i / columns * (size.height + kGap_px), size.width,
                         size.height);
    if (i + 1 < kCells) {
      const int frame =
          first + static_cast<int>(std::lround((end - 1 - first) * i / (kCells - 2.0)));
      DrawFrame(world, frame, tools, colours, {sheet(place), scale});
    } else {
      DrawPathMap(world, first, end, colours, sheet(place));
    }
    hooks.Report(i + 1, kCells, "draw the contact sheet");
  }
  return sheet;
}

}  // namespace cvo::synth
