// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace cvo::reports {

// The asked-for cells of one line of a table.
class CsvCells {
 public:
  CsvCells(const std::vector<std::string>& columns, const std::string& file)
      : columns_(columns), file_(file), cells_(columns.size()) {}

  std::string_view Text(std::size_t column) const { return cells_[column]; }
  template <typename Value>
  Value Number(std::size_t column) const {
    const std::string_view text = cells_[column];
    Value value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) FailNumber(column);
    return value;
  }

 private:
  friend void ReadCsvColumns(const std::filesystem::path& file,
                             const std::vector<std::string>& columns,
                             const std::function<void(const CsvCells&)>& take);
  [[noreturn]] void FailNumber(std::size_t column) const;

  const std::vector<std::string>& columns_;
  const std::string& file_;
  std::size_t line_ = 0;
  std::vector<std::string_view> cells_;
};

// Gives every line of a file of comma-separated values but the first, which names its columns.
// Throws Error with file and line: a column that is not there, a line with another number of cells,
// a file that ends within a line.
void ReadCsvColumns(const std::filesystem::path& file, const std::vector<std::string>& columns,
                    const std::function<void(const CsvCells&)>& take);

}  // namespace cvo::reports
