// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clustering/depth_mode.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace cvo {
namespace {

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  bool Contains(double value) const { return value >= low && value <= high; }
};

// NaN, which lies in no range, if the depth is not positive and finite.
double LogDepth(double depth_m) {
  return depth_m > 0.0 && std::isfinite(depth_m) ? std::log(depth_m) : std::nan("");
}

Range RangeOf(const std::vector<double>& log_depths) {
  Range range;
  for (const double log_depth : log_depths) {
    if (std::isnan(log_depth)) continue;
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
    if (std::isnan(log_depth)) continue;
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

std::vector<std::vector<int>> DepthModes(const std::vector<double>& depths_m, double angular_size,
                                         const ExtentOptions& options) {
  std::vector<double> log_depths(depths_m.size());
  std::transform(depths_m.begin(), depths_m.end(), log_depths.begin(), LogDepth);
  const double count = CountIn(RangeOf(log_depths), log_depths);
  const double needed =
      std::max(static_cast<double>(options.mode_min_points), options.mode_min_share * count);
  if (count < needed) return {};
  const double width = std::min(std::max(options.mode_width * angular_size, options.mode_min_width),
                                options.mode_max_width);
  std::vector<std::vector<int>> modes;
  const DepthDensity density = MakeDensity(log_depths, width);
  for (std::size_t bin = 1; bin + 1 < density.values.size(); ++bin) {
    const auto mode = ModeAt(density, bin, options.mode_valley);
    if (mode && CountIn(*mode, log_depths) >= needed) {
      modes.push_back(IndicesIn(*mode, log_depths));
    }
  }
  return modes;
}

}  // namespace cvo
