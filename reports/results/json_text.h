// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cvo::reports {

// Result files are mostly poses that no table reads: these find the parts of a JSON text without
// parsing what is in them. Each throws Error naming `where` and the byte for text that is cut off.

// The members of an object, unparsed: key as written between its quotes, and value.
using JsonMember = std::pair<std::string_view, std::string_view>;
std::vector<JsonMember> JsonMembers(std::string_view object, const std::string& where);

// The elements of an array, unparsed.
std::vector<std::string_view> JsonElements(std::string_view array, const std::string& where);

// The value of a member; empty where there is none.
std::string_view FindMember(const std::vector<JsonMember>& members, std::string_view key);

// A whole file. Throws Error where it cannot be read.
std::string ReadText(const std::filesystem::path& file);

}  // namespace cvo::reports
