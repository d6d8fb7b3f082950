// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/formats/latex_panels.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/files/utf8.h"
#include "reports/formats/column_panels.h"
#include "reports/formats/latex_text.h"

namespace cvo::reports {
namespace {

constexpr double kSmall = 0.95;  // of the size of values
constexpr std::size_t kHeadingCharacters = 12;

// Of a column of numbers in any block: panels of values and differences are split alike.
double NumberWidth_pt(const TableTexts& texts, std::size_t column) {
  double width_pt = 0.0;
  const auto fit = [&width_pt](const std::string& text, double scale = 1.0) {
    width_pt = std::max(width_pt, scale * LatexWidth_pt(text));
  };
  for (const std::string& line : HeadingLines(texts.columns[column])) fit(line);
  for (const TextBlock& block : texts.blocks) {
    for (const TextLine& line : block.lines) {
      const CellText& cell = line.cells[column];
      fit(cell.Shown());
      for (const std::string& text : {cell.interval, cell.percent, cell.percent_interval}) {
        fit(text, kSmall);
      }
    }
  }
  return width_pt + kColumnGap_pt;
}

double TotalWidth_pt(const std::vector<LatexColumn>& columns) {
  double total_pt = 0.0;
  for (const LatexColumn& column : columns) total_pt += column.width_pt + kColumnGap_pt;
  return total_pt;
}

std::size_t PrintedLines(const TextLine& line, const std::vector<LatexColumn>& columns) {
  std::size_t texts = 1;
  for (std::size_t i = 0; i < line.texts.size(); ++i) {
    if (!columns[i].wraps) continue;
    texts = std::max(texts, 1 + static_cast<std::size_t>(LatexWidth_pt(line.texts[i]) /
                                                         (0.7 * columns[i].width_pt)));
  }
  std::size_t lines = 1;
  for (const CellText& cell : line.cells) {
    const std::size_t below = (cell.interval.empty() ? 0 : 1) + (cell.percent.empty() ? 0 : 1) +
                              (cell.percent_interval.empty() ? 0 : 1);
    lines = std::max(lines, 1 + below);
  }
  return std::max(texts, lines);
}

// The line behind the last one that fits on a page with `first`.
std::size_t PageEnd(const TextBlock& block, std::size_t first,
                    const std::vector<LatexColumn>& columns) {
  std::size_t end = first;
  for (std::size_t printed = 0; end < block.lines.size(); ++end) {
    printed += PrintedLines(block.lines[end], columns);
    if (end > first && printed > kPanelLines) break;
  }
  return end;
}

}  // namespace

std::vector<std::string> HeadingLines(const ColumnText& column) {
  std::vector<std::string> lines;
  std::string rest = column.label;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    const std::string word = rest.substr(0, end);
    if (!lines.empty() && Width(lines.back()) + 1 + Width(word) <= kHeadingCharacters) {
      lines.back() += " " + word;
    } else {
      lines.push_back(word);
    }
    rest.erase(0, end + 1);
  }
  if (!column.unit.empty()) lines.push_back(StrCat("[", column.unit, "]"));
  return lines;
}

std::vector<LatexColumn> MeasureTexts(const TableTexts& texts) {
  std::vector<LatexColumn> columns;
  for (std::size_t i = 0; i < texts.text_header.size(); ++i) {
    LatexColumn column{LatexWidth_pt(texts.text_header[i]), false};
    for (const TextBlock& block : texts.blocks) {
      for (const TextLine& line : block.lines) {
        column.width_pt = std::max(column.width_pt, LatexWidth_pt(line.texts[i]));
      }
    }
    columns.push_back(column);
  }
  for (const double limit_pt : {150.0, 110.0, 80.0, 60.0, 45.0, 30.0}) {
    if (TotalWidth_pt(columns) <= 0.5 * kPanelWidth_pt) break;
    for (LatexColumn& column : columns) {
      if (column.width_pt > limit_pt) column = {limit_pt, true};
    }
  }
  return columns;
}

std::vector<LatexPanel> SplitBlock(const TableTexts& texts, const TextBlock& block,
                                   const std::vector<LatexColumn>& columns) {
  std::vector<double> widths_pt;
  for (std::size_t i = 0; i < texts.columns.size(); ++i) {
    widths_pt.push_back(NumberWidth_pt(texts, i));
  }
  const auto parts =
      SplitColumns(texts.columns, widths_pt, kPanelWidth_pt - TotalWidth_pt(columns));
  std::vector<LatexPanel> panels;
  std::size_t first = 0;
  while (first < block.lines.size()) {
    const std::size_t end = PageEnd(block, first, columns);
    for (const auto& part : parts) {
      LatexPanel panel{part, {}};
      for (std::size_t line = first; line < end; ++line) {
        if (part.empty() || HasValue(block.lines[line], part)) panel.lines.push_back(line);
      }
      if (!panel.lines.empty()) panels.push_back(std::move(panel));
    }
    first = end;
  }
  if (panels.empty()) panels.push_back({parts[0], {}});
  return panels;
}

}  // namespace cvo::reports
