// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace cvo::reports {

// Escapes arbitrary text, on one line, for use between tags or in a quoted attribute.
std::string Escaped(std::string_view text);

// Returns <tag>text</tag>, with the text escaped.
std::string Element(const std::string& tag, std::string_view text);

// A block of data, which the script of the page reads by its id.
std::string DataBlock(const std::string& id, const std::string& script_json);

}  // namespace cvo::reports
