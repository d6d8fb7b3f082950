// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/formats/latex_text.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "core/files/text/utf8.h"

namespace cvo::reports {
namespace {

// Characters that are special in LaTeX or look different in its fonts.
constexpr std::array<std::pair<char32_t, const char*>, 30> kSpecials = {{
    {'\\', "\\textbackslash{}"},
    {'{', "\\{"},
    {'}', "\\}"},
    {'$', "{\\ttfamily\\char36}"},
    {'&', "\\&"},
    {'#', "\\#"},
    {'_', "\\_"},
    {'%', "\\%"},
    {'^', "\\textasciicircum{}"},
    {'~', "\\textasciitilde{}"},
    {'<', "\\textless{}"},
    {'>', "\\textgreater{}"},
    {'|', "\\textbar{}"},
    {'"', "{\\ttfamily\\char34}"},
    {'`', "{\\ttfamily\\char96}"},
    {0xA0, "~"},
    {0xA7, "$\\mathsection$"},
    {0xB0, "$^\\circ$"},
    {0xB1, "$\\pm$"},
    {0xB2, "$^2$"},
    {0xB3, "$^3$"},
    {0xB5, "$\\mu$"},
    {0xB7, "$\\cdot$"},
    {0xD7, "$\\times$"},
    {0x2013, "--"},
    {0x2014, "---"},
    {0x2018, "{`}"},
    {0x2019, "{'}"},
    {0x2026, "\\dots{}"},
    {0x2212, "$-$"},
}};

// Western European letters that pdfTeX composes from its original fonts.
bool IsAccentedLetter(char32_t character) {
  return character >= 0xC0 && character <= 0xFF && character != 0xD0 && character != 0xD7 &&
         character != 0xDE && character != 0xF0 && character != 0xF7 && character != 0xFE;
}

std::string CodePoint(char32_t character) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "U+%04X", static_cast<unsigned>(character));
  return text.data();
}

const char* FindSpecial(char32_t character) {
  const auto found = std::find_if(kSpecials.begin(), kSpecials.end(),
                                  [&](const auto& entry) { return entry.first == character; });
  return found == kSpecials.end() ? nullptr : found->second;
}

// Two of these in a row form a ligature.
bool Joins(char32_t character) { return character == '-' || character == ',' || character == '\''; }

// Directly after the end of a table row, LaTeX would take these for its arguments.
bool BelongsToRowEnd(char32_t character) { return character == '[' || character == '*'; }

bool AllowsBreakAfter(char32_t character) {
  return std::u32string_view(U"_/.:-,").find(character) != std::u32string_view::npos;
}

}  // namespace

std::string LatexEscaped(std::string_view text, std::size_t longest_word) {
  std::string escaped;
  std::size_t word = 0;
  char32_t before = 0;
  for (const char32_t character : Characters(text)) {
    if (Joins(character) && character == before) escaped += "{}";
    if (before == 0 && BelongsToRowEnd(character)) escaped += "{}";
    before = character;
    std::size_t letters = 1;
    if (const char* special = FindSpecial(character)) {
      escaped += special;
    } else if (character < 0x80 || IsAccentedLetter(character)) {
      AppendUtf8(character, escaped);
    } else {
      escaped += CodePoint(character);
      letters = CodePoint(character).size();
    }
    word = character == ' ' ? 0 : word + letters;
    if (word >= longest_word || (word > longest_word / 2 && AllowsBreakAfter(character))) {
      escaped += "\\allowbreak{}";
      word = 0;
    }
  }
  return escaped;
}

std::string LatexNumber(std::string_view text) {
  if (text == "-") return "--";
  std::string number;
  for (const char c : text) {
    if (c == '-') {
      number += "$-$";
    } else if (c == '%') {
      number += "\\%";
    } else {
      number += c;
    }
  }
  return number;
}

}  // namespace cvo::reports
