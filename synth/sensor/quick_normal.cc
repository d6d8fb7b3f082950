// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/sensor/quick_normal.h"

#include <cmath>
#include <numbers>

namespace cvo::synth {
namespace {

// Computes the quantiles outwards from the median by Newton's method, each starting from its
// neighbour.
std::vector<float> MakeQuantiles() {
  constexpr int kHalf = 1 << 15;
  std::vector<double> upper(kHalf);
  double x = 0.0;
  double square_sum = 0.0;
  for (int i = 0; i < kHalf; ++i) {
    const double tail = 0.5 - (i + 0.5) / (2.0 * kHalf);  // probability above the quantile
    for (int step = 0; step < 6; ++step) {
      const double density = std::exp(-0.5 * x * x) / std::sqrt(2.0 * std::numbers::pi);
      x += (0.5 * std::erfc(x / std::numbers::sqrt2) - tail) / density;
    }
    upper[static_cast<std::size_t>(i)] = x;
    square_sum += x * x;
  }
  const double scale = 1.0 / std::sqrt(square_sum / kHalf);
  std::vector<float> quantiles(2 * kHalf);
  for (std::size_t i = 0; i < kHalf; ++i) {
    quantiles[kHalf + i] = static_cast<float>(scale * upper[i]);
    quantiles[kHalf - 1 - i] = -quantiles[kHalf + i];
  }
  return quantiles;
}

}  // namespace

const std::vector<float>& NormalQuantiles() {
  static const std::vector<float> quantiles = MakeQuantiles();
  return quantiles;
}

double NormalCdf(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

}  // namespace cvo::synth
