// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace cvo::synth {

// The polyline with arcs of up to `radius_m` at its corners (less where the legs are short), in
// steps of about `step_m`. Throws Error for fewer than two points or points that coincide.
std::vector<Eigen::Vector2d> RoundedPolyline(const std::vector<Eigen::Vector2d>& points,
                                             double radius_m, double step_m = 1.0);

double DistanceToPolyline(const std::vector<Eigen::Vector2d>& line, const Eigen::Vector2d& point);

// Unit vectors along the line at each of its points.
std::vector<Eigen::Vector2d> TangentsOf(const std::vector<Eigen::Vector2d>& line);

}  // namespace cvo::synth
