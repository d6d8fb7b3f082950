// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/run/text_table.h"

#include <algorithm>
#include <ostream>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "core/files/text/utf8.h"

namespace cvo {

void TextTable::Add(std::vector<std::string> row) {
  Require(row.size() == rows_.front().size(), "TextTable::Add: one cell per column");
  rows_.push_back(std::move(row));
}

std::vector<std::string> TextTable::Lines() const {
  std::vector<std::size_t> widths(rows_.front().size(), 0);
  for (const std::vector<std::string>& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], Width(row[i]));
  }
  std::vector<std::string> lines;
  for (const std::vector<std::string>& row : rows_) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += row[i];
      if (i + 1 < row.size()) line.append(widths[i] - Width(row[i]) + 2, ' ');
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

void TextTable::Print(std::ostream& out) const {
  for (const std::string& line : Lines()) out << line << '\n';
}

std::string ReadableNumber(double value) { return FormatGeneral(value, 4); }

std::string FrameRateText(double frames_per_s) {
  const std::string number = ReadableNumber(frames_per_s);
  return number + (number == "1" ? " frame/s" : " frames/s");
}

}  // namespace cvo
