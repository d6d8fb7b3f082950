// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/text_file.h"
#include "core/geometry/rigid_transform.h"

namespace cvo {

// Rows of numbers and names as public data sets have them, known by their columns: separated by
// commas or blanks, each with as many columns as the first. A first line whose first column is not
// a number, lines that begin with #, and blank lines are skipped. Throws Error with file and line.
class DataRows {
 public:
  DataRows(const std::filesystem::path& path, std::size_t least_columns, const std::string& what);
  DataRows(const DataRows&) = delete;  // cells are views of its lines
  DataRows& operator=(const DataRows&) = delete;

  std::size_t size() const { return rows_.size(); }
  std::size_t columns() const { return columns_; }
  std::string_view Text(std::size_t row, std::size_t column) const;
  double Number(std::size_t row, std::size_t column) const;  // finite
  std::int64_t Integer(std::size_t row, std::size_t column) const;
  // Of seconds and of nanoseconds, each a column of integers.
  std::int64_t SecondsAndNs(std::size_t row, std::size_t column) const;
  Eigen::Vector3d Vector(std::size_t row, std::size_t column) const;
  // x y z w, or w x y z; of length 1 to within a hundredth.
  Eigen::Quaterniond Quaternion(std::size_t row, std::size_t column, bool w_first) const;
  RigidTransform Matrix(std::size_t row, std::size_t column) const;  // 12 numbers of [R t]
  [[noreturn]] void Fail(std::size_t row, const std::string& found,
                         const std::string& expected) const;

 private:
  struct Row {
    std::size_t line;
    std::vector<std::string_view> cells;
  };
  [[noreturn]] void FailCell(std::size_t row, std::size_t column, const char* expected) const;

  TextFile file_;
  std::vector<Row> rows_;
  std::size_t columns_ = 0;
};

// Times of rows must increase. Throws Error naming the row if its time is not after `before_ns`,
// which the first row does not have.
void CheckLater(const DataRows& rows, std::size_t row, std::int64_t time_ns,
                std::optional<std::int64_t> before_ns, const std::string& of);

}  // namespace cvo
