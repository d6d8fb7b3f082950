// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/text/utf8.h"

#include <openssl/evp.h>

#include <algorithm>
#include <array>

#include "core/base/error.h"

namespace cvo {
namespace {

constexpr char32_t kNoCharacter = 0xFFFD;

// Number of continuation bytes that must follow a first byte; -1 if no character starts with it.
int Continuations(unsigned char first) {
  if (first < 0x80) return 0;
  if (first >= 0xC2 && first < 0xE0) return 1;
  if (first >= 0xE0 && first < 0xF0) return 2;
  if (first >= 0xF0 && first < 0xF5) return 3;
  return -1;
}

// Whether a decoded character is an overlong encoding, a surrogate, or beyond Unicode.
bool IsMalformed(char32_t character, int continuations) {
  if (character >= 0xD800 && character < 0xE000) return true;
  if (continuations == 2) return character < 0x800;
  if (continuations == 3) return character < 0x10000 || character > 0x10FFFF;
  return false;
}

bool TurnsDirection(char32_t character) {
  return (character >= 0x202A && character <= 0x202E) ||
         (character >= 0x2066 && character <= 0x2069) || character == 0x200E || character == 0x200F;
}

bool EndsLine(char32_t character) {
  return character == '\n' || character == '\r' || character == '\t' || character == 0x85 ||
         character == 0x2028 || character == 0x2029;
}

bool IsControl(char32_t character) {
  return character < 0x20 || (character >= 0x7F && character < 0xA0) || character == 0xFEFF;
}

char32_t InLine(char32_t character) {
  if (EndsLine(character)) return ' ';
  return IsControl(character) || TurnsDirection(character) ? kNoCharacter : character;
}

// Appends the first byte of a character and the bytes that continue it.
void AppendUtf8(char32_t character, std::string& text) {
  constexpr std::array<char32_t, 4> kFirst = {0, 0xC0, 0xE0, 0xF0};
  unsigned more = character < 0x80 ? 0 : character < 0x800 ? 1 : character < 0x10000 ? 2 : 3;
  text += static_cast<char>(kFirst[more] | (character >> 6U * more));
  while (more-- > 0) text += static_cast<char>(0x80U | ((character >> 6U * more) & 0x3FU));
}

bool NeedsBackslash(std::string_view text, std::size_t at) {
  constexpr std::string_view kSpecial = "|*_<>`\\~$&#";
  const char c = text[at];
  if (kSpecial.find(c) != std::string_view::npos) return true;
  // GitHub also turns bare URLs into links.
  if (c == ':' && text.substr(at + 1).starts_with("//")) return true;
  if (c == '.' && text.substr(0, at).ends_with("www")) return true;
  const bool behind_bracket = at > 0 && text[at - 1] == ']';
  return behind_bracket && (c == '(' || c == ':' || c == '[');
}

}  // namespace

std::vector<char32_t> Characters(std::string_view text) {
  std::vector<char32_t> characters;
  std::size_t at = 0;
  while (at < text.size()) {
    const auto first = static_cast<unsigned char>(text[at]);
    const int wanted = Continuations(first);
    char32_t character = wanted <= 0 ? first : first & (0x3Fu >> wanted);
    int found = 0;
    while (found < wanted && at + 1 + static_cast<std::size_t>(found) < text.size()) {
      const auto next = static_cast<unsigned char>(text[at + 1 + static_cast<std::size_t>(found)]);
      if ((next & 0xC0) != 0x80) break;
      character = (character << 6) | (next & 0x3Fu);
      ++found;
    }
    const bool whole = wanted >= 0 && found == wanted && !IsMalformed(character, wanted);
    characters.push_back(whole ? character : kNoCharacter);
    at += 1 + static_cast<std::size_t>(found);
  }
  return characters;
}

bool IsUtf8(std::string_view text) {
  const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
  if (std::all_of(text.begin(), text.end(), is_ascii)) return true;
  // U+FFFD itself is a valid character, but only its own three bytes are restored by encoding it.
  std::string again;
  for (const char32_t character : Characters(text)) AppendUtf8(character, again);
  return again == text;
}

bool HasControl(std::string_view text) {
  return std::any_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; });
}

std::string Printable(std::string_view text) {
  std::string line;
  for (const char32_t character : Characters(text)) AppendUtf8(InLine(character), line);
  return line;
}

std::string PrintableLines(std::string_view text) {
  std::string lines;
  const std::vector<char32_t> characters = Characters(text);
  for (std::size_t i = 0; i < characters.size(); ++i) {
    const bool before_end = i + 1 < characters.size() && characters[i + 1] == '\n';
    const bool ends = characters[i] == '\n' || (characters[i] == '\r' && before_end);
    AppendUtf8(ends ? characters[i] : InLine(characters[i]), lines);
  }
  return lines;
}

std::size_t Width(std::string_view text) { return Characters(text).size(); }

std::string HtmlEscaped(std::string_view text) {
  constexpr std::string_view kSpecial = "&<>\"'";
  constexpr std::array kEscapes = {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
  std::string escaped;
  for (const char c : text) {
    const std::size_t special = kSpecial.find(c);
    if (special == std::string_view::npos) {
      escaped += c;
    } else {
      escaped += kEscapes[special];
    }
  }
  return escaped;
}

std::string MarkdownEscaped(std::string_view text) {
  std::string escaped;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (NeedsBackslash(text, i)) escaped += '\\';
    escaped += text[i];
  }
  return escaped;
}

std::string Base64(std::string_view bytes) {
  constexpr std::size_t kMaxBytes = 1'000'000'000;  // EVP_EncodeBlock counts in int
  Require(bytes.size() <= kMaxBytes, "Base64: at most 10^9 bytes");
  std::string text((bytes.size() + 2) / 3 * 4 + 1, '\0');  // EVP_EncodeBlock appends a zero
  const int size = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                                   reinterpret_cast<const unsigned char*>(bytes.data()),
                                   static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(size));
  return text;
}

}  // namespace cvo
