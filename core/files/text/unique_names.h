// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace cvo {

// Returns the names, except that each name that occurs several times is replaced by its element of
// `otherwise`, such as a path.
inline std::vector<std::string> UniqueNames(const std::vector<std::string>& names,
                                            const std::vector<std::string>& otherwise) {
  std::vector<std::string> unique = names;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (std::count(names.begin(), names.end(), names[i]) > 1) unique[i] = otherwise.at(i);
  }
  return unique;
}

}  // namespace cvo
