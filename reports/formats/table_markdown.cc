// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.h"
#include "core/files/text/escape.h"
#include "reports/formats/table_text.h"
#include "reports/formats/table_texts.h"

namespace cvo::reports {
namespace {

// Escapes a standalone line so that it does not become a list, a heading or a rule.
std::string Paragraph(const std::string& text) {
  return (std::string("-+=").find(text[0]) != std::string::npos ? "\\" : "") +
         MarkdownEscaped(text);
}

std::string CellMarkdown(const CellText& cell) {
  if (cell.value.empty()) return "";
  std::string text = cell.Shown();
  if (cell.best) text = "**" + text + "**";
  if (cell.distinguishable) text += "\\*";
  if (!cell.interval.empty()) text += " (" + cell.interval + ")";
  if (!cell.percent.empty()) text += "; " + cell.percent;
  if (!cell.percent_interval.empty()) text += " (" + cell.percent_interval + ")";
  return text;
}

std::string LineMarkdown(const TextLine& line) {
  std::string text;
  const auto add = [&text](const std::string& cell, bool grey) {
    text += grey && !cell.empty() ? "| *" + cell + "* " : "| " + cell + " ";
  };
  for (const std::string& cell : line.texts) add(MarkdownEscaped(cell), line.grey);
  for (const CellText& cell : line.cells) add(CellMarkdown(cell), cell.grey);
  return text + "|\n";
}

std::string HeaderMarkdown(const TableTexts& texts) {
  std::string header;
  std::string rule;
  for (const std::string& name : texts.text_header) {
    header += "| " + MarkdownEscaped(name) + " ";
    rule += "|---";
  }
  for (const ColumnText& column : texts.columns) {
    header += "| " + MarkdownEscaped(column.Heading()) + " ";
    rule += "|---:";
  }
  return header + "|\n" + rule + "|\n";
}

}  // namespace

std::string TableMarkdown(const Table& table) {
  const TableTexts texts = MakeTexts(table);
  std::string text = texts.title.empty() ? "" : "**" + MarkdownEscaped(texts.title) + "**\n\n";
  if (!texts.about.empty()) text += Paragraph(texts.about) + "\n\n";
  for (const TextBlock& block : texts.blocks) {
    if (!block.heading.empty()) text += MarkdownEscaped(block.heading) + ":\n\n";
    text += HeaderMarkdown(texts);
    for (const TextLine& line : block.lines) text += LineMarkdown(line);
    text += "\n";
  }
  if (texts.any_best) text += "- " + BestNote("bold") + "\n";
  for (const std::string& note : texts.footnotes) text += "- " + MarkdownEscaped(note) + "\n";
  for (const std::string& note : texts.definitions) text += "- " + MarkdownEscaped(note) + "\n";
  return text;
}

}  // namespace cvo::reports
