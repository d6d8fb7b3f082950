// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "synth/models/surroundings.h"

namespace cvo::synth {

// The geometry of a road. Its centre line is in steps of about a metre.
struct Road {
  std::vector<Eigen::Vector2d> line;
  std::vector<Eigen::Vector2d> tangents;
  double half_width_m = 0.0;
};

// A rotated rectangle on the ground.
struct Plot {
  Eigen::Vector2d middle;
  Eigen::Vector2d forward;  // unit length
  Eigen::Vector2d half_m;   // half sizes along `forward` and to its left
};

bool Overlap(const Plot& a, const Plot& b);

// The roads and the occupied plots.
struct StreetMap {
  std::vector<Road> roads;
  double pavement_m = 0.0;
  std::vector<Plot> plots;

  // Whether the point is within `margin_m` of the carriageway of any road except `own` (-1: any
  // road).
  bool IsOnRoad(const Eigen::Vector2d& point, double margin_m, int own) const;
  // Whether the plot is at least `margin_m` from all roads and overlaps no occupied plot.
  bool IsFree(const Plot& plot, double margin_m) const;
};

StreetMap MakeStreetMap(const StreetDescription& street);

}  // namespace cvo::synth
