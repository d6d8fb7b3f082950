// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/support/temp_folder.h"

namespace cvo::test {

using Arguments = std::vector<std::string>;

// `first`, then `more`.
Arguments With(Arguments first, const Arguments& more);

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
ProcessResult RunProgram(const Arguments& arguments, const ProcessSetup& setup = {});

// Expects that the program failed with exactly one line on standard error, which contains `text`,
// and no standard output.
void ExpectError(const ProcessResult& result, const std::string& text, int exit_code = 1);

// A folder for what commands read and write, with a cache and a data folder of its own.
class CommandTest : public testing::Test {
 protected:
  std::string Path(const std::string& name) const { return (folder_.path() / name).string(); }
  ProcessResult Run(const Arguments& arguments, ProcessSetup setup = {}) const {
    setup.environment.push_back("CLUSTERVO_CACHE=" + Path("cache"));
    setup.environment.push_back("CLUSTERVO_DATA=" + Path("data"));
    return RunProgram(arguments, setup);
  }

  TempFolder folder_;
};

// With a sequence in the folder "tiny".
class TinyTest : public CommandTest {
 protected:
  explicit TinyTest(int frames = 3) { WriteTinySequence(tiny(), frames); }

  std::string tiny() const { return Path("tiny"); }
  std::string out() const { return Path("out"); }
};

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
