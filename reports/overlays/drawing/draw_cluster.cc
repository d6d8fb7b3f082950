// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/drawing/draw_cluster.h"

#include <algorithm>
#include <cmath>

#include "reports/overlays/drawing/strokes.h"

namespace cvo::reports {
namespace {

constexpr double kGhostOpacity = 0.28;

std::vector<cv::Point2d> Outline(const ClusterShape& cluster, const CameraInfo& camera) {
  std::vector<cv::Point2d> points;
  for (const auto& [a, b] : ProjectEdges(cluster.corners, camera)) {
    points.push_back(a);
    points.push_back(b);
  }
  return points;
}

// The pixels of the centre in the preceding frames and in this one, where it is in front of the
// camera.
std::vector<cv::Point2d> PathOf(const ClusterShape& cluster, const CameraInfo& camera) {
  std::vector<cv::Point2d> path;
  for (const Position& position : cluster.trail) {
    if (const auto at = ProjectPoint(position, camera)) path.push_back(*at);
  }
  if (const auto at = ProjectPoint(cluster.center, camera)) path.push_back(*at);
  return path;
}

}  // namespace

void AddTrail(const std::vector<cv::Point2d>& path, Rgb color, int width_px,
              std::vector<Stroke>& strokes) {
  const std::size_t count = path.size();
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const double youth = static_cast<double>(i + 1) / static_cast<double>(count - 1);
    const int width = std::max(1, static_cast<int>(std::lround(youth * width_px)));
    strokes.push_back({{path[i], path[i + 1]}, color, width});
  }
}

void AddArrow(const PixelSegment& shaft, Rgb color, int line_px, double shortest_px,
              std::vector<Stroke>& strokes) {
  const auto& [from, to] = shaft;
  const cv::Point2d along = to - from;
  const double length_px = std::hypot(along.x, along.y);
  if (!(length_px >= shortest_px)) return;
  const int width_px = line_px + 1;
  strokes.push_back({shaft, color, width_px});
  const double head_px = std::min(0.45 * length_px, 4.0 * line_px + 4.0);
  const cv::Point2d back = -head_px / length_px * along;
  const cv::Point2d aside(-0.5 * back.y, 0.5 * back.x);
  strokes.push_back({{to, to + back + aside}, color, width_px});
  strokes.push_back({{to, to + back - aside}, color, width_px});
}

Rgb ColorOf(const OverlayFrame& frame, std::int64_t id) {
  const auto other = frame.color_ids.find(id);
  return ClusterColor(other == frame.color_ids.end() ? id : other->second);
}

std::optional<cv::Rect> SeenRect(const ClusterShape& cluster, const CameraInfo& camera) {
  const cv::Size size(camera.width_px, camera.height_px);
  const std::vector<cv::Point2d> points = Outline(cluster, camera);
  if (points.empty()) return std::nullopt;
  cv::Point2d low = points.front();
  cv::Point2d high = points.front();
  for (const cv::Point2d& point : points) {
    low = {std::min(low.x, point.x), std::min(low.y, point.y)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y)};
  }
  const bool seen =
      high.x >= 0.0 && high.y >= 0.0 && low.x <= size.width - 1 && low.y <= size.height - 1;
  if (!seen) return std::nullopt;
  const cv::Point first(static_cast<int>(std::max(low.x, 0.0)),
                        static_cast<int>(std::max(low.y, 0.0)));
  const cv::Point last(static_cast<int>(std::min(high.x, size.width - 1.0)),
                       static_cast<int>(std::min(high.y, size.height - 1.0)));
  return cv::Rect(first, last + cv::Point(1, 1));
}

void FillGhosts(const OverlayFrame& frame, const CameraInfo& camera, cv::Mat& picture) {
  for (const ClusterShape& cluster : frame.clusters) {
    if (!cluster.predicted) continue;
    FillHull(Outline(cluster, camera), ColorOf(frame, cluster.id), kGhostOpacity, picture);
  }
}

void DrawBoxes(const OverlayFrame& frame, const CameraInfo& camera, const OverlayStyle& style,
               cv::Mat& picture) {
  std::vector<Stroke> strokes;
  for (const ClusterShape& cluster : frame.clusters) {
    const Rgb color = ColorOf(frame, cluster.id);
    for (const PixelSegment& edge : ProjectEdges(cluster.corners, camera)) {
      const auto seen = ClipSegment(edge, picture.size(), style.dash_px);
      if (!seen) continue;
      if (!cluster.predicted) {
        strokes.push_back({*seen, color, style.line_px});
        continue;
      }
      for (const PixelSegment& dash : Dashes(*seen, style.dash_px, 0.8 * style.dash_px)) {
        strokes.push_back({dash, color, style.line_px});
      }
    }
  }
  DrawStrokes(strokes, kRimOpacity, picture);
}

void DrawMotion(const OverlayFrame& frame, const CameraInfo& camera, const OverlayStyle& style,
                cv::Mat& picture) {
  std::vector<Stroke> strokes;
  const double shortest_px = 2.5 * style.landmark_px;
  for (const ClusterShape& cluster : frame.clusters) {
    if (!SeenRect(cluster, camera)) continue;
    const Rgb color = ColorOf(frame, cluster.id);
    AddTrail(PathOf(cluster, camera), color, style.line_px + 1, strokes);
    const auto shaft = ProjectSegment(cluster.center, cluster.ahead, camera);
    if (shaft) AddArrow(*shaft, color, style.line_px, shortest_px, strokes);
  }
  DrawStrokes(strokes, kRimOpacity, picture);
}

}  // namespace cvo::reports
