// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/kitti_ap/box_overlap.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/error.h"

namespace cvo {
namespace {

using Polygon = std::vector<Eigen::Vector2d>;
using Box3d = ObjectBox::Box3d;

double Overlap(double low_a, double high_a, double low_b, double high_b) {
  return std::max(0.0, std::min(high_a, high_b) - std::max(low_a, low_b));
}

double AreaPx2(const ObjectBox& box) {
  return std::max(0.0, box.right_px - box.left_px) * std::max(0.0, box.bottom_px - box.top_px);
}

double IntersectionPx2(const ObjectBox& a, const ObjectBox& b) {
  return Overlap(a.left_px, a.right_px, b.left_px, b.right_px) *
         Overlap(a.top_px, a.bottom_px, b.top_px, b.bottom_px);
}

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Corners in x-z, ordered so that the inside is to the left of each side. At heading 0 the length
// is along x.
Polygon Footprint(const Box3d& box) {
  const Eigen::Vector2d center(box.bottom_in_camera.x(), box.bottom_in_camera.z());
  const double c = std::cos(box.heading_rad);
  const double s = std::sin(box.heading_rad);
  const Eigen::Vector2d along = 0.5 * box.length_m * Eigen::Vector2d(c, -s);
  const Eigen::Vector2d across = 0.5 * box.width_m * Eigen::Vector2d(s, c);
  return {center + along + across, center - along + across, center - along - across,
          center + along - across};
}

// Returns the part of a convex polygon to the left of the line from `from` to `to`.
Polygon Clip(const Polygon& polygon, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    const double at_a = Cross(to - from, a - from);
    const double at_b = Cross(to - from, b - from);
    if (at_a >= 0.0) kept.push_back(a);
    if ((at_a > 0.0 && at_b < 0.0) || (at_a < 0.0 && at_b > 0.0)) {
      kept.push_back(a + at_a / (at_a - at_b) * (b - a));
    }
  }
  return kept;
}

double Area(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    twice += Cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  }
  return 0.5 * std::abs(twice);
}

double IntersectionOnGround_m2(const Box3d& a, const Box3d& b) {
  Polygon common = Footprint(a);
  const Polygon sides = Footprint(b);
  for (std::size_t i = 0; i < sides.size() && !common.empty(); ++i) {
    common = Clip(common, sides[i], sides[(i + 1) % sides.size()]);
  }
  return Area(common);
}

double Ratio(double intersection, double of) { return of > 0.0 ? intersection / of : 0.0; }

double OverUnion(double intersection, double a, double b) {
  return Ratio(intersection, a + b - intersection);
}

}  // namespace

double IntersectionOverUnion(BoxSpace space, const ObjectBox& a, const ObjectBox& b) {
  if (space == BoxSpace::kImage) return OverUnion(IntersectionPx2(a, b), AreaPx2(a), AreaPx2(b));
  if (!a.box3d || !b.box3d) return 0.0;
  const double ground_m2 = IntersectionOnGround_m2(*a.box3d, *b.box3d);
  const double area_a_m2 = a.box3d->length_m * a.box3d->width_m;
  const double area_b_m2 = b.box3d->length_m * b.box3d->width_m;
  if (space == BoxSpace::kBirdsEye) return OverUnion(ground_m2, area_a_m2, area_b_m2);
  const double bottom_a = a.box3d->bottom_in_camera.y();  // y points down
  const double bottom_b = b.box3d->bottom_in_camera.y();
  const double height_m =
      Overlap(bottom_a - a.box3d->height_m, bottom_a, bottom_b - b.box3d->height_m, bottom_b);
  return OverUnion(ground_m2 * height_m, area_a_m2 * a.box3d->height_m,
                   area_b_m2 * b.box3d->height_m);
}

double ShareInside(const ObjectBox& detection, const ObjectBox& region) {
  return Ratio(IntersectionPx2(detection, region), AreaPx2(detection));
}

}  // namespace cvo
