// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cvo {

// The characters of a UTF-8 text; what is none is U+FFFD.
std::vector<char32_t> Characters(std::string_view text);

// Whether a text is UTF-8 throughout.
bool IsUtf8(std::string_view text);

// Whether it holds ASCII control characters, line ends among them.
bool HasControl(std::string_view text);

void AppendUtf8(char32_t character, std::string& text);

// A text of a file as one line that cannot disturb what it is printed in: line ends and tabs are
// blanks, other control characters and those that turn the direction of writing are U+FFFD.
std::string Printable(std::string_view text);

// The same of a text of several lines, whose line ends ("\n" and "\r\n") it keeps.
std::string PrintableLines(std::string_view text);

// Characters as seen in a terminal, each counted as one.
std::size_t Width(std::string_view text);

}  // namespace cvo
