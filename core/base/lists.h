// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/error.h"

namespace cvo {

// Concatenates the elements, or the projection `part` (a function or a member) of each, with
// `separator` between them.
template <typename List, typename Part = std::identity>
std::string Joined(const List& list, std::string_view separator, const Part& part = {}) {
  std::string text;
  bool is_first = true;
  for (const auto& element : list) {
    text += StrCat(is_first ? "" : separator, std::invoke(part, element));
    is_first = false;
  }
  return text;
}

template <typename T>
void AddOnce(const T& value, std::vector<T>& values) {
  if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
}

// Returns the first element whose projection `part` (a function or a member) equals `value`, or
// null if there is none.
template <typename List, typename Part, typename Value>
auto* FindBy(List& list, const Part& part, const Value& value) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const auto& element) {
    return std::invoke(part, element) == value;
  });
  return found == list.end() ? nullptr : &*found;
}

// Returns the first element with the same projection `part` as `fresh`. If there is none, appends
// `fresh` and returns it.
template <typename T, typename Part>
T& FindOrAdd(std::vector<T>& list, const Part& part, std::type_identity_t<T> fresh) {
  T* found = FindBy(list, part, std::invoke(part, fresh));
  return found != nullptr ? *found : list.emplace_back(std::move(fresh));
}

// "1 run", "2 runs". `many` is needed only if the plural is not `one` with an "s".
inline std::string Counted(std::size_t count, const std::string& one,
                           const std::string& many = {}) {
  return StrCat(count, " ", count == 1 ? one : many.empty() ? one + "s" : many);
}

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

// Median of at least one value; the mean of the middle two if their number is even.
inline double Median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace cvo
