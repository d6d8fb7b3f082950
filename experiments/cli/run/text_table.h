// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace cvo {

// A table of text, with columns aligned by spaces.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> header) : rows_{std::move(header)} {}

  // Appends a row, which must have as many cells as the header.
  void Add(std::vector<std::string> row);
  // Returns one line per row, the header first.
  std::vector<std::string> Lines() const;
  void Print(std::ostream& out) const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

// A number for display, with four significant digits.
std::string ReadableNumber(double value);

// "1 frame/s", "12.5 frames/s".
std::string FrameRateText(double frames_per_s);

}  // namespace cvo
