// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "synth/models/surroundings.h"

namespace cvo::synth {

// A road as laid out: its centre line in steps of a metre.
struct Road {
  std::vector<Eigen::Vector2d> line;
  std::vector<Eigen::Vector2d> tangents;
  double half_width_m = 0.0;
};

// A rectangle on the ground, turned.
struct Plot {
  Eigen::Vector2d middle;
  Eigen::Vector2d forward;  // unit
  Eigen::Vector2d half_m;   // along forward and to its left
};

bool Overlap(const Plot& a, const Plot& b);

// The roads, and the plots that are taken.
struct StreetMap {
  std::vector<Road> roads;
  double pavement_m = 0.0;
  std::vector<Plot> plots;

  // Within `margin_m` of the carriageway of a road other than `own` (-1: of any).
  bool IsOnRoad(const Eigen::Vector2d& point, double margin_m, int own) const;
  // At least `margin_m` from all roads, and on no plot that is taken.
  bool IsFree(const Plot& plot, double margin_m) const;
};

StreetMap MakeStreetMap(const StreetDescription& street);

}  // namespace cvo::synth
