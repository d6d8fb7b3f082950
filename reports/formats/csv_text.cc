// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/formats/csv_text.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "core/files/text/utf8.h"

namespace cvo::reports {
namespace {

bool IsNumber(const std::string& text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  return std::from_chars(text.data(), end, value).ptr == end;
}

// Spreadsheets take a text for a formula if it begins with one of these characters, some of which
// are full-width.
bool LooksLikeFormula(const std::string& text) {
  const std::vector<char32_t> characters = Characters(text);
  return !characters.empty() &&
         std::u32string_view(U"=+-@\t\r\n\uFF1D\uFF0B\uFF0D\uFF20").find(characters[0]) !=
             std::u32string_view::npos;
}

}  // namespace

std::string CsvField(const std::string& text) {
  if (IsNumber(text)) return text;
  std::string field;
  if (LooksLikeFormula(text)) field += '\'';
  field += PrintableLines(text);
  const bool blank_ends = !field.empty() && (field.front() == ' ' || field.back() == ' ');
  if (!blank_ends && field.find_first_of(",;\"\n") == std::string::npos) return field;
  std::string quoted = "\"";
  for (const char c : field) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

std::string CsvRecord(const std::vector<std::string>& fields) {
  std::string record;
  for (std::size_t i = 0; i < fields.size(); ++i) record += (i > 0 ? "," : "") + fields[i];
  return record + "\r\n";
}

}  // namespace cvo::reports
