// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clustering/point_extent.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace cvo {
namespace {

// The value below which the fraction `share` of the sorted values lies, linearly interpolated.
double Quantile(const std::vector<double>& sorted, double share) {
  const double position = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  const double part = position - static_cast<double>(below);
  return sorted[below] + part * (sorted[above] - sorted[below]);
}

std::vector<double> Sorted(const Eigen::VectorXd& values) {
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

void CheckNotEmpty(const Eigen::Matrix3Xd& points) {
  if (points.cols() == 0) ThrowError("extent of a body", "no points", "at least one");
}

Eigen::Vector3d MedianPoint(const Eigen::Matrix3Xd& points) {
  Eigen::Vector3d median;
  for (int axis = 0; axis < 3; ++axis) {
    median[axis] = Quantile(Sorted(points.row(axis).transpose()), 0.5);
  }
  return median;
}

// Standard deviation along each axis, estimated from the median absolute deviation as for a normal
// distribution.
Eigen::Vector3d RobustDeviation(const Eigen::Matrix3Xd& offsets) {
  constexpr double kDeviationPerMad = 1.4826;
  return kDeviationPerMad * MedianPoint(offsets.cwiseAbs());
}

// Covariance of the offsets that are inliers along every axis.
Eigen::Matrix3d InlierCovariance(const Eigen::Matrix3Xd& offsets, const ExtentOptions& options) {
  // The minimum half size prevents points of a flat body, whose thickness is noise, from being
  // rejected.
  const Eigen::Array3d reach =
      (options.inlier_mads * RobustDeviation(offsets)).array().max(options.min_half_size_m);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double count = 0.0;
  for (Eigen::Index i = 0; i < offsets.cols(); ++i) {
    const Eigen::Vector3d offset = offsets.col(i);
    if ((offset.array().abs() > reach).any()) continue;
    sum += offset * offset.transpose();
    mean += offset;
    count += 1.0;
  }
  if (count == 0.0) return Eigen::Matrix3d::Zero();
  mean /= count;
  return sum / count - mean * mean.transpose();
}

// Whether each variance exceeds the next by `ratio`. A thickness below a thousandth of the length
// counts as that much.
bool AreDistinct(const Eigen::Vector3d& descending, double ratio) {
  const Eigen::Vector3d variances = descending.cwiseMax(1e-6 * descending[0]);
  return variances[0] > ratio * variances[1] && variances[1] > ratio * variances[2];
}

void FixSigns(Eigen::Matrix3d& axes) {
  for (int axis = 0; axis < 2; ++axis) {
    Eigen::Index largest = 0;
    axes.col(axis).cwiseAbs().maxCoeff(&largest);
    if (axes(largest, axis) < 0.0) axes.col(axis) *= -1.0;
  }
  axes.col(2) = axes.col(0).cross(axes.col(1));
}

}  // namespace

PointExtent ExtentAlong(const Eigen::Matrix3d& axes, const Eigen::Matrix3Xd& points,
                        const ExtentOptions& options) {
  CheckNotEmpty(points);
  const Eigen::Matrix3Xd along_axes = axes.transpose() * points;
  PointExtent extent;
  Eigen::Vector3d center;
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<double> sorted = Sorted(along_axes.row(axis).transpose());
    const double low = Quantile(sorted, options.quantile);
    const double high = Quantile(sorted, 1.0 - options.quantile);
    center[axis] = 0.5 * (high + low);
    extent.half_size_m[axis] = std::max(0.5 * (high - low), options.min_half_size_m);
  }
  extent.center = axes * center;
  return extent;
}

RigidTransform PrincipalAxes(const Eigen::Matrix3Xd& points, const ExtentOptions& options) {
  CheckNotEmpty(points);
  const Eigen::Vector3d median = MedianPoint(points);
  const Eigen::Matrix3Xd offsets = points.colwise() - median;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(InlierCovariance(offsets, options));
  if (!AreDistinct(solver.eigenvalues().reverse(), options.min_axis_ratio)) {
    return RigidTransform(Eigen::Matrix3d(Eigen::Matrix3d::Identity()), median);
  }
  Eigen::Matrix3d axes = solver.eigenvectors().rowwise().reverse();
  FixSigns(axes);
  return RigidTransform(axes, median);
}

}  // namespace cvo
