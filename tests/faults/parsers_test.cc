// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Gives each parser corrupted files, as fuzz_target.cc does for hours.
#include "tests/faults/parsers.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "core/files/text_file.h"
#include "tests/support/temp_folder.h"

namespace cvo::test {
namespace {

// Strings that often break readers: numbers, brackets, white space, control bytes.
const std::vector<std::string>& HostilePieces() {
  static const std::vector<std::string> kPieces = {
      "nan",      "inf",     "-1",         "0",        "1e999",
      "-1e308",   "1e-320",  "2147483648", "0x10",     "99999999999999999999",
      "null",     "true",    "\"\"",       "[[[[[[[[", "-9223372036854775808",
      "]",        "{",       "}",          ",",        ":",
      "\n",       "\r\n",    "\t",         "#",        std::string(1, '\0'),
      "\x1b[31m", "\xff",    "\xc2\x9b",   "../../",   "\xe2\x80\xae",
      "\\u0000",  "\\ud800", ".",          "=",        std::string(300, '9')};
  return kPieces;
}

// Makes some changes to a text: flips a bit, or erases, inserts, replaces or repeats a part.
std::string Spoilt(std::string text, Rng& rng) {
  constexpr std::string_view kEnds = " \t\r\n,:[]{}\"";
  for (std::uint64_t changes = 1 + rng.UniformInt(4); changes > 0; --changes) {
    const std::size_t at = rng.UniformInt(text.size() + 1);
    const std::size_t length = rng.UniformInt(40);
    const std::string& piece = HostilePieces()[rng.UniformInt(HostilePieces().size())];
    switch (rng.UniformInt(6)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << rng.UniformInt(8)));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, piece);
        break;
      case 3: {  // a whole number, key or value
        const std::size_t word = std::min(text.find_first_not_of(kEnds, at), text.size());
        text.replace(word, std::min(text.find_first_of(kEnds, word), text.size()) - word, piece);
        break;
      }
      case 4:
        text.insert(rng.UniformInt(text.size() + 1), text.substr(at, length));
        break;
      default:
        text.resize(at);
    }
  }
  return text;
}

TEST(Parsers, ReadOrRefuseCorruptedFiles) {
  constexpr int kFiles = 200;
  const TempFolder folder;
  for (const Parser& parser : AllParsers()) {
    const auto read = [&](const std::string& text, const std::string& which) {
      const std::string why = Finding(parser, folder.Write(parser.name, text));
      EXPECT_EQ(why, "") << parser.name << ", " << which << ":\n" << text;
    };
    for (const std::string& seed : parser.seeds) read(seed, "a seed");
    Rng rng(1, parser.name);
    for (int i = 0; i < kFiles; ++i) {
      read(Spoilt(parser.seeds[rng.UniformInt(parser.seeds.size())], rng), StrCat("file ", i));
    }
  }
}

}  // namespace
}  // namespace cvo::test
