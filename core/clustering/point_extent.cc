// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clustering/point_extent.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/base/lists.h"

namespace cvo {

namespace {

// A body's size is measured between this quantile of its points and one minus it (paper, section
// 3.2).
constexpr double kQuantile = 0.3;
// Points farther from the median along an axis are not used to estimate the axes; the standard
// deviation is 1.48 median absolute deviations (METHOD.md 6.1).
constexpr double kInlierMads = 3.0;
// Minimum ratio of successive variances for a body to have its own axes (sqrt(2 / n) is a
// variance's relative error: 0.2 of 50 points).
constexpr double kMinAxisRatio = 1.5;
// Minimum fraction of the points in a box that form its foreground: fewer are outliers or a small
// object in front (simulated: passes over 2 of 30, finds bodies that have 40 %).
constexpr double kModeMinShare = 0.2;
// Depths are split where their density falls below this fraction of the foreground peak; larger
// splits bodies, smaller merges them with the background (simulated: cars at 8 to 40 m and
// furniture before walls, 12 to 60 points).
constexpr double kModeValley = 0.2;
// Width of the kernel that smooths the logarithms of depths: bodies are about as deep as they are
// wide (simulated, as kModeValley).
constexpr double kModeWidth = 0.35;
// Minimum width of the kernel that smooths depths (two deviations of a depth at 30 m: 0.3 px of
// 13 px of disparity).
constexpr double kModeMinWidth = 0.05;
// Maximum width of the kernel that smooths depths (boxes that fill the image).
constexpr double kModeMaxWidth = 0.3;

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  bool Contains(double value) const { return value >= low && value <= high; }
};

Range RangeOf(const std::vector<double>& log_depths) {
  Range range;
  for (const double log_depth : log_depths) {
    range.low = std::min(range.low, log_depth);
    range.high = std::max(range.high, log_depth);
  }
  return range;
}

double CountIn(const Range& range, const std::vector<double>& log_depths) {
  return static_cast<double>(
      std::count_if(log_depths.begin(), log_depths.end(),
                    [&](double log_depth) { return range.Contains(log_depth); }));
}

// Density of the logarithms of depths on a grid; zero at both ends.
struct DepthDensity {
  double first = 0.0;  // log depth of values[0]
  double step = 0.0;
  std::vector<double> values;

  double At(std::size_t bin) const { return first + step * static_cast<double>(bin); }
};

// Sums a triangular kernel of height 1 that extends `width` to both sides of each log depth.
DepthDensity MakeDensity(const std::vector<double>& log_depths, double width) {
  constexpr double kBinsPerWidth = 6.0;
  const Range range = RangeOf(log_depths);
  DepthDensity density;
  density.step = width / kBinsPerWidth;
  density.first = range.low - width - density.step;
  const double bins = (range.high + width - density.first) / density.step;
  density.values.assign(static_cast<std::size_t>(bins) + 2, 0.0);
  for (const double log_depth : log_depths) {
    auto bin = static_cast<std::size_t>((log_depth - width - density.first) / density.step);
    for (; density.At(bin) < log_depth + width && bin < density.values.size(); ++bin) {
      density.values[bin] += std::max(0.0, 1.0 - std::abs(density.At(bin) - log_depth) / width);
    }
  }
  return density;
}

// Returns the first bin beside the peak, upwards or downwards, where the density is below `floor`.
// Empty if the density first rises above the peak, which then is the shoulder of a larger one.
std::optional<std::size_t> ValleyBeside(const std::vector<double>& values, std::size_t peak,
                                        bool up, double floor) {
  const std::size_t last = up ? values.size() - 1 : 0;
  std::size_t bin = peak;
  while (bin != last && values[bin] >= floor) {
    bin = up ? bin + 1 : bin - 1;
    if (values[bin] > values[peak]) return std::nullopt;
  }
  return bin;
}

// Returns the range of the mode that peaks at this bin; empty if the bin is no peak.
std::optional<Range> ModeAt(const DepthDensity& density, std::size_t bin, double valley) {
  const std::vector<double>& values = density.values;
  if (values[bin] <= 0.0 || values[bin] < values[bin - 1] || values[bin] < values[bin + 1]) {
    return std::nullopt;
  }
  const auto near = ValleyBeside(values, bin, false, valley * values[bin]);
  const auto far = ValleyBeside(values, bin, true, valley * values[bin]);
  if (!near || !far) return std::nullopt;
  return Range{density.At(*near), density.At(*far)};
}

std::vector<int> IndicesIn(const Range& range, const std::vector<double>& log_depths) {
  std::vector<int> indices;
  for (std::size_t i = 0; i < log_depths.size(); ++i) {
    if (range.Contains(log_depths[i])) indices.push_back(static_cast<int>(i));
  }
  return indices;
}

}  // namespace

std::vector<std::vector<int>> DepthModes(const std::vector<double>& depths_m, double angular_size) {
  std::vector<double> log_depths;
  for (const double depth_m : depths_m) log_depths.push_back(std::log(depth_m));
  const double count = static_cast<double>(depths_m.size());
  const double needed = std::max(static_cast<double>(kModeMinPoints), kModeMinShare * count);
  if (count < needed) return {};
  const double width = std::min(std::max(kModeWidth * angular_size, kModeMinWidth), kModeMaxWidth);
  std::vector<std::vector<int>> modes;
  const DepthDensity density = MakeDensity(log_depths, width);
  for (std::size_t bin = 1; bin + 1 < density.values.size(); ++bin) {
    const auto mode = ModeAt(density, bin, kModeValley);
    if (mode && CountIn(*mode, log_depths) >= needed) {
      modes.push_back(IndicesIn(*mode, log_depths));
    }
  }
  return modes;
}

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
Eigen::Matrix3d InlierCovariance(const Eigen::Matrix3Xd& offsets) {
  // The minimum half size prevents points of a flat body, whose thickness is noise, from being
  // rejected.
  const Eigen::Array3d reach = (kInlierMads * RobustDeviation(offsets)).array().max(kMinHalfSize_m);
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

Eigen::Vector3d MedianPoint(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d median;
  for (int k = 0; k < 3; ++k) {
    std::vector<double> values;
    for (const Eigen::Vector3d& p : points) values.push_back(p[k]);
    median[k] = Median(std::move(values));
  }
  return median;
}

PointExtent ExtentAlong(const Eigen::Matrix3d& axes, const Eigen::Matrix3Xd& points) {
  CheckNotEmpty(points);
  const Eigen::Matrix3Xd along_axes = axes.transpose() * points;
  PointExtent extent;
  Eigen::Vector3d center;
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<double> sorted = Sorted(along_axes.row(axis).transpose());
    const double low = Quantile(sorted, kQuantile);
    const double high = Quantile(sorted, 1.0 - kQuantile);
    center[axis] = 0.5 * (high + low);
    extent.half_size_m[axis] = std::max(0.5 * (high - low), kMinHalfSize_m);
  }
  extent.center = axes * center;
  return extent;
}

RigidTransform PrincipalAxes(const Eigen::Matrix3Xd& points) {
  CheckNotEmpty(points);
  const Eigen::Vector3d median = MedianPoint(points);
  const Eigen::Matrix3Xd offsets = points.colwise() - median;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(InlierCovariance(offsets));
  if (!AreDistinct(solver.eigenvalues().reverse(), kMinAxisRatio)) {
    return RigidTransform(Eigen::Matrix3d(Eigen::Matrix3d::Identity()), median);
  }
  Eigen::Matrix3d axes = solver.eigenvectors().rowwise().reverse();
  FixSigns(axes);
  return RigidTransform(axes, median);
}

}  // namespace cvo
