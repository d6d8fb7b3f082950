// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "reports/overlays/drawing/draw_cluster.h"
#include "reports/overlays/drawing/draw_overlay.h"
#include "reports/overlays/drawing/text_plate.h"

namespace cvo::reports {
namespace {

constexpr std::array kRanges_m = {2.0,  3.0,  4.0,  6.0,  8.0,  10.0, 15.0,
                                  20.0, 30.0, 40.0, 60.0, 80.0, 160.0};
constexpr Rgb kGrid{95, 98, 106};
constexpr Rgb kGridText{170, 172, 178};
constexpr Rgb kCamera{235, 235, 235};
constexpr double kFootprintOpacity = 0.45;

// The smallest range that includes the centres of all clusters in view, or else the largest one.
double RangeOf(const OverlayFrame& frame, const CameraInfo& camera) {
  double farthest_m = 0.0;
  for (const ClusterShape& cluster : frame.clusters) {
    if (!SeenRect(cluster, camera)) continue;
    farthest_m = std::max(farthest_m, cluster.center[2]);
  }
  for (const double range_m : kRanges_m) {
    if (range_m >= farthest_m) return range_m;
  }
  return kRanges_m.back();
}

// Maps metres in the xz plane of the camera to pixels of the picture.
struct GroundMap {
  cv::Point2d camera_px;
  double px_per_m = 1.0;

  cv::Point2d operator()(double right_m, double ahead_m) const {
    return camera_px + px_per_m * cv::Point2d(right_m, -ahead_m);
  }
  cv::Point2d operator()(const Position& position) const {
    return (*this)(position[0], position[2]);
  }
};

// Draws lines at half the range and at the whole range, and the edges of the field of view.
void DrawGround(const GroundMap& map, double range_m, const CameraInfo& camera,
                const OverlayStyle& style, cv::Mat& picture) {
  std::vector<Stroke> strokes;
  const double wide_m = picture.cols / map.px_per_m;
  for (const double ahead_m : {0.5 * range_m, range_m}) {
    strokes.push_back({{map(-wide_m, ahead_m), map(wide_m, ahead_m)}, kGrid, 1});
  }
  const double left = -camera.cx_px / camera.fx_px;
  const double right = (camera.width_px - camera.cx_px) / camera.fx_px;
  for (const double slope : {left, right}) {
    strokes.push_back({{map(0.0, 0.0), map(2.0 * slope * range_m, 2.0 * range_m)}, kGrid, 1});
  }
  DrawStrokes(strokes, 0.0, picture);
  PlateStyle text{style.text_px, {}, kGridText, 0.0};
  for (const double ahead_m : {0.5 * range_m, range_m}) {
    const cv::Point2d at = map(0.0, ahead_m);
    DrawPlate(StrCat(ahead_m, " m"), {0, static_cast<int>(at.y)}, text, picture);
  }
}

void DrawFootprint(const ClusterShape& cluster, Rgb color, const GroundMap& map,
                   const OverlayStyle& style, cv::Mat& picture) {
  // Corner i is at the positive end of axis k if bit k of i is set, and axis 1 points down. These
  // are the corners of the lower face, in their order around it.
  std::vector<cv::Point2d> points;
  for (const std::size_t corner : {2U, 3U, 7U, 6U}) points.push_back(map(cluster.corners[corner]));
  FillHull(points, color, cluster.predicted ? 0.5 * kFootprintOpacity : kFootprintOpacity, picture);
  std::vector<Stroke> strokes;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PixelSegment edge{points[i], points[(i + 1) % points.size()]};
    for (const PixelSegment& part :
         cluster.predicted ? Dashes(edge, 4.0, 3.0) : std::vector<PixelSegment>{edge}) {
      strokes.push_back({part, color, std::max(1, style.line_px - 1)});
    }
  }
  std::vector<cv::Point2d> path;
  for (const Position& position : cluster.trail) path.push_back(map(position));
  path.push_back(map(cluster.center));
  AddTrail(path, color, style.line_px, strokes);
  AddArrow({map(cluster.center), map(cluster.ahead)}, color, std::max(1, style.line_px - 1), 6.0,
           strokes);
  DrawStrokes(strokes, kRimOpacity, picture);
}

void DrawCamera(const GroundMap& map, double size_px, cv::Mat& picture) {
  const cv::Point2d tip = map(0.0, 0.0);
  const std::vector<cv::Point2d> wedge = {tip, tip + cv::Point2d(-0.6 * size_px, -size_px),
                                          tip + cv::Point2d(0.6 * size_px, -size_px)};
  FillHull(wedge, kCamera, 1.0, picture);
}

bool IsOnMap(const ClusterShape& cluster, double range_m) {
  const Position& at = cluster.center;
  return at[2] > 0.0 && at[2] < 1.2 * range_m && std::abs(at[0]) < 2.0 * range_m;
}

}  // namespace

void DrawBirdsEye(const OverlayFrame& frame, const CameraInfo& camera, const OverlayStyle& style,
                  cv::Mat& picture) {
  const double range_m = RangeOf(frame, camera);
  const double size_px = 0.9 * style.text_px;
  GroundMap map;
  map.camera_px = {0.5 * picture.cols, picture.rows - 2.0};
  map.px_per_m = (picture.rows - 0.5 * size_px) / (1.12 * range_m);
  DrawGround(map, range_m, camera, style, picture);
  for (const ClusterShape& cluster : frame.clusters) {
    if (!IsOnMap(cluster, range_m)) continue;
    DrawFootprint(cluster, ColorOf(frame, cluster.id), map, style, picture);
  }
  DrawCamera(map, size_px, picture);
  for (const ClusterShape& cluster : frame.clusters) {
    if (!IsOnMap(cluster, range_m)) continue;
    const Rgb color = ColorOf(frame, cluster.id);
    const cv::Point2d at = map(cluster.center);
    DrawPlate(StrCat(cluster.id), {static_cast<int>(at.x) + 4, static_cast<int>(at.y) + 2},
              {std::max(7, style.text_px - 2), color, TextColorOn(color)}, picture);
  }
}

}  // namespace cvo::reports
