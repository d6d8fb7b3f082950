// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/bodies/body_place.h"
#include "core/clustering/point_extent.h"
#include "core/interface/body_box_options.h"

namespace cvo {

// The sides of bodies as estimated from landmarks, for classes without a known size.

// Returns the level axes (BoxAxes) along which the points (columns, in world) have the smallest
// footprint; of its four directions, the one nearest to `forward` is the first axis. With fewer
// than 20 points, that axis is `forward` itself.
Eigen::Matrix3d FootprintAxes(const Eigen::Matrix3Xd& points, const Eigen::Vector3d& forward,
                              const Eigen::Vector3d& down, const BodyBoxOptions& options);

// Range between outer quantiles of the points along the axes.
struct LandmarkSides {
  Eigen::Vector3d low = Eigen::Vector3d::Zero();  // coordinates along the axes
  Eigen::Vector3d high = Eigen::Vector3d::Zero();
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();
};
LandmarkSides SidesAlong(const Eigen::Matrix3d& axes, const Eigen::Matrix3Xd& points,
                         const BodyBoxOptions& options, const ExtentOptions& extent);

// Corrects the sides by those seen in images: the height is that in the images, and each side of
// the footprint is kept within the factor boxes.footprint_ratio of the square that looks as wide.
Eigen::Vector3d WithPictures(const Eigen::Vector3d& size_m, const ViewedSides& viewed,
                             const BodyBoxOptions& options);

// Returns the sides of a ball: all are its diameter, which is the larger of height and width in the
// images or, without these, the largest side of the landmarks.
Eigen::Vector3d SidesOfBall(const Eigen::Vector3d& size_m, const ViewedSides& viewed);

// Returns the centre of the box in world. Where a side is longer than its landmarks reach, the part
// without landmarks is on the side away from the camera.
Eigen::Vector3d CenterBehindNearSides(const LandmarkSides& sides, const BoxShape& shape,
                                      const Eigen::Vector3d& camera_in_world);

}  // namespace cvo
