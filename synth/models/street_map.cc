// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "synth/models/build.h"

namespace cvo::synth {
namespace {

using Eigen::Vector2d;

void AppendLeg(std::vector<Vector2d>& line, const Vector2d& to, double step_m) {
  const Vector2d from = line.back();
  const double length = (to - from).norm();
  if (length < 1e-9) return;
  const int steps = std::max(1, static_cast<int>(std::lround(length / step_m)));
  for (int i = 1; i <= steps; ++i) {
    line.push_back(from + (to - from) * (static_cast<double>(i) / steps));
  }
}

struct Corner {
  Vector2d before;  // unit direction of the leg that ends here
  Vector2d after;
  Vector2d at;
  double reach_m;  // length that each leg can spare
};

void AppendArc(std::vector<Vector2d>& line, const Corner& corner, double radius_m, double step_m) {
  const double cross = corner.before.x() * corner.after.y() - corner.before.y() * corner.after.x();
  const double turn = std::atan2(cross, corner.before.dot(corner.after));
  const double half_tangent = std::tan(0.5 * std::abs(turn));
  if (half_tangent < 1e-6) return AppendLeg(line, corner.at, step_m);
  const double radius = std::min(radius_m, corner.reach_m / half_tangent);
  const Vector2d start = corner.at - radius * half_tangent * corner.before;
  AppendLeg(line, start, step_m);
  const double side = turn > 0.0 ? 1.0 : -1.0;
  const Vector2d left(-corner.before.y(), corner.before.x());
  const Vector2d centre = start + side * radius * left;
  const int steps = std::max(2, static_cast<int>(std::ceil(std::abs(turn) * radius / step_m)));
  for (int i = 1; i <= steps; ++i) {
    const double angle = std::abs(turn) * i / steps;
    line.push_back(centre +
                   radius * (std::sin(angle) * corner.before - side * std::cos(angle) * left));
  }
}

Vector2d LeftOf(const Vector2d& v) { return {-v.y(), v.x()}; }

// Half the length of the projection of a plot onto an axis.
double Reach(const Plot& plot, const Vector2d& axis) {
  return std::abs(axis.dot(plot.forward)) * plot.half_m.x() +
         std::abs(axis.dot(LeftOf(plot.forward))) * plot.half_m.y();
}

double DistanceToPlot(const Plot& plot, const Vector2d& point) {
  const Vector2d to = point - plot.middle;
  const Vector2d local(std::abs(to.dot(plot.forward)), std::abs(to.dot(LeftOf(plot.forward))));
  return (local - plot.half_m).cwiseMax(0.0).norm();
}

}  // namespace

std::vector<Vector2d> RoundedPolyline(const std::vector<Vector2d>& points, double radius_m,
                                      double step_m) {
  if (points.size() < 2) {
    ThrowError("polyline", StrCat(points.size(), " points"), "two or more");
  }
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (!((points[i + 1] - points[i]).norm() > 1e-6)) {
      ThrowError("polyline", StrCat("points ", i, " and ", i + 1, " at the same place"),
                 "points apart");
    }
  }
  std::vector<Vector2d> line = {points.front()};
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Vector2d before = points[i] - points[i - 1];
    const Vector2d after = points[i + 1] - points[i];
    const double reach = 0.5 * std::min(before.norm(), after.norm());
    AppendArc(line, {before.normalized(), after.normalized(), points[i], reach}, radius_m, step_m);
  }
  AppendLeg(line, points.back(), step_m);
  return line;
}

double DistanceToPolyline(const std::vector<Vector2d>& line, const Vector2d& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vector2d leg = line[i + 1] - line[i];
    const double t = std::clamp((point - line[i]).dot(leg) / leg.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (point - line[i] - t * leg).squaredNorm());
  }
  return std::sqrt(nearest);
}

std::vector<Vector2d> TangentsOf(const std::vector<Vector2d>& line) {
  std::vector<Vector2d> tangents;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vector2d& before = line[i > 0 ? i - 1 : 0];
    const Vector2d& after = line[std::min(i + 1, line.size() - 1)];
    tangents.push_back((after - before).normalized());
  }
  return tangents;
}

bool Overlap(const Plot& a, const Plot& b) {
  const Vector2d between = b.middle - a.middle;
  for (const Plot* plot : {&a, &b}) {
    for (const Vector2d& axis : {plot->forward, LeftOf(plot->forward)}) {
      if (std::abs(axis.dot(between)) > Reach(a, axis) + Reach(b, axis)) return false;
    }
  }
  return true;
}

bool StreetMap::IsOnRoad(const Vector2d& point, double margin_m, int own) const {
  for (int i = 0; i < static_cast<int>(roads.size()); ++i) {
    if (i == own) continue;
    if (DistanceToPolyline(roads[i].line, point) < roads[i].half_width_m + margin_m) return true;
  }
  return false;
}

bool StreetMap::IsFree(const Plot& plot, double margin_m) const {
  for (const Road& road : roads) {
    // The centre line has points about 1 m apart, so its closest point may be half a step off.
    const double least = road.half_width_m + margin_m;
    for (const Vector2d& point : road.line) {
      if (DistanceToPlot(plot, point) < std::hypot(least, 0.6)) return false;
    }
  }
  return std::none_of(plots.begin(), plots.end(),
                      [&](const Plot& other) { return Overlap(plot, other); });
}

StreetMap MakeStreetMap(const StreetDescription& street) {
  if (street.roads.empty()) ThrowError("street.roads", "none", "one or more");
  StreetMap map;
  map.pavement_m = street.pavement_m;
  for (const RoadDescription& description : street.roads) {
    Road road;
    road.half_width_m = 0.5 * description.width_m;
    if (description.corner_radius_m < road.half_width_m) {
      ThrowError("street.roads.corner_radius_m", StrCat(description.corner_radius_m),
                 "half the width or more");
    }
    road.line = RoundedPolyline(description.points, description.corner_radius_m);
    road.tangents = TangentsOf(road.line);
    map.roads.push_back(std::move(road));
  }
  return map;
}

}  // namespace cvo::synth
