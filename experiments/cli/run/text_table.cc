// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/run/text_table.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <ostream>

#include "core/base/error.h"

namespace cvo {
namespace {

// What a terminal shows of UTF-8: one cell per character, continuation bytes none.
std::size_t Width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) >> 6) != 2; }));
}

}  // namespace

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

std::string ForPeople(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

}  // namespace cvo
