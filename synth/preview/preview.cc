// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/preview/preview.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/files/text/number.h"
#include "synth/preview/path_map.h"
#include "synth/truth/truth.h"

namespace cvo::synth {
namespace {

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

void DrawDashes(const cv::Point& a, const cv::Point& b, const cv::Scalar& colour, cv::Mat& canvas) {
  constexpr double kDash_px = 5.0;
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const int dashes = std::max(1, static_cast<int>(length / kDash_px));
  for (int i = 0; i < dashes; i += 2) {
    const auto at = [&](double s) {
      return cv::Point(static_cast<int>(std::lround(a.x + s * (b.x - a.x))),
                       static_cast<int>(std::lround(a.y + s * (b.y - a.y))));
    };
    cv::line(canvas, at(double(i) / dashes), at(std::min(1.0, (i + 1.0) / dashes)), colour, 1,
             cv::LINE_AA);
  }
}

void DrawAmodalBox(const PixelBox& box, const cv::Scalar& colour, Cell& cell) {
  const cv::Point corners[4] = {cell.At(box.left, box.top), cell.At(box.right, box.top),
                                cell.At(box.right, box.bottom), cell.At(box.left, box.bottom)};
  for (int i = 0; i < 4; ++i) DrawDashes(corners[i], corners[(i + 1) % 4], colour, cell.canvas);
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
    if (body.amodal_box) DrawAmodalBox(*body.amodal_box, colours[i], cell);
    if (!body.visible_box) continue;
    const PixelBox& box = *body.visible_box;
    cv::rectangle(cell.canvas, cell.At(box.left, box.top), cell.At(box.right, box.bottom),
                  colours[i], 1, cv::LINE_AA);
  }
  for (std::size_t i = 0; i < truth.bodies.size(); ++i) {
    const auto& box = truth.bodies[i].visible_box;
    if (box && truth.bodies[i].visible_px >= 150) {
      DrawName(world.bodies[i].name, cell.At(box->left, box->top), colours[i], cell.canvas);
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
