// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace cvo::test {

// A reader of files that users, other programs or a damaged disk may have written. For any bytes it
// must return or throw cvo::Error within a short time.
struct Parser {
  std::string name;                // also of the file: some readers depend on its extension
  std::vector<std::string> seeds;  // complete files, from which mutations start
  std::function<void(const std::filesystem::path& file)> read;
};

// Returns all parsers. Their seeds are files of the source tree, golden results and literal texts.
std::vector<Parser> AllParsers();

// Returns why reading a file is a finding: another exception, an overlong message, or a long run
// time. Empty if it is none.
std::string Finding(const Parser& parser, const std::filesystem::path& file);

}  // namespace cvo::test
