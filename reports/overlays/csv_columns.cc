// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/csv_columns.h"

#include <algorithm>

#include "reports/results/json_text.h"

namespace cvo::reports {
namespace {

void SplitCells(std::string_view line, std::vector<std::string_view>& cells) {
  cells.clear();
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    cells.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
}

std::string Line(const std::string& file, std::size_t line) {
  return StrCat(file, ", line ", line);
}

// Where the columns are in the header.
std::vector<std::size_t> FindColumns(const std::vector<std::string_view>& header,
                                     const std::vector<std::string>& columns,
                                     const std::string& file) {
  std::vector<std::size_t> indices;
  for (const std::string& column : columns) {
    const auto found = std::find(header.begin(), header.end(), column);
    if (found == header.end()) ThrowError(file + ", line 1", "no column " + column, "one");
    indices.push_back(static_cast<std::size_t>(found - header.begin()));
  }
  return indices;
}

}  // namespace

void CsvCells::FailNumber(std::size_t column) const {
  ThrowError(StrCat(Line(file_, line_ + 1), ", column ", columns_[column]),
             StrCat("\"", cells_[column], "\""), "a number");
}

void ReadCsvColumns(const std::filesystem::path& file, const std::vector<std::string>& columns,
                    const std::function<void(const CsvCells&)>& take) {
  const std::string name = file.string();
  const std::string text = ReadText(file);
  CsvCells row(columns, name);
  std::vector<std::string_view> cells;
  std::vector<std::size_t> indices;
  std::size_t width = 0;
  for (std::size_t begin = 0; begin < text.size(); ++row.line_) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string::npos) {
      ThrowError(Line(name, row.line_ + 1), "a file that ends within it", "whole lines");
    }
    SplitCells(std::string_view(text).substr(begin, end - begin), cells);
    begin = end + 1;
    if (width == 0) {
      width = cells.size();
      indices = FindColumns(cells, columns, name);
      continue;
    }
    if (cells.size() != width) {
      ThrowError(Line(name, row.line_ + 1), StrCat(cells.size(), " cells"),
                 StrCat(width, ", as line 1 has"));
    }
    for (std::size_t i = 0; i < indices.size(); ++i) row.cells_[i] = cells[indices[i]];
    take(row);
  }
}

}  // namespace cvo::reports
