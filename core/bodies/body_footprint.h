// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/bodies/body_place.h"
#include "core/clustering/point_extent.h"
#include "core/interface/body_box_options.h"

namespace cvo {

// What a body's landmarks tell of its sides, for bodies whose class has no size.

// Level axes (BoxAxes) along which the points (columns, in world) have the smallest footprint, of
// its four directions the one nearest to `forward`; along `forward` where the points are few.
Eigen::Matrix3d FootprintAxes(const Eigen::Matrix3Xd& points, const Eigen::Vector3d& forward,
                              const Eigen::Vector3d& down, const BodyBoxOptions& options);

// Between outer quantiles of the points along the axes.
struct LandmarkSides {
  Eigen::Vector3d low = Eigen::Vector3d::Zero();  // coordinates along the axes
  Eigen::Vector3d high = Eigen::Vector3d::Zero();
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();
};
LandmarkSides SidesAlong(const Eigen::Matrix3d& axes, const Eigen::Matrix3Xd& points,
                         const BodyBoxOptions& options, const ExtentOptions& extent);

// The sides, held against what pictures told: height from them, and a footprint that differs from
// the square that is as wide as they are by at most boxes.footprint_ratio a side.
Eigen::Vector3d WithPictures(const Eigen::Vector3d& size_m, const ViewedSides& viewed,
                             const BodyBoxOptions& options);

// Of a ball: all sides are its diameter, the largest of what pictures, or without them landmarks,
// told.
Eigen::Vector3d SidesOfBall(const Eigen::Vector3d& size_m, const ViewedSides& viewed);

// In world: where a side is longer than its landmarks reach, they are on its half towards the
// camera.
Eigen::Vector3d CenterBehindNearSides(const LandmarkSides& sides, const BoxShape& shape,
                                      const Eigen::Vector3d& camera_in_world);

}  // namespace cvo
