// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/text_file.h"

namespace cvo {

// A table of comma-separated values without quotes, whose first line must be exactly `header`.
// What cannot be read throws Error with file, line, column name, what was found and expected.
class CsvFile {
 public:
  CsvFile(const std::filesystem::path& path, std::string_view header);

  std::size_t rows() const { return cells_.size(); }
  const std::string& Text(std::size_t row, std::size_t column) const;  // not empty
  double Number(std::size_t row, std::size_t column) const;            // finite
  int Integer(std::size_t row, std::size_t column) const;
  bool Empty(std::size_t row, std::size_t column) const { return cells_[row][column].empty(); }
  [[noreturn]] void Fail(std::size_t row, const std::string& found,
                         const std::string& expected) const;

 private:
  [[noreturn]] void FailCell(std::size_t row, std::size_t column, const char* expected) const;

  TextFile file_;
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> cells_;
};

}  // namespace cvo
