// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace cvo {

// A text that stays that text between tags and in a quoted attribute, of HTML and of XML.
std::string HtmlEscaped(std::string_view text);

// A text that stays that text in Markdown: no emphasis, code, link, mathematics, cell or HTML.
std::string MarkdownEscaped(std::string_view text);

std::string Base64(std::string_view bytes);

}  // namespace cvo
