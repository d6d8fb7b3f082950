// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/text/escape.h"

#include <openssl/evp.h>

#include "core/base/error.h"

namespace cvo {
namespace {

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

std::string HtmlEscaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
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
