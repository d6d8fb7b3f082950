// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/drawing/project.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cvo::reports {
namespace {

constexpr double kNear_m = 0.1;

Position Cross(const Position& a, const Position& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Rotates p by the unit quaternion (v, w): p + 2 w (v x p) + 2 v x (v x p).
Position Rotate(const Position& v, double w, const Position& p) {
  const Position once = Cross(v, p);
  const Position twice = Cross(v, once);
  Position rotated;
  for (std::size_t i = 0; i < 3; ++i) rotated[i] = p[i] + 2.0 * (w * once[i] + twice[i]);
  return rotated;
}

cv::Point2d Pixel(const Position& p, const CameraInfo& camera) {
  return {camera.fx_px * p[0] / p[2] + camera.cx_px, camera.fy_px * p[1] / p[2] + camera.cy_px};
}

bool IsFinite(cv::Point2d pixel) { return std::isfinite(pixel.x) && std::isfinite(pixel.y); }

Position Between(const Position& a, const Position& b, double fraction) {
  Position p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = a[i] + fraction * (b[i] - a[i]);
  return p;
}

}  // namespace

Position Transform(const Pose& a_from_b, const Position& p_in_b) {
  Position p = Rotate({a_from_b[3], a_from_b[4], a_from_b[5]}, a_from_b[6], p_in_b);
  for (std::size_t i = 0; i < 3; ++i) p[i] += a_from_b[i];
  return p;
}

Position TransformBack(const Pose& a_from_b, const Position& p_in_a) {
  Position p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = p_in_a[i] - a_from_b[i];
  return Rotate({-a_from_b[3], -a_from_b[4], -a_from_b[5]}, a_from_b[6], p);
}

CameraInfo ScaledCamera(const CameraInfo& camera, double scale) {
  CameraInfo scaled = camera;
  scaled.width_px = static_cast<int>(camera.width_px * scale + 0.5);
  scaled.height_px = static_cast<int>(camera.height_px * scale + 0.5);
  scaled.fx_px = camera.fx_px * scale;
  scaled.fy_px = camera.fy_px * scale;
  scaled.cx_px = (camera.cx_px + 0.5) * scale - 0.5;
  scaled.cy_px = (camera.cy_px + 0.5) * scale - 0.5;
  return scaled;
}

std::optional<cv::Point2d> ProjectPoint(const Position& p_in_camera, const CameraInfo& camera) {
  if (!(p_in_camera[2] >= kNear_m)) return std::nullopt;
  const cv::Point2d pixel = Pixel(p_in_camera, camera);
  if (!IsFinite(pixel)) return std::nullopt;
  return pixel;
}

std::optional<PixelSegment> ProjectSegment(const Position& a, const Position& b,
                                           const CameraInfo& camera) {
  const bool a_seen = a[2] >= kNear_m;
  const bool b_seen = b[2] >= kNear_m;
  if (!a_seen && !b_seen) return std::nullopt;
  const auto at_near = [&] { return Between(a, b, (kNear_m - a[2]) / (b[2] - a[2])); };
  const PixelSegment segment = {Pixel(a_seen ? a : at_near(), camera),
                                Pixel(b_seen ? b : at_near(), camera)};
  if (!IsFinite(segment.first) || !IsFinite(segment.second)) return std::nullopt;
  return segment;
}

std::vector<PixelSegment> ProjectEdges(const std::array<Position, 8>& corners,
                                       const CameraInfo& camera) {
  std::vector<PixelSegment> edges;
  for (std::size_t i = 0; i < 8; ++i) {
    for (const std::size_t bit : {1U, 2U, 4U}) {
      if ((i & bit) != 0) continue;
      const auto edge = ProjectSegment(corners[i], corners[i | bit], camera);
      if (edge) edges.push_back(*edge);
    }
  }
  return edges;
}

// Liang-Barsky: finds the fractions of the segment at which it enters and leaves the area.
std::optional<PixelSegment> ClipSegment(const PixelSegment& segment, cv::Size image,
                                        double margin_px) {
  const auto& [a, b] = segment;
  const cv::Point2d step = b - a;
  double enters = 0.0;
  double leaves = 1.0;
  const std::array<std::pair<double, double>, 4> sides = {
      {{-step.x, a.x + margin_px},
       {step.x, image.width - 1 + margin_px - a.x},
       {-step.y, a.y + margin_px},
       {step.y, image.height - 1 + margin_px - a.y}}};
  for (const auto& [speed, room] : sides) {
    if (!(speed != 0.0)) {
      if (room < 0.0) return std::nullopt;
      continue;
    }
    const double fraction = room / speed;
    if (speed < 0.0) {
      enters = std::max(enters, fraction);
    } else {
      leaves = std::min(leaves, fraction);
    }
  }
  if (!(enters <= leaves)) return std::nullopt;
  return PixelSegment{a + enters * step, a + leaves * step};
}

}  // namespace cvo::reports
