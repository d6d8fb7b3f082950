// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "reports/overlays/drawing/draw_cluster.h"
#include "reports/overlays/drawing/strokes.h"
#include "reports/overlays/drawing/text_plate.h"
#include "reports/overlays/panels.h"

namespace cvo::reports {
namespace {

constexpr Rgb kChartGround{16, 18, 24};
constexpr Rgb kAxis{120, 122, 130};
constexpr Rgb kFaint{52, 55, 62};
constexpr Rgb kNow{235, 235, 235};
constexpr Rgb kText{190, 192, 198};

// The plotting area, its range of frames, and the error at its upper edge.
struct ChartArea {
  cv::Rect field;
  int first_frame = 0;
  int last_frame = 1;
  double most_m = 1.0;

  cv::Point2d At(double frame, double error_m) const {
    const double along = (frame - first_frame) / std::max(1, last_frame - first_frame);
    return {field.x + along * field.width,
            field.br().y - std::min(error_m / most_m, 1.0) * field.height};
  }
};

// The smallest of 1, 2 or 5 times a power of ten, at least 1 mm, that 98 % of the errors do not
// exceed. 0 if there are no errors.
double NiceLimit(const OverlayRun& run) {
  std::vector<double> errors_m;
  for (const BodyDetail& body : run.detail.bodies) {
    for (const BodyPosition& at : body.estimated) errors_m.push_back(at.error_m);
  }
  if (errors_m.empty()) return 0.0;
  std::sort(errors_m.begin(), errors_m.end());
  const double high_m = errors_m[(errors_m.size() - 1) * 98 / 100];
  double limit_m = 0.001;
  for (int i = 0; limit_m < high_m && i < 30; ++i) limit_m *= i % 3 == 1 ? 2.5 : 2.0;
  return limit_m;
}

std::string ErrorText(double error_m, double most_m) {
  if (most_m > 0.5) return FormatGeneral(error_m, 2) + " m";
  return FormatGeneral(100.0 * error_m, 2) + " cm";
}

void DrawAxes(const ChartArea& area, int text_px, cv::Mat& chart) {
  std::vector<Stroke> strokes;
  const PlateStyle text{text_px, {}, kText, 0.0};
  for (const double part : {0.0, 0.5, 1.0}) {
    const double error_m = part * area.most_m;
    const cv::Point2d from = area.At(area.first_frame, error_m);
    strokes.push_back({{from, area.At(area.last_frame, error_m)}, part > 0.0 ? kFaint : kAxis, 1});
    const std::string label = part > 0.0 ? ErrorText(error_m, area.most_m) : "0";
    const cv::Size size = PlateSize(label, text_px);
    DrawPlate(label, {area.field.x - size.width, static_cast<int>(from.y) - size.height / 2}, text,
              chart);
  }
  DrawStrokes(strokes, 0.0, chart);
  const int below = area.field.br().y + 2;
  const std::string last = StrCat(area.last_frame);
  DrawPlate(StrCat("frame ", area.first_frame), {area.field.x, below}, text, chart);
  DrawPlate(last, {area.field.br().x - PlateSize(last, text_px).width, below}, text, chart);
}

// Appends the error of a body over time as a line, broken at frames without an estimate.
void AddBody(const BodyDetail& body, Rgb color, const ChartArea& area,
             std::vector<Stroke>& strokes) {
  for (std::size_t i = 1; i < body.estimated.size(); ++i) {
    const BodyPosition& from = body.estimated[i - 1];
    const BodyPosition& to = body.estimated[i];
    if (to.frame != from.frame + 1) continue;
    strokes.push_back(
        {{area.At(from.frame, from.error_m), area.At(to.frame, to.error_m)}, color, 2});
  }
}

}  // namespace

cv::Mat ErrorChart(const OverlayRun& run, int frame, int text_px, cv::Size size) {
  cv::Mat chart(size, CV_8UC3, Bgr(kChartGround));
  ChartArea area;
  area.most_m = NiceLimit(run);
  if (!(area.most_m > 0.0) || run.detail.camera.empty()) {
    DrawPlate("no ground truth of bodies that are estimated", {text_px, text_px},
              {text_px, kChartGround, kText}, chart);
    return chart;
  }
  area.first_frame = run.detail.camera.front().frame;
  area.last_frame = run.detail.camera.back().frame;
  const int left = 7 * text_px;
  area.field = {left, 2 * text_px, size.width - left - 2 * text_px, size.height - 5 * text_px};
  DrawAxes(area, text_px, chart);
  std::vector<Stroke> strokes = {{{area.At(frame, 0.0), area.At(frame, area.most_m)}, kNow, 1}};
  OverlayFrame colors;
  colors.color_ids = run.color_ids;
  for (const BodyDetail& body : run.detail.bodies) {
    AddBody(body, ColorOf(colors, body.cluster), area, strokes);
  }
  DrawStrokes(strokes, 0.0, chart);
  return chart;
}

}  // namespace cvo::reports
