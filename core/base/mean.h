// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <vector>

namespace cvo {

// Mean of at least one value.
inline double MeanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// Sum of the squared distances from the mean.
inline double SquaresAroundMean(const std::vector<double>& values) {
  const double mean = MeanOf(values);
  return std::accumulate(values.begin(), values.end(), 0.0, [mean](double sum, double value) {
    return sum + (value - mean) * (value - mean);
  });
}

// Root mean square of the elements, or of the projection `part` (a function or a member) of each.
// Empty if there are no elements.
template <typename T, typename Part = std::identity>
std::optional<double> RootMeanSquare(const std::vector<T>& list, const Part& part = {}) {
  if (list.empty()) return std::nullopt;
  double squares = 0.0;
  for (const T& element : list) squares += std::invoke(part, element) * std::invoke(part, element);
  return std::sqrt(squares / static_cast<double>(list.size()));
}

}  // namespace cvo
