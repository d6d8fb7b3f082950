// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace cvo::test {

struct ProcessResult {
  int exit_code = -1;  // 128 + signal where one ended it
  std::string out;
  std::string err;
};

struct ProcessSetup {
  std::vector<std::string> environment = {};  // NAME=VALUE, over the present one
  std::size_t file_size_limit = 0;            // bytes; a larger file cannot be written. 0: none
  std::size_t address_space_limit = 0;        // bytes; 0: none
  std::string interrupt_at = {};              // SIGINT once stderr holds this text; empty: never
  std::string out = {};  // a file for standard output, "closed": none; empty: ProcessResult::out
};

// Runs the program clustervo to its end.
ProcessResult RunProgram(const std::vector<std::string>& arguments, const ProcessSetup& setup = {});

// That the program failed with one line, which has this text, and printed nothing else.
void ExpectError(const ProcessResult& result, const std::string& text, int exit_code = 1);

// How many lines a text has.
std::size_t LineCount(const std::string& text);

}  // namespace cvo::test
