// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace cvo {

// Returns at most three known names that a misspelt one may mean, nearest first, by the edit
// distance of the whole name or of the last part of a dotted path. Empty if nothing is near. A name
// that differs only in its numbers does not count: drive_0001 is not suggested for drive_0047.
std::vector<std::string> ClosestNames(std::string_view name, const std::vector<std::string>& known);

// " (did you mean a, b?)", or an empty string if nothing is near.
std::string DidYouMean(std::string_view name, const std::vector<std::string>& known);

// "one of a, b, c", followed by the result of DidYouMean.
std::string OneOfKnown(std::string_view name, const std::vector<std::string>& known);

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
