// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace cvo::reports {

// Cells of one line; a trailing line end is not part of the last.
inline std::vector<std::string_view> SplitCells(std::string_view text, char separator) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    cells.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return cells;
}

// A line of a table, its cells by the names in the first line. Each call throws Error naming the
// line, and the column, for what is not as it must be.
class CsvLine {
 public:
  CsvLine(const std::vector<std::string_view>& header, std::string_view line, std::string where)
      : header_(header), cells_(SplitCells(line, ',')), where_(std::move(where)) {
    if (cells_.size() != header_.size()) {
      ThrowError(where_, StrCat(cells_.size(), " cells"), StrCat(header_.size(), " as in line 1"));
    }
  }

  std::string_view Text(std::string_view column) const {
    const auto found = std::find(header_.begin(), header_.end(), column);
    if (found == header_.end()) ThrowError(where_, StrCat("no column ", column), "one");
    return cells_[static_cast<std::size_t>(found - header_.begin())];
  }
  template <typename Number>
  Number As(std::string_view column) const {
    const std::string_view text = Text(column);
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() ||
        !std::isfinite(static_cast<double>(number))) {
      ThrowError(StrCat(where_, ", column ", column), StrCat("\"", text, "\""), "a finite number");
    }
    return number;
  }
  // Of columns named as given, after the prefix.
  template <std::size_t kSize>
  std::array<double, kSize> Numbers(const std::array<const char*, kSize>& columns,
                                    const std::string& prefix = "") const {
    std::array<double, kSize> numbers{};
    for (std::size_t i = 0; i < kSize; ++i) numbers[i] = As<double>(prefix + columns[i]);
    return numbers;
  }

 private:
  const std::vector<std::string_view>& header_;
  std::vector<std::string_view> cells_;
  std::string where_;
};

}  // namespace cvo::reports
