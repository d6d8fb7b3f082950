// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/import/image_names.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/files/text/number.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using Files = std::vector<fs::path>;

constexpr std::string_view kDecimalDigits = "0123456789";

bool StartsWithDigit(std::string_view text) { return text.find_first_of(kDecimalDigits) == 0; }

std::string_view WithoutLeadingZeros(std::string_view digits) {
  return digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 1));
}

// Removes and returns the first part of a text: its leading digits, or else one character. Leading
// zeros of a number are dropped.
std::string_view TakePart(std::string_view& text) {
  const std::size_t digits = std::min(text.find_first_not_of(kDecimalDigits), text.size());
  const std::string_view part = text.substr(0, std::max<std::size_t>(digits, 1));
  text.remove_prefix(part.size());
  return digits == 0 ? part : WithoutLeadingZeros(part);
}

bool IsBefore(const fs::path& a, const fs::path& b) {
  const std::string a_name = a.filename().string();
  const std::string b_name = b.filename().string();
  std::string_view a_rest = a_name;
  std::string_view b_rest = b_name;
  while (!a_rest.empty() && !b_rest.empty()) {
    const std::string_view a_part = TakePart(a_rest);
    const std::string_view b_part = TakePart(b_rest);
    if (a_part == b_part) continue;
    // Numbers are compared by their number of digits first, as they may exceed any integer type.
    const bool numbers = StartsWithDigit(a_part) && StartsWithDigit(b_part);
    if (!numbers || a_part.size() == b_part.size()) return a_part < b_part;
    return a_part.size() < b_part.size();
  }
  if (a_rest.empty() != b_rest.empty()) return a_rest.empty();
  return a_name < b_name;
}

// Files by the numeric value of their names. Empty unless all names are numbers and no two are
// equal: 0.1 and 0.10 are not times.
std::map<double, fs::path> ByValue(const Files& files) {
  std::map<double, fs::path> by_value;
  for (const fs::path& file : files) {
    const std::optional<double> value = ParseDouble(file.stem().string());
    if (!value || !by_value.emplace(*value, file).second) return {};
  }
  return by_value;
}

bool IsNumber(const fs::path& file) {
  return file.stem().string().find_first_not_of("0123456789.") == std::string::npos;
}

// Returns the name if it is a number as a whole, otherwise its last run of digits. Empty if it has
// none.
std::string NumberOf(const fs::path& file) {
  const std::string stem = file.stem().string();
  if (IsNumber(file)) return std::string(WithoutLeadingZeros(stem));
  const std::size_t last = stem.find_last_of(kDecimalDigits);
  if (last == std::string::npos) return "";
  const std::size_t before = stem.find_last_not_of(kDecimalDigits, last);
  return std::string(WithoutLeadingZeros(std::string_view(stem).substr(before + 1, last - before)));
}

// Files by their number (NumberOf). Empty unless every name has a number and all are distinct.
std::map<std::string, fs::path> ByNumber(const Files& files) {
  std::map<std::string, fs::path> by_number;
  for (const fs::path& file : files) {
    const std::string number = NumberOf(file);
    if (number.empty() || !by_number.emplace(number, file).second) return {};
  }
  return by_number;
}

void CheckAllIn(const std::map<std::string, fs::path>& others, const Files& files) {
  for (const fs::path& file : files) {
    const std::string number = NumberOf(file);
    if (others.contains(number)) continue;
    ThrowError(file.string(),
               StrCat("no image ", number, " in ", others.begin()->second.parent_path().string()),
               "images of both cameras with the same numbers");
  }
}

}  // namespace

void SortByNumber(Files& files) {
  const std::map<double, fs::path> by_value = ByValue(files);
  if (by_value.empty()) {
    std::sort(files.begin(), files.end(), IsBefore);
    return;
  }
  files.clear();
  for (const auto& [value, file] : by_value) files.push_back(file);
}

void CheckPartners(const Files& left, const Files& right) {
  if (left.size() < 2 && right.size() < 2) return;  // left_0 and right_1: numbers of the cameras
  const std::map<std::string, fs::path> of_left = ByNumber(left);
  const std::map<std::string, fs::path> of_right = ByNumber(right);
  if (of_left.empty() || of_right.empty()) return;
  const auto is_shared = [&](const auto& numbered) { return of_right.contains(numbered.first); };
  if (std::none_of(of_left.begin(), of_left.end(), is_shared) &&
      std::all_of(left.begin(), left.end(), IsNumber) &&
      std::all_of(right.begin(), right.end(), IsNumber)) {
    return;
  }
  CheckAllIn(of_right, left);
  CheckAllIn(of_left, right);
}

}  // namespace cvo
