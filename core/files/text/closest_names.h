// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cvo {

// The known names that a misspelt one may mean, nearest first, at most three: by edit distance, or
// because the last part of a dotted path is the same. Empty where nothing is near. A name with
// other numbers alone is none: drive_0047 is not meant by drive_0001.
std::vector<std::string> ClosestNames(std::string_view name, const std::vector<std::string>& known);

// " (did you mean a, b?)", or nothing where nothing is near.
std::string DidYouMean(std::string_view name, const std::vector<std::string>& known);

// "one of a, b, c", then what DidYouMean says.
std::string OneOfKnown(std::string_view name, const std::vector<std::string>& known);

}  // namespace cvo
