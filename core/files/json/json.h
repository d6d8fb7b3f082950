// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace cvo {

// Keys keep the order in which they were written.
using Json = nlohmann::ordered_json;

// Strict: throws Error, one line with line and column, for text that is not one JSON value in
// UTF-8, a number that is not finite, a key that an object has twice or that holds control
// characters, and more than 100 values within each other. `where` names the text in errors.
// Members of the outermost object that are named in `skipped` are checked but not kept.
Json ParseJson(std::string_view text, const std::string& where,
               const std::vector<std::string>& skipped = {});
Json ReadJson(const std::filesystem::path& file, const std::vector<std::string>& skipped = {});

// The values within nested objects as JSON text, by dotted path.
std::map<std::string, std::string> FlatJson(const Json& value);

// Numbers as the shortest text that reads back as the same number; rows of a table (objects in an
// array, arrays of numbers) on one line each. Throws Error naming a field that is not finite.
std::string DumpJson(const Json& value);

}  // namespace cvo
