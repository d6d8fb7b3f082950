// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cvo {

// Decodes a UTF-8 text. Malformed sequences become U+FFFD.
std::vector<char32_t> Characters(std::string_view text);

// Whether the whole text is valid UTF-8.
bool IsUtf8(std::string_view text);

// Whether the text contains ASCII control characters, which include line ends.
bool HasControl(std::string_view text);

// Converts text from a file to one line that is safe to print: line ends and tabs become blanks;
// other control characters and those that change the writing direction become U+FFFD.
std::string Printable(std::string_view text);

// The same for a text of several lines. Keeps its line ends ("\n" and "\r\n").
std::string PrintableLines(std::string_view text);

// Width in a terminal, with each character counted as one column.
std::size_t Width(std::string_view text);

// Escapes text for use between tags and in quoted attributes of HTML and XML.
std::string HtmlEscaped(std::string_view text);

// Escapes text so that Markdown shows it literally, without emphasis, code, links, mathematics,
// table cells or HTML.
std::string MarkdownEscaped(std::string_view text);

std::string Base64(std::string_view bytes);

}  // namespace cvo
