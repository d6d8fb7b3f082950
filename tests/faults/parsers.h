// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace cvo::test {

// A reader of files that users, other programs or a damaged disk may have written. It takes any
// bytes: it returns or throws cvo::Error, in little time.
struct Parser {
  std::string name;                // the file's too: some readers go by its ending
  std::vector<std::string> seeds;  // whole files, from which attacks start
  std::function<void(const std::filesystem::path& file)> read;
};

// All of them. The seeds are files of the sources and of golden results, and texts.
std::vector<Parser> AllParsers();

// What readers stumble over: numbers, brackets, blanks, bytes of control.
const std::vector<std::string>& HostilePieces();

// The first number, key or value of a text from this place on, as a whole; empty: there is none.
std::string_view WordFrom(std::string_view text, std::size_t begin);

// Why a file is a finding; empty: it is none.
std::string Finding(const Parser& parser, const std::filesystem::path& file);

}  // namespace cvo::test
