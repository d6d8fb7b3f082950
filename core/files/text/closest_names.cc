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
// words (Damerau-Levenshtein), or any number above `most` if there are more than `most`.
std::size_t EditDistance(std::string_view a, std::string_view b, std::size_t most) {
  const std::size_t lengths_differ = std::max(a.size(), b.size()) - std::min(a.size(), b.size());
  if (lengths_differ > most) return lengths_differ;
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
    // All later numbers derive from one of these two rows.
    const std::size_t least = std::min(*std::min_element(row.begin(), row.end()),
                                       *std::min_element(above.begin(), above.end()));
    if (least > most) return least;
  }
  return row.back();
}

std::string_view LastPart(std::string_view path) {
  return path.substr(path.rfind('.') + 1);  // npos + 1 = 0
}

// Returns the text with each number replaced by 0 or, if `numbers`, by itself without leading
// zeros.
std::string Reduced(std::string_view text, bool numbers) {
  constexpr std::string_view kDigits = "0123456789";
  std::string reduced;
  while (!text.empty()) {
    const std::size_t digits = std::min(text.find_first_not_of(kDigits), text.size());
    if (digits > 0) {
      const std::size_t zeros = std::min(text.find_first_not_of('0'), digits - 1);
      reduced += numbers ? text.substr(zeros, digits - zeros) : "0";
    } else {
      reduced += text.front();
    }
    text.remove_prefix(std::max<std::size_t>(digits, 1));
  }
  return reduced;
}

// A known name that differs only in its numbers is not what was meant.
bool DiffersInNumbersAlone(std::string_view a, std::string_view b) {
  return Reduced(a, false) == Reduced(b, false) && Reduced(a, true) != Reduced(b, true);
}

}  // namespace

std::vector<std::string> ClosestNames(std::string_view name,
                                      const std::vector<std::string>& known) {
  constexpr std::size_t kLongest = 200;  // longer text is not a name, and slow to compare
  if (name.size() > kLongest) return {};
  std::vector<std::pair<std::size_t, std::string>> near;
  const std::size_t most = 1 + name.size() / 4;
  for (const std::string& candidate : known) {
    const std::size_t whole = EditDistance(name, candidate, most);
    const std::size_t last = EditDistance(LastPart(name), LastPart(candidate), most);
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
