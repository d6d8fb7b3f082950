// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "core/files/text_file.h"
#include "tests/experiments/cli/process.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/support/temp_folder.h"

namespace cvo::test {

// A folder with a small sequence, a suite on it and a cache, and the program to attack. Each test
// on this fixture covers a series of faults that were once found, and states the required
// behaviour.
class FaultFolder : public testing::Test {
 protected:
  using Arguments = std::vector<std::string>;

  FaultFolder() {
    WriteTinySequence(wall(), 3);
    folder_.Write("suite.json", kSuite);
  }

  std::filesystem::path wall() const { return folder_.path() / "data" / "wall"; }
  std::string At(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string out() const { return At("out"); }

  Arguments RunWall(const Arguments& more = {}) const {
    return Joined({"run", wall().string(), "-o", out(), "-q"}, more);
  }
  Arguments Suite(const std::string& command, const Arguments& more = {}) const {
    return Joined(
        {"experiment", command, At("suite.json"), "-o", out(), "--data", At("data"), "-q"}, more);
  }
  ProcessResult Run(const Arguments& arguments, std::size_t memory_bytes = 0) const {
    return RunProgram(arguments, {.environment = {StrCat("CLUSTERVO_CACHE=", At("cache"))},
                                  .address_space_limit = memory_bytes});
  }
  void ExpectDone(const Arguments& arguments) const {
    const ProcessResult result = Run(arguments);
    EXPECT_EQ(result.exit_code, 0) << arguments[1] << ": " << result.err;
  }
  // Expects one line on standard error, which contains this text and is no internal error.
  void ExpectOneLine(const Arguments& arguments, const testing::Matcher<int>& exit_code,
                     const std::string& text) const {
    const ProcessResult result = Run(arguments);
    std::string line;
    for (const std::string& argument : arguments) line += argument.substr(0, 100) + " ";
    EXPECT_THAT(result.exit_code, exit_code) << line << result.err;
    EXPECT_EQ(LineCount(result.err), 1U) << line << result.err;
    EXPECT_THAT(result.err, testing::AllOf(testing::HasSubstr(text),
                                           testing::Not(testing::HasSubstr("internal"))))
        << line;
  }

  static std::string Replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
  }
  static void Edit(const std::filesystem::path& file, const std::function<void(Json&)>& edit) {
    Json json = ReadJson(file);
    edit(json);
    WriteFileBytes(file, json.dump());
  }
  // result.json of the suite's first job.
  std::filesystem::path FirstResult() const {
    const std::string job = ReadJson(At("out/plan.json"))["jobs"][0]["job"];
    return folder_.path() / "out" / "jobs" / job / "result.json";
  }

  static Arguments Joined(Arguments first, const Arguments& more) {
    first.insert(first.end(), more.begin(), more.end());
    return first;
  }

  TempFolder folder_;

 private:
  static constexpr const char* kSuite = R"({
    "name": "small", "sequences": [{"folder": "wall"}], "variants": ["static"], "seeds": 2,
    "options": {"orb": {"features": 300}}, "grid": {"noise.corner_px": [0.5, 0.7]},
    "table": {"rows": ["noise.corner_px"], "metrics": ["camera_trpe_1_frame", "camera_coverage"]}})";
};

}  // namespace cvo::test
