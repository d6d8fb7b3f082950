// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace cvo {

// Escapes text for use between tags and in quoted attributes of HTML and XML.
std::string HtmlEscaped(std::string_view text);

// Escapes text so that Markdown shows it literally, without emphasis, code, links, mathematics,
// table cells or HTML.
std::string MarkdownEscaped(std::string_view text);

std::string Base64(std::string_view bytes);

}  // namespace cvo
