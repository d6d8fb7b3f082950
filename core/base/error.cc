// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.h"

namespace cvo {

namespace {

// Returns the first position from `at` on at which a UTF-8 character starts.
std::size_t CharacterStart(const std::string& text, std::size_t at) {
  while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80) ++at;
  return at;
}

}  // namespace

std::string Shortened(const std::string& text) {
  if (text.size() <= kMaxMessage) return text;
  constexpr std::size_t kHead = kMaxMessage * 2 / 3;
  constexpr std::size_t kTail = kMaxMessage - kHead - 8;  // leaves room for dots and a character
  return text.substr(0, CharacterStart(text, kHead)) + "..." +
         text.substr(CharacterStart(text, text.size() - kTail));
}

void ThrowError(const std::string& where, const std::string& found, const std::string& expected) {
  throw Error(Shortened(StrCat(where, ": found ", found, ", expected ", expected)));
}

void Require(bool condition, const char* message) {
  if (!condition) throw Error(message);
}

}  // namespace cvo
