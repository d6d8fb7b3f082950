// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace cvo {

// Keys keep the order in which they were written.
using Json = nlohmann::ordered_json;

// Strict: throws Error with line and column for text that is not one JSON value, and for a key
// that an object has twice. `where` names the text in errors.
Json ParseJson(std::string_view text, const std::string& where);
Json ReadJson(const std::filesystem::path& file);

// Numbers as the shortest text that reads back as the same number; rows of a table (objects in an
// array, arrays of numbers) on one line each. Throws Error naming a field that is not finite.
std::string DumpJson(const Json& value);

}  // namespace cvo
