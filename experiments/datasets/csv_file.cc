// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/csv_file.h"

#include <limits>
#include <optional>

#include "core/base/error.h"
#include "core/files/number.h"

namespace cvo {
namespace {

std::vector<std::string> SplitAtCommas(std::string_view line) {
  std::vector<std::string> cells;
  for (std::size_t comma = line.find(','); comma != std::string_view::npos;
       comma = line.find(',')) {
    cells.emplace_back(line.substr(0, comma));
    line.remove_prefix(comma + 1);
  }
  cells.emplace_back(line);
  return cells;
}

}  // namespace

CsvFile::CsvFile(const std::filesystem::path& path, std::string_view header)
    : file_(path), columns_(SplitAtCommas(header)) {
  if (file_.size() == 0 || file_.line(0) != header) {
    ThrowError(StrCat(path.string(), ":1"), file_.size() == 0 ? "nothing" : Quoted(file_.line(0)),
               StrCat("the header \"", header, "\""));
  }
  for (std::size_t i = 1; i < file_.size(); ++i) {
    cells_.push_back(SplitAtCommas(file_.line(i)));
    if (cells_.back().size() != columns_.size()) {
      Fail(i - 1,
           StrCat(cells_.back().size(), " columns",
                  file_.Unterminated(i) ? " in a last line without a line end" : ""),
           StrCat(columns_.size(), " columns, as in the header"));
    }
  }
}

const std::string& CsvFile::Text(std::size_t row, std::size_t column) const {
  if (Empty(row, column)) FailCell(row, column, "a name");
  return cells_[row][column];
}

double CsvFile::Number(std::size_t row, std::size_t column) const {
  const std::optional<double> value = ParseDouble(cells_[row][column]);
  if (!value) FailCell(row, column, "a finite number");
  return *value;
}

int CsvFile::Integer(std::size_t row, std::size_t column) const {
  const std::optional<std::int64_t> value = ParseInteger(cells_[row][column]);
  if (!value || *value < std::numeric_limits<int>::min() ||
      *value > std::numeric_limits<int>::max()) {
    FailCell(row, column, "a whole number");
  }
  return static_cast<int>(*value);
}

void CsvFile::Fail(std::size_t row, const std::string& found, const std::string& expected) const {
  ThrowError(file_.Where(row + 1), found, expected);
}

void CsvFile::FailCell(std::size_t row, std::size_t column, const char* expected) const {
  Fail(row, StrCat(Quoted(cells_[row][column]), " in column ", columns_[column]), expected);
}

}  // namespace cvo
