// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/csv_file.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "core/files/text/utf8.h"
#include "core/files/text_file.h"

namespace cvo {
namespace {

std::vector<std::string_view> Split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

}  // namespace

CsvFile::CsvFile(std::filesystem::path path) : path_(std::move(path)) {
  const std::string bytes = ReadFileBytes(path_);
  text_.assign(bytes.begin(), bytes.end());
  const std::string_view text(text_.data(), text_.size());
  if (text.empty()) ThrowError(Where(1), "nothing", "a line that names the columns");
  lines_ = Split(text, '\n');
  if (!lines_.back().empty()) {
    ThrowError(Where(lines_.size()), "a last line without a line end", "whole lines");
  }
  lines_.pop_back();
  for (std::string_view& line : lines_) {
    if (line.ends_with('\r')) line.remove_suffix(1);
  }
  columns_ = Split(lines_.front(), ',');
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto cells =
        1 + static_cast<std::size_t>(std::count(lines_[i].begin(), lines_[i].end(), ','));
    if (cells != columns_.size()) {
      ThrowError(Where(i + 1), StrCat(cells, " cells"), StrCat(columns_.size(), ", as line 1 has"));
    }
    if (!IsUtf8(lines_[i])) ThrowError(Where(i + 1), "bytes that are no characters", "UTF-8");
  }
  lines_.erase(lines_.begin());
}

CsvFile::CsvFile(std::filesystem::path path, std::string_view header) : CsvFile(std::move(path)) {
  const std::string_view found(
      columns_.front().data(),
      static_cast<std::size_t>(columns_.back().data() - columns_.front().data()) +
          columns_.back().size());
  if (found != header) ThrowError(Where(1), Quoted(found), StrCat("the header \"", header, "\""));
}

bool CsvFile::Has(std::string_view name) const {
  return std::find(columns_.begin(), columns_.end(), name) != columns_.end();
}

std::size_t CsvFile::Column(std::string_view name) const {
  const auto found = std::find(columns_.begin(), columns_.end(), name);
  if (found == columns_.end()) ThrowError(Where(1), StrCat("no column ", name), "one");
  return static_cast<std::size_t>(found - columns_.begin());
}

std::size_t CsvFile::Columns(const std::vector<std::string_view>& names) const {
  const std::size_t first = Column(names.front());
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (Column(names[i]) == first + i) continue;
    ThrowError(Where(1), StrCat("column ", names[i], " elsewhere"),
               StrCat("behind ", names[i - 1]));
  }
  return first;
}

std::string_view CsvFile::Text(std::size_t row, std::size_t column) const {
  std::string_view rest = lines_[row];
  for (; column > 0; --column) rest.remove_prefix(rest.find(',') + 1);
  return rest.substr(0, rest.find(','));
}

std::string CsvFile::Name(std::size_t row, std::size_t column) const {
  if (Empty(row, column)) FailCell(row, column, "a name");
  return std::string(Text(row, column));
}

double CsvFile::Number(std::size_t row, std::size_t column) const {
  const std::optional<double> value = ParseDouble(Text(row, column));
  if (!value) FailCell(row, column, "a finite number");
  return *value;
}

std::int64_t CsvFile::Id(std::size_t row, std::size_t column) const {
  const std::optional<std::int64_t> value = ParseInteger(Text(row, column));
  if (!value) FailCell(row, column, "a whole number");
  return *value;
}

int CsvFile::Integer(std::size_t row, std::size_t column) const {
  const std::int64_t value = Id(row, column);
  if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max()) {
    FailCell(row, column, "a whole number");
  }
  return static_cast<int>(value);
}

void CsvFile::Fail(std::size_t row, const std::string& found, const std::string& expected) const {
  ThrowError(Where(row + 2), found, expected);
}

std::string CsvFile::Where(std::size_t line) const { return StrCat(path_.string(), ":", line); }

void CsvFile::FailCell(std::size_t row, std::size_t column, const char* expected) const {
  Fail(row, StrCat(Quoted(Text(row, column)), " in column ", columns_[column]), expected);
}

}  // namespace cvo
