// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cvo {

// A table of comma-separated values without quotes, whose first line names its columns. Every call
// throws Error with file, line and column for what is not as it must be; the first one for a last
// line without a line end, which a file that is half-written has, a line with more or fewer cells
// than the first, and text that is not UTF-8.
class CsvFile {
 public:
  explicit CsvFile(std::filesystem::path path);
  // The first line must be exactly `header`.
  CsvFile(std::filesystem::path path, std::string_view header);

  std::size_t rows() const { return lines_.size(); }
  bool Has(std::string_view name) const;  // a column of this name
  std::size_t Column(std::string_view name) const;
  // The first of columns that stand side by side.
  std::size_t Columns(const std::vector<std::string_view>& names) const;

  std::string_view Text(std::size_t row, std::size_t column) const;
  bool Empty(std::size_t row, std::size_t column) const { return Text(row, column).empty(); }
  std::string Name(std::size_t row, std::size_t column) const;  // not empty
  double Number(std::size_t row, std::size_t column) const;     // finite
  int Integer(std::size_t row, std::size_t column) const;
  std::int64_t Id(std::size_t row, std::size_t column) const;  // of 64 bits
  // Of the columns from `first` on.
  template <std::size_t kSize>
  std::array<double, kSize> Numbers(std::size_t row, std::size_t first) const {
    std::array<double, kSize> numbers;
    for (std::size_t i = 0; i < kSize; ++i) numbers[i] = Number(row, first + i);
    return numbers;
  }
  [[noreturn]] void Fail(std::size_t row, const std::string& found,
                         const std::string& expected) const;

 private:
  std::string Where(std::size_t line) const;
  [[noreturn]] void FailCell(std::size_t row, std::size_t column, const char* expected) const;

  std::filesystem::path path_;
  std::vector<char> text_;  // stays where it is when the table is moved
  std::vector<std::string_view> columns_;
  std::vector<std::string_view> lines_;  // without the first
};

}  // namespace cvo
