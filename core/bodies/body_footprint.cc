// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/bodies/body_footprint.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/bodies/body_direction.h"

namespace cvo {
namespace {

constexpr Eigen::Index kFewPoints = 20;
constexpr int kAngles = 15;  // per right angle, in steps of 6 degrees

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

// Returns the range from `quantile` to one minus it.
Interval OuterRange(Eigen::VectorXd values, double quantile) {
  const Eigen::Index last = values.size() - 1;
  const auto rank = static_cast<Eigen::Index>(std::lround(quantile * static_cast<double>(last)));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  const double low = values[rank];
  std::nth_element(values.begin(), values.begin() + (last - rank), values.end());
  return {low, values[last - rank]};
}

Interval RangeAlong(const Eigen::Vector3d& axis, const Eigen::Matrix3Xd& points, double quantile) {
  return OuterRange((axis.transpose() * points).transpose(), quantile);
}

}  // namespace

Eigen::Matrix3d FootprintAxes(const Eigen::Matrix3Xd& points, const Eigen::Vector3d& forward,
                              const Eigen::Vector3d& down, const BodyBoxOptions& options) {
  if (points.cols() < kFewPoints) return BoxAxes(forward, down);
  const auto length_m = [&](const Eigen::Vector3d& axis) {
    const Interval range = RangeAlong(axis, points, options.quantile);
    return range.high - range.low;
  };
  Eigen::Vector3d best = forward;
  double least_m2 = std::numeric_limits<double>::infinity();
  // From -45 to 45 degrees, so that the best axis is the nearest to `forward` of its four
  // directions.
  for (int i = 0; i < kAngles; ++i) {
    const double angle_rad = std::numbers::pi / 2.0 * ((i + 0.5) / kAngles - 0.5);
    const Eigen::Vector3d axis = Eigen::AngleAxisd(angle_rad, down) * forward;
    const double area_m2 = length_m(axis) * length_m(axis.cross(down));
    if (area_m2 >= least_m2) continue;
    least_m2 = area_m2;
    best = axis;
  }
  return BoxAxes(best, down);
}

LandmarkSides SidesAlong(const Eigen::Matrix3d& axes, const Eigen::Matrix3Xd& points,
                         const BodyBoxOptions& options, const ExtentOptions& extent) {
  LandmarkSides sides;
  for (int k = 0; k < 3; ++k) {
    const Interval range = RangeAlong(axes.col(k), points, options.quantile);
    sides.low[k] = range.low;
    sides.high[k] = range.high;
    sides.size_m[k] = std::max(range.high - range.low, 2.0 * extent.min_half_size_m);
  }
  return sides;
}

Eigen::Vector3d WithPictures(const Eigen::Vector3d& size_m, const ViewedSides& viewed,
                             const BodyBoxOptions& options) {
  Eigen::Vector3d sides_m = size_m;
  if (viewed.height_m > 0.0) sides_m.y() = viewed.height_m;
  if (viewed.square_m > 0.0) {
    for (const int k : {0, 2}) {
      sides_m[k] = std::clamp(sides_m[k], viewed.square_m / options.footprint_ratio,
                              viewed.square_m * options.footprint_ratio);
    }
  }
  return sides_m;
}

Eigen::Vector3d SidesOfBall(const Eigen::Vector3d& size_m, const ViewedSides& viewed) {
  const double viewed_m = std::max(viewed.height_m, viewed.square_m);
  return Eigen::Vector3d::Constant(viewed_m > 0.0 ? viewed_m : size_m.maxCoeff());
}

Eigen::Vector3d CenterBehindNearSides(const LandmarkSides& sides, const BoxShape& shape,
                                      const Eigen::Vector3d& camera_in_world) {
  const Eigen::Vector3d camera = shape.axes.transpose() * camera_in_world;
  Eigen::Vector3d center = 0.5 * (sides.low + sides.high);
  for (int k = 0; k < 3; ++k) {
    const double unseen_m = 0.5 * (shape.size_m[k] - (sides.high[k] - sides.low[k]));
    // From between the planes of the two sides, the camera sees neither better than the other.
    if (camera[k] < sides.low[k]) center[k] += unseen_m;
    if (camera[k] > sides.high[k]) center[k] -= unseen_m;
  }
  return shape.axes * center;
}

}  // namespace cvo
