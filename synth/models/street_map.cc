// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/models/street_map.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "synth/models/polyline.h"

namespace cvo::synth {
namespace {

using Eigen::Vector2d;

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

void CheckStreet(const StreetDescription& street) {
  if (street.roads.empty()) ThrowError("street.roads", "none", "one or more");
  for (const RoadDescription& road : street.roads) {
    if (!(road.width_m >= 2.0)) {
      ThrowError("street.roads.width_m", StrCat(road.width_m), "2 or more");
    }
    if (!(road.corner_radius_m >= 0.5 * road.width_m)) {
      ThrowError("street.roads.corner_radius_m", StrCat(road.corner_radius_m),
                 "half the width or more");
    }
  }
  if (!(street.pavement_m >= 0.5)) {
    ThrowError("street.pavement_m", StrCat(street.pavement_m), "0.5 or more");
  }
  if (!(street.building_height_m >= 3.5)) {
    ThrowError("street.building_height_m", StrCat(street.building_height_m), "3.5 or more");
  }
  if (!(street.trees_per_100m >= 0.0 && street.trees_per_100m <= 50.0)) {
    ThrowError("street.trees_per_100m", StrCat(street.trees_per_100m), "0 to 50");
  }
}

}  // namespace

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
  CheckStreet(street);
  StreetMap map;
  map.pavement_m = street.pavement_m;
  for (const RoadDescription& description : street.roads) {
    Road road;
    road.half_width_m = 0.5 * description.width_m;
    road.line = RoundedPolyline(description.points, description.corner_radius_m);
    road.tangents = TangentsOf(road.line);
    map.roads.push_back(std::move(road));
  }
  return map;
}

}  // namespace cvo::synth
