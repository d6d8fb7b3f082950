// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/text_file.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <limits>
#include <optional>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "core/files/atomic_file.h"
#include "core/files/text/number.h"
#include "core/files/text/utf8.h"

namespace cvo {
namespace fs = std::filesystem;
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

std::string ReadFileBytes(const fs::path& path, std::size_t max_bytes) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) {
    ThrowError(path.string(), "no such file", "a file that can be read");
  }
  if (!fs::is_regular_file(path, ignored)) {
    ThrowError(path.string(), fs::is_directory(path, ignored) ? "a folder" : "a pipe or a device",
               "a file that can be read");
  }
  const FileDescriptor in(path, O_RDONLY);
  if (in.get() < 0) {
    ThrowError(path.string(), "a file that cannot be opened", "a file that can be read");
  }
  struct stat status {};
  const bool is_open = ::fstat(in.get(), &status) == 0;
  std::string bytes(std::min(max_bytes, static_cast<std::size_t>(status.st_size)), '\0');
  const std::ptrdiff_t read = ReadUpTo(in, bytes.data(), bytes.size(), 0);
  if (!is_open || read != static_cast<std::ptrdiff_t>(bytes.size())) {
    ThrowError(path.string(), "an error while reading", "a file that can be read");
  }
  return bytes;
}

void WriteFileBytes(const fs::path& path, std::string_view bytes) {
  FileDescriptor out(path, O_WRONLY | O_CREAT | O_TRUNC);
  if (out.get() < 0) ThrowErrno(path, "write", errno);
  WriteAll(out, bytes, 0, path);
  if (out.Close() != 0) ThrowErrno(path, "write", errno);
}

std::string Quoted(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::string quoted = "\"";
  for (const char c : text.substr(0, kLongest)) quoted += c >= ' ' && c <= '~' ? c : '?';
  return quoted + (text.size() > kLongest ? "...\"" : "\"");
}

TextFile::TextFile(fs::path path) : path_(std::move(path)) {
  const std::string bytes = ReadFileBytes(path_);
  std::size_t begin = bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  while (begin < bytes.size()) {
    const std::size_t end = bytes.find('\n', begin);
    ends_with_newline_ = end != std::string::npos;
    lines_.push_back(bytes.substr(begin, end - begin));
    if (!lines_.back().empty() && lines_.back().back() == '\r') lines_.back().pop_back();
    begin = ends_with_newline_ ? end + 1 : bytes.size();
  }
  while (!lines_.empty() && lines_.back().find_first_not_of(" \t") == std::string::npos) {
    lines_.pop_back();
    ends_with_newline_ = true;
  }
}

std::string TextFile::Where(std::size_t index) const {
  return StrCat(path_.string(), ":", index + 1);
}

bool TextFile::Unterminated(std::size_t index) const {
  return !ends_with_newline_ && index + 1 == lines_.size();
}

TextRow::TextRow(const TextFile& file, std::size_t index, std::string_view separators)
    : file_(&file), index_(index) {
  const std::string_view line = file.line(index);
  std::size_t begin = line.find_first_not_of(separators);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
    columns_.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(separators, end);
  }
}

void TextRow::ExpectColumns(std::size_t count, const std::string& what) const {
  if (columns_.size() == count) return;
  Fail(StrCat(columns_.size(), " columns",
              file_->Unterminated(index_) ? " in a last line without a line end" : ""),
       StrCat(count, " columns, ", what));
}

double TextRow::Number(std::size_t column) const {
  const auto value = ParseDouble(columns_[column]);
  if (!value) FailColumn(column, "a finite number");
  return *value;
}

std::int64_t TextRow::Id(std::size_t column) const {
  const auto value = ParseInteger(columns_[column]);
  if (!value) FailColumn(column, "a whole number");
  return *value;
}

int TextRow::Integer(std::size_t column) const {
  if (const auto value = ParseInt(columns_[column])) return *value;
  const auto value = ParseDouble(columns_[column]);
  constexpr double kMost = std::numeric_limits<int>::max();
  if (!value || *value != std::trunc(*value) || std::abs(*value) > kMost) {
    FailColumn(column, "a whole number");
  }
  return static_cast<int>(*value);
}

std::int64_t TextRow::TimeNs(std::size_t column, std::int64_t unit_ns) const {
  const auto value = ParseTimeNs(columns_[column], unit_ns);
  if (!value) FailColumn(column, "a time");
  return *value;
}

void TextRow::Fail(const std::string& found, const std::string& expected) const {
  ThrowError(file_->Where(index_), found, expected);
}

void TextRow::FailColumn(std::size_t column, const char* expected) const {
  Fail(StrCat(Quoted(columns_[column]), " in column ", column + 1), expected);
}

CsvFile::CsvFile(std::filesystem::path path, std::string_view header)
    : path_(std::move(path)), text_(ReadFileBytes(path_)) {
  if (text_.empty()) ThrowError(Where(1), "nothing", "a line that names the columns");
  lines_ = Split(text_, '\n');
  if (!lines_.back().empty()) {
    ThrowError(Where(lines_.size()), "a last line without a line end", "whole lines");
  }
  lines_.pop_back();
  for (std::string_view& line : lines_) {
    if (line.ends_with('\r')) line.remove_suffix(1);
  }
  const std::string_view first = lines_.front();
  const auto commas = std::count(first.begin(), first.end(), ',');
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto here = std::count(lines_[i].begin(), lines_[i].end(), ',');
    if (here != commas) {
      ThrowError(Where(i + 1), StrCat(here + 1, " cells"), StrCat(commas + 1, ", as line 1 has"));
    }
    if (!IsUtf8(lines_[i])) ThrowError(Where(i + 1), "bytes that are no characters", "UTF-8");
  }
  if (first != header) ThrowError(Where(1), Quoted(first), StrCat("the header \"", header, "\""));
  lines_.erase(lines_.begin());
}

void CsvFile::Fail(std::size_t row, const std::string& found, const std::string& expected) const {
  ThrowError(Where(row + 2), found, expected);
}

std::string CsvFile::Where(std::size_t line) const { return StrCat(path_.string(), ":", line); }

}  // namespace cvo
