// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace cvo::synth {

// Returns the polyline with corners rounded by arcs of radius `radius_m` (less if the legs are
// short), in steps of about `step_m`. Throws Error for fewer than two points and for coincident
// points.
std::vector<Eigen::Vector2d> RoundedPolyline(const std::vector<Eigen::Vector2d>& points,
                                             double radius_m, double step_m = 1.0);

double DistanceToPolyline(const std::vector<Eigen::Vector2d>& line, const Eigen::Vector2d& point);

// Returns the unit tangent of the line at each of its points.
std::vector<Eigen::Vector2d> TangentsOf(const std::vector<Eigen::Vector2d>& line);

}  // namespace cvo::synth
