// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/geometry/rigid_transform.h"

namespace cvo {

// Minimum half size of a body along an axis, m: landmarks on a flat side have no thickness
// (METHOD.md 6.2).
inline constexpr double kMinHalfSize_m = 0.05;
// Minimum points in the foreground of a new box (the fewest whose 30 and 70 percentiles lie within
// them).
inline constexpr int kModeMinPoints = 5;

// Centre, in the frame of the points, and half sides along the axes.
struct PointExtent {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d half_size_m = Eigen::Vector3d::Ones();
};

// Returns the centre (p70 + p30) / 2 and the half sides (p70 - p30) / 2, at least kMinHalfSize_m,
// of the points (columns) along the columns of the rotation `axes` (METHOD.md 6.2). Throws Error if
// there are no points.
PointExtent ExtentAlong(const Eigen::Matrix3d& axes, const Eigen::Matrix3Xd& points);

// Returns the median of each coordinate of at least one point.
Eigen::Vector3d MedianPoint(const std::vector<Eigen::Vector3d>& points);

// Returns points_from_axes: the origin is the median of the points, the axes are the principal axes
// of their inliers, longest first (METHOD.md 6.1). The largest component of the first and second
// axis is positive. The rotation is the identity if two variances are similar. Throws Error if
// there are no points.
RigidTransform PrincipalAxes(const Eigen::Matrix3Xd& points);

// Finds the dense ranges of depths among the points in a box. Returns the points of each range as
// ascending indices into depths_m, the nearest range first. `angular_size` is the larger side of
// the box over the focal length. Depths are positive.
std::vector<std::vector<int>> DepthModes(const std::vector<double>& depths_m, double angular_size);

}  // namespace cvo
