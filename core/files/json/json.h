// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/text_file.h"

namespace cvo {

// Keys keep the order in which they were inserted.
using Json = nlohmann::ordered_json;

// Parses JSON strictly. Throws Error with a one-line message, which has line and column for syntax
// errors, if the text is not one JSON value in UTF-8, a number is not finite, an object has a key
// twice or a key with control characters, or values are nested more than 100 levels deep. `where`
// names the text in errors. Members of the outermost object that are named in `skipped` are checked
// but not kept.
Json ParseJson(std::string_view text, const std::string& where,
               const std::vector<std::string>& skipped = {});
Json ReadJson(const std::filesystem::path& file, const std::vector<std::string>& skipped = {});

// Returns the values in nested objects as JSON text, by dotted path.
std::map<std::string, std::string> FlatJson(const Json& value);

// Formats JSON with numbers as the shortest text that parses back to the same number, and with each
// table row (an object in an array, an array of numbers) on one line. Throws Error naming a field
// that is not finite.
std::string DumpJson(const Json& value);

}  // namespace cvo
