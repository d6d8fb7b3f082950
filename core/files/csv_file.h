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

// A table of comma-separated values without quotes, whose first line names its columns. All
// functions throw Error with file, line and column if the content is invalid. The constructors also
// do so for text that is not UTF-8, a line with more or fewer cells than the first, and a last line
// without a line end, as in a partially written file.
class CsvFile {
 public:
  explicit CsvFile(std::filesystem::path path);
  // The first line must be exactly `header`.
  CsvFile(std::filesystem::path path, std::string_view header);

  std::size_t rows() const { return lines_.size(); }
  bool Has(std::string_view name) const;  // whether there is such a column
  std::size_t Column(std::string_view name) const;
  // Returns the index of the first of these columns, which must be adjacent and in this order.
  std::size_t Columns(const std::vector<std::string_view>& names) const;

  std::string_view Text(std::size_t row, std::size_t column) const;
  bool Empty(std::size_t row, std::size_t column) const { return Text(row, column).empty(); }
  std::string Name(std::size_t row, std::size_t column) const;  // not empty
  double Number(std::size_t row, std::size_t column) const;     // finite
  int Integer(std::size_t row, std::size_t column) const;
  std::int64_t Id(std::size_t row, std::size_t column) const;  // 64-bit integer
  // Returns the numbers in kSize columns, starting with `first`.
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
  std::vector<char> text_;  // a vector, whose bytes stay in place when the table is moved
  std::vector<std::string_view> columns_;
  std::vector<std::string_view> lines_;  // without the header
};

}  // namespace cvo
