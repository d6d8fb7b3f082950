// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <functional>

#include "reports/overlays/drawing/draw_cluster.h"
#include "reports/overlays/drawing/draw_overlay.h"
#include "reports/overlays/drawing/text_plate.h"

namespace cvo::reports {
namespace {

constexpr Rgb kLegendGround{24, 24, 28};
constexpr Rgb kLegendInk{200, 200, 204};
constexpr int kEdge_px = 2;

// A mark as drawn in the pictures, in the middle of a field, and its meaning.
struct LegendEntry {
  const char* meaning;
  std::function<void(cv::Rect, cv::Mat&)> draw;
  bool is_dot = false;  // a dot needs less room
};

cv::Point2d MiddleOf(cv::Rect field) {
  return {field.x + 0.5 * field.width - 0.5, field.y + 0.5 * field.height - 0.5};
}

LegendEntry Disc(const char* meaning, double radius_px, double rim_px, Rgb color) {
  return {meaning,
          [=](cv::Rect field, cv::Mat& bar) {
            DrawDisc(MiddleOf(field), radius_px, rim_px, color, bar);
          },
          true};
}

LegendEntry Frame(const char* meaning, int line_px, double dash_px, Rgb color) {
  return {meaning, [=](cv::Rect field, cv::Mat& bar) {
            const cv::Point2d a(field.x + 1, field.y + 3);
            const cv::Point2d c(field.br().x - 3, field.br().y - 4);
            const cv::Point2d b(c.x, a.y);
            const cv::Point2d d(a.x, c.y);
            std::vector<Stroke> strokes;
            for (const PixelSegment& side : {PixelSegment{a, b}, {b, c}, {c, d}, {d, a}}) {
              for (const PixelSegment& dash : dash_px > 0.0 ? Dashes(side, dash_px, 0.8 * dash_px)
                                                            : std::vector<PixelSegment>{side}) {
                strokes.push_back({dash, color, line_px});
              }
            }
            DrawStrokes(strokes, 0.0, bar);
          }};
}

std::vector<LegendEntry> EntriesOf(const OverlayStyle& style) {
  const Rgb color = ClusterColor(2);
  std::vector<LegendEntry> entries;
  if (style.has_landmarks) {
    if (style.has_clusters) {
      entries.push_back(Disc("landmark of a body", style.landmark_px, style.rim_px, color));
    }
    entries.push_back(Disc("static", style.static_px, style.rim_px, kStaticColor));
    entries.push_back(Disc("outlier", 0.5 * style.static_px, 0.0, kOutlierColor));
  }
  if (style.has_detections) entries.push_back(Frame("detection", 1, 0.0, kDetectionColor));
  if (style.wrong && style.has_landmarks) {
    entries.push_back(
        {"wrong label", [&style, color](cv::Rect field, cv::Mat& bar) {
           DrawDisc(MiddleOf(field), style.landmark_px + 2.6, 1.0, {255, 255, 255}, bar);
           DrawDisc(MiddleOf(field), style.landmark_px, 1.2, color, bar);
         }});
  }
  if (!style.boxes || !style.has_clusters) return entries;
  entries.push_back(Frame("3D box", style.line_px, 0.0, color));
  entries.push_back(Frame("predicted", style.line_px, 0.5 * style.dash_px, color));
  const auto along = [](cv::Rect field) {
    const double y = MiddleOf(field).y;
    return PixelSegment{{field.x + 1.0, y}, {field.br().x - 3.0, y}};
  };
  entries.push_back({"path, last 2 s", [&style, color, along](cv::Rect field, cv::Mat& bar) {
                       const auto [from, to] = along(field);
                       std::vector<Stroke> strokes;
                       AddTrail({from, 0.5 * (from + to), to}, color, style.line_px + 1, strokes);
                       DrawStrokes(strokes, 0.0, bar);
                     }});
  entries.push_back({"motion, next 0.5 s", [&style, color, along](cv::Rect field, cv::Mat& bar) {
                       std::vector<Stroke> strokes;
                       AddArrow(along(field), color, style.line_px, 0.0, strokes);
                       DrawStrokes(strokes, 0.0, bar);
                     }});
  return entries;
}

}  // namespace

cv::Mat LegendBar(const OverlayStyle& style, int width_px) {
  const int row_px = PlateSize("x", style.text_px).height + 2;
  const std::vector<LegendEntry> entries = EntriesOf(style);
  if (entries.empty()) return cv::Mat(0, width_px, CV_8UC3);
  std::vector<cv::Rect> fields;
  cv::Point at(kEdge_px, kEdge_px);
  for (const LegendEntry& entry : entries) {
    const int symbol_px = entry.is_dot ? row_px : 2 * row_px;
    const int entry_px = symbol_px + PlateSize(entry.meaning, style.text_px).width;
    if (at.x > kEdge_px && at.x + entry_px > width_px) at = {kEdge_px, at.y + row_px};
    fields.emplace_back(at, cv::Size(symbol_px, row_px));
    at.x += entry_px + style.text_px / 2;
  }
  cv::Mat bar(at.y + row_px + kEdge_px, width_px, CV_8UC3, Bgr(kLegendGround));
  for (std::size_t i = 0; i < entries.size(); ++i) {
    entries[i].draw(fields[i], bar);
    DrawPlate(entries[i].meaning, {fields[i].br().x, fields[i].y + 1},
              {style.text_px, kLegendGround, kLegendInk}, bar);
  }
  return bar;
}

}  // namespace cvo::reports
