// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string_view>

#include "core/base/options.h"

namespace cvo {

// Standard deviation of the centre between two edges of a complete box (edges of detections
// jitter by some per cent of the box).
inline constexpr double kEdgeDeviation = 0.05;

// Standard deviation of the centre along the line of sight, and across it where an edge of the
// box may not be the body's; the extent there depends on the body's shape (half of a body as
// deep as it is wide, or less; not swept).
inline constexpr double kUnseenDeviation = 0.3;

// Box edges closer than this to the image border, as a fraction of the box, may be truncated by it:
// two deviations of an edge (detectors end the boxes of cut cars up to 9 % before it).
inline constexpr double kBorder = 0.1;

// Maximum fraction of a box that another box may overlap without being taken to occlude the
// body (boxes of neighbours touch by the jitter of their edges).
inline constexpr double kMaxOverlap = 0.05;

// The side of a body without a class size reaches from this quantile of its landmarks to one
// minus it; larger rejects more outliers and cuts more off (METHOD.md 10.4).
inline constexpr double kSideQuantile = 0.02;

// For a body without a class size: maximum factor between a side of its footprint and the
// square that appears as wide as its detections; extent along the line of sight is poorly
// observed, and landmarks behind the body may be taken for its own (METHOD.md 10.4).
inline constexpr double kFootprintRatio = 1.2;

// Whether bodies of the class are balls.
inline bool IsRound(std::string_view category) { return category == "Ball"; }

// Options of the boxes reported for bodies (METHOD.md 10.4). The estimator itself does not use
// these boxes.
struct BodyBoxOptions {
  double heading_deviations = 1.0;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("heading_deviations", self.heading_deviations,
                {"standard deviations", 0.0, 1e9,
                 "a body that moved by more than this many deviations of one triangulated point "
                 "heads along its motion; 1e9: never, it keeps the heading of its birth, as in the "
                 "paper",
                 "METHOD.md 10.4"});
  }
};

// Length, height and width of the bodies of one of KITTI's classes, m; zero for other classes,
// whose sizes are estimated from their landmarks. Car: mean of its rows in KITTI tracking's
// label_02; the others: means of KITTI's object labels as in Frustum PointNets (Qi et al. 2018).
inline Eigen::Vector3d SizeOfClass(std::string_view category) {
  if (category == "Car") return {3.883, 1.516, 1.627};
  if (category == "Van") return {5.068, 2.205, 1.901};
  if (category == "Truck") return {10.136, 3.252, 2.585};
  if (category == "Tram") return {16.172, 3.531, 2.532};
  if (category == "Pedestrian") return {0.844, 1.763, 0.661};
  if (category == "Person_sitting") return {0.801, 1.275, 0.598};
  if (category == "Cyclist") return {1.763, 1.737, 0.597};
  return Eigen::Vector3d::Zero();
}

}  // namespace cvo
