// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/options.h"
#include "core/geometry/rigid_transform.h"

namespace cvo {

struct ExtentOptions {
  // Points farther from the median along an axis are not used to estimate the axes; the standard
  // deviation is 1.48 median absolute deviations (METHOD.md 6.1).
  static constexpr double kInlierMads = 3.0;
  // Minimum ratio of successive variances for a body to have its own axes (sqrt(2 / n) is a
  // variance's relative error: 0.2 of 50 points).
  static constexpr double kMinAxisRatio = 1.5;
  // Minimum points in the foreground of a new box (the fewest whose 30 and 70 percentiles lie
  // within them).
  static constexpr int kModeMinPoints = 5;
  // Minimum fraction of the points in a box that form its foreground: fewer are outliers or a
  // small object in front (simulated: passes over 2 of 30, finds bodies that have 40 %).
  static constexpr double kModeMinShare = 0.2;
  // Minimum image area covered by the foreground of a new box, as a fraction of the area covered
  // by the most widely spread depth range; less is taken for part of something in front; 0:
  // always the nearest range (chosen from 0, 0.3 and 0.5 on development rooms).
  static constexpr double kModeMinFill = 0.5;
  // Depths are split where their density falls below this fraction of the foreground peak; larger
  // splits bodies, smaller merges them with the background (simulated: cars at 8 to 40 m and
  // furniture before walls, 12 to 60 points).
  static constexpr double kModeValley = 0.2;
  // Width of the kernel that smooths the logarithms of depths: bodies are about as deep as they
  // are wide (simulated, as kModeValley).
  static constexpr double kModeWidth = 0.35;
  // Minimum width of the kernel that smooths depths (two deviations of a depth at 30 m: 0.3 px of
  // 13 px of disparity).
  static constexpr double kModeMinWidth = 0.05;
  // Maximum width of the kernel that smooths depths (boxes that fill the image).
  static constexpr double kModeMaxWidth = 0.3;
  double quantile = 0.3;
  double min_half_size_m = 0.05;
  double part_share = 0.8;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("quantile", self.quantile,
                {"1", 0.0, 0.49,
                 "a body's size is measured between this quantile of its points and one minus it; "
                 "larger rejects more outliers",
                 "paper, section 3.2"});
    visit.Field("min_half_size_m", self.min_half_size_m,
                {"m", 1e-4, 10.0, "minimum half size along an axis", "METHOD.md 6.2: indoors"});
    visit.Field("part_share", self.part_share,
                {"1", 0.0, 2.0,
                 "minimum share of a box inside that of a cluster of the same class, at its depth, "
                 "from which it is taken as a part of that body; more than 1: never",
                 "METHOD.md 6.2"});
  }
};

// Centre, in the frame of the points, and half sides along the axes.
struct PointExtent {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d half_size_m = Eigen::Vector3d::Ones();
};

// Returns the centre (p70 + p30) / 2 and the half sides (p70 - p30) / 2, at least min_half_size_m,
// of the points (columns) along the columns of the rotation `axes` (METHOD.md 6.2). Throws Error if
// there are no points.
PointExtent ExtentAlong(const Eigen::Matrix3d& axes, const Eigen::Matrix3Xd& points,
                        const ExtentOptions& options);

// Returns points_from_axes: the origin is the median of the points, the axes are the principal axes
// of their inliers, longest first (METHOD.md 6.1). The largest component of the first and second
// axis is positive. The rotation is the identity if two variances are similar. Throws Error if
// there are no points.
RigidTransform PrincipalAxes(const Eigen::Matrix3Xd& points, const ExtentOptions& options);

// Finds the dense ranges of depths among the points in a box. Returns the points of each range as
// ascending indices into depths_m, the nearest range first. `angular_size` is the larger side of
// the box over the focal length. Depths are positive.
std::vector<std::vector<int>> DepthModes(const std::vector<double>& depths_m, double angular_size,
                                         const ExtentOptions& options);

}  // namespace cvo
