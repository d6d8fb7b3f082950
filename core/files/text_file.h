// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace cvo {

// Reads a whole file, or its first `max_bytes` bytes. Throws Error if it cannot be read, which
// includes folders, pipes and devices.
std::string ReadFileBytes(const std::filesystem::path& path, std::size_t max_bytes = SIZE_MAX);
// Replaces the content of the file. Throws Error if it cannot be written completely.
void WriteFileBytes(const std::filesystem::path& path, std::string_view bytes);

// Formats text from a file for a message: in quotes, at most 60 characters, always on one line.
std::string Quoted(std::string_view text);

// A text file as lines without byte order mark and line ends ("\n" or "\r\n"; the last line may
// have none). Drops blank lines at the end.
class TextFile {
 public:
  explicit TextFile(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }
  std::size_t size() const { return lines_.size(); }
  const std::string& line(std::size_t index) const { return lines_[index]; }
  // "<path>:<line number from 1>"
  std::string Where(std::size_t index) const;
  // Whether the line is the last one and has no line end, as in a partially written file.
  bool Unterminated(std::size_t index) const;

 private:
  std::filesystem::path path_;
  std::vector<std::string> lines_;
  bool ends_with_newline_ = true;
};

// One line of a TextFile, split into columns at separators. The functions throw Error with file,
// line, column, what was found and what was expected if they fail. The file must outlive it.
class TextRow {
 public:
  TextRow(const TextFile& file, std::size_t index, std::string_view separators = " \t");

  std::size_t size() const { return columns_.size(); }
  void ExpectColumns(std::size_t count, const std::string& what) const;
  std::string_view Text(std::size_t column) const { return columns_[column]; }
  double Number(std::size_t column) const;    // finite
  int Integer(std::size_t column) const;      // also "-1.00"
  std::int64_t Id(std::size_t column) const;  // 64-bit integer
  std::int64_t TimeNs(std::size_t column, std::int64_t unit_ns) const;
  [[noreturn]] void Fail(const std::string& found, const std::string& expected) const;

 private:
  [[noreturn]] void FailColumn(std::size_t column, const char* expected) const;

  const TextFile* file_;
  std::size_t index_;
  std::vector<std::string_view> columns_;
};

// Receives a text part by part.
using TextSink = std::function<void(std::string_view part)>;

// The lines of a table of comma-separated values without quotes (core/record/csv_record.h). Throws
// Error with file and line for another first line than `header`, text that is not UTF-8, a line
// with more or fewer cells than the first, and a last line without a line end, as in a partially
// written file.
class CsvFile {
 public:
  CsvFile(std::filesystem::path path, std::string_view header);
  CsvFile(const CsvFile&) = delete;
  CsvFile& operator=(const CsvFile&) = delete;

  std::size_t rows() const { return lines_.size(); }
  std::string_view Line(std::size_t row) const { return lines_[row]; }
  [[noreturn]] void Fail(std::size_t row, const std::string& found,
                         const std::string& expected) const;

 private:
  std::string Where(std::size_t line) const;

  std::filesystem::path path_;
  std::string text_;
  std::vector<std::string_view> lines_;  // without the header
};

}  // namespace cvo
