// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/text/closest_names.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/base/lists.h"

namespace cvo {
namespace {

// Returns the number of insertions, deletions, substitutions and swaps of neighbours between two
// words (Damerau-Levenshtein).
std::size_t EditDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::vector<std::size_t> above(row.size());
  std::vector<std::size_t> before(row.size());
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    before.swap(above);
    above.swap(row);
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substituted = above[j] + (a[i] == b[j] ? 0 : 1);
      row[j + 1] = std::min({substituted, row[j] + 1, above[j + 1] + 1});
      const bool swapped = i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j];
      if (swapped) row[j + 1] = std::min(row[j + 1], before[j - 1] + 1);
    }
  }
  return row.back();
}

std::string_view LastPart(std::string_view path) {
  return path.substr(path.rfind('.') + 1);  // npos + 1 = 0
}

// Returns the text without its digits, or its digits without zeros.
std::string Without(bool digits, std::string_view text) {
  std::string rest(text);
  std::erase_if(rest, [&](char c) { return digits ? c >= '0' && c <= '9' : c < '1' || c > '9'; });
  return rest;
}

// A known name that differs only in its numbers is not what was meant.
bool DiffersInNumbersAlone(std::string_view a, std::string_view b) {
  const std::string in_a = Without(false, a);
  const std::string in_b = Without(false, b);
  return Without(true, a) == Without(true, b) && !in_a.empty() && !in_b.empty() && in_a != in_b;
}

}  // namespace

std::vector<std::string> ClosestNames(std::string_view name,
                                      const std::vector<std::string>& known) {
  constexpr std::size_t kLongest = 200;  // longer text is not a name, and slow to compare
  if (name.size() > kLongest) return {};
  std::vector<std::pair<std::size_t, std::string>> near;
  const std::size_t most = 1 + name.size() / 4;
  for (const std::string& candidate : known) {
    const std::size_t whole = EditDistance(name, candidate);
    const std::size_t last = EditDistance(LastPart(name), LastPart(candidate));
    const std::size_t distance = std::min(whole, last + 1);
    if (distance > most || DiffersInNumbersAlone(name, candidate)) continue;
    near.emplace_back(distance, candidate);
  }
  std::sort(near.begin(), near.end());
  if (near.size() > 3) near.resize(3);
  std::vector<std::string> names;
  for (auto& [distance, candidate] : near) names.push_back(std::move(candidate));
  return names;
}

std::string DidYouMean(std::string_view name, const std::vector<std::string>& known) {
  std::string text;
  for (const std::string& candidate : ClosestNames(name, known)) {
    text += (text.empty() ? " (did you mean " : ", ") + candidate;
  }
  return text.empty() ? text : text + "?)";
}

std::string OneOfKnown(std::string_view name, const std::vector<std::string>& known) {
  return "one of " + Joined(known, ", ") + DidYouMean(name, known);
}

}  // namespace cvo
