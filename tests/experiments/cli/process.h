// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace cvo::test {

struct ProcessResult {
  int exit_code = -1;  // 128 + signal if killed by one
  std::string out;
  std::string err;
};

struct ProcessSetup {
  std::vector<std::string> environment = {};  // NAME=VALUE, added to the current environment
  std::size_t file_size_limit = 0;            // bytes; writing beyond it fails. 0: none
  std::size_t address_space_limit = 0;        // bytes; 0: none
  std::string interrupt_at = {};              // SIGINT once stderr holds this text; empty: never
  std::string out = {};  // standard output: a file, "closed", or ProcessResult::out if empty
};

// Runs the program clustervo until it exits.
ProcessResult RunProgram(const std::vector<std::string>& arguments, const ProcessSetup& setup = {});

// Expects that the program failed with exactly one line on standard error, which contains `text`,
// and no standard output.
void ExpectError(const ProcessResult& result, const std::string& text, int exit_code = 1);

// Returns the number of line breaks in a text.
std::size_t LineCount(const std::string& text);

// Waits up to ten seconds for a condition that other processes bring about. Returns whether it
// became true.
inline bool WaitUntil(const std::function<bool()>& condition) {
  for (int i = 0; i < 1000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return condition();
}

}  // namespace cvo::test
