// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace cvo {

// The elements, or what a function or a member makes of each, with `separator` between them.
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

// "1 run", "2 runs"; `many` where it is not `one` with an "s".
inline std::string Counted(std::size_t count, const std::string& one,
                           const std::string& many = {}) {
  return StrCat(count, " ", count == 1 ? one : many.empty() ? one + "s" : many);
}

}  // namespace cvo
