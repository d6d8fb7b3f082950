// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/table_text.h"

#include <algorithm>

#include "reports/tables/table_grid.h"

namespace cvo::reports {
namespace {

constexpr char kDim[] = "\033[2m";
constexpr char kPlain[] = "\033[0m";

// Numbers alone are bracketed: texts of a row that does not compare are faint only.
std::string Bracketed(const GridCell& cell, bool is_number) {
  return cell.grey && is_number ? "(" + cell.text + ")" : cell.text;
}

// Characters as seen: continuation bytes of UTF-8 do not count.
std::size_t Width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

std::vector<std::size_t> ColumnWidths(const Grid& grid) {
  std::vector<std::size_t> widths;
  for (const std::string& name : grid.header) widths.push_back(Width(name));
  for (const GridBlock& block : grid.blocks) {
    for (const auto& row : block.rows) {
      for (std::size_t i = 0; i < row.size(); ++i) {
        widths[i] = std::max(widths[i], Width(Bracketed(row[i], i >= grid.text_columns)));
      }
    }
  }
  return widths;
}

std::string Padded(const std::string& text, std::size_t width, bool right) {
  const std::string blanks(width - Width(text), ' ');
  return right ? blanks + text : text + blanks;
}

std::string WithoutTrailingBlanks(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|' || c == '*' || c == '_' || c == '<') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string HeaderText(const Grid& grid, const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t i = 0; i < grid.header.size(); ++i) {
    line += (i > 0 ? "  " : "") + Padded(grid.header[i], widths[i], i >= grid.text_columns);
  }
  return WithoutTrailingBlanks(line);
}

std::string RowText(const std::vector<GridCell>& row, std::size_t text_columns,
                    const std::vector<std::size_t>& widths, bool dim) {
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const bool is_number = i >= text_columns;
    const std::string cell = Padded(Bracketed(row[i], is_number), widths[i], is_number);
    line += (i > 0 ? "  " : "") + (dim && row[i].grey ? kDim + cell + kPlain : cell);
  }
  return WithoutTrailingBlanks(line);
}

std::string MarkdownRow(const std::vector<GridCell>& row, std::size_t text_columns) {
  std::string text;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::string cell = Escaped(Bracketed(row[i], i >= text_columns));
    text += row[i].grey ? "| *" + cell + "* " : "| " + cell + " ";
  }
  return text + "|\n";
}

}  // namespace

std::string TableText(const Table& table, bool dim) {
  const Grid grid = MakeGrid(table);
  const std::vector<std::size_t> widths = ColumnWidths(grid);
  std::string text = table.title.empty() ? "" : table.title + "\n";
  if (!table.about.empty()) text += table.about + "\n";
  for (const GridBlock& block : grid.blocks) {
    if (!text.empty()) text += "\n";
    if (!block.heading.empty()) text += block.heading + "\n";
    text += HeaderText(grid, widths);
    for (const auto& row : block.rows) text += RowText(row, grid.text_columns, widths, dim);
  }
  if (!grid.footnotes.empty()) text += "\n";
  for (const std::string& note : grid.footnotes) text += note + "\n";
  return text;
}

std::string TableMarkdown(const Table& table) {
  const Grid grid = MakeGrid(table);
  std::string text = table.title.empty() ? "" : "**" + Escaped(table.title) + "**\n\n";
  if (!table.about.empty()) text += Escaped(table.about) + "\n\n";
  std::string header;
  std::string rule;
  for (std::size_t i = 0; i < grid.header.size(); ++i) {
    header += "| " + Escaped(grid.header[i]) + " ";
    rule += i < grid.text_columns ? "|---" : "|---:";
  }
  for (const GridBlock& block : grid.blocks) {
    if (!block.heading.empty()) text += Escaped(block.heading) + ":\n\n";
    text += header + "|\n" + rule + "|\n";
    for (const auto& row : block.rows) text += MarkdownRow(row, grid.text_columns);
    text += "\n";
  }
  for (const std::string& note : grid.footnotes) text += "- " + Escaped(note) + "\n";
  for (const std::string& note : grid.definitions) text += "- " + Escaped(note) + "\n";
  return text;
}

}  // namespace cvo::reports
