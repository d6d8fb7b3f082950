// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Input that nobody means: pipes, endless brackets, links in a circle, more threads than fit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "core/base/error.h"
#include "tests/experiments/cli/process.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/support/temp_folder.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using test::ProcessResult;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Arguments = std::vector<std::string>;

class CliOddInput : public testing::Test {
 protected:
  CliOddInput() { test::WriteTinySequence(wall(), 3); }

  fs::path wall() const { return folder_.path() / "data" / "wall"; }
  std::string out() const { return (folder_.path() / "out").string(); }
  Arguments RunWall(const Arguments& more = {}) const {
    Arguments all = {"run", wall().string(), "-o", out(), "-q"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  ProcessResult Run(const Arguments& arguments, std::size_t memory_bytes = 0) const {
    return test::RunProgram(
        arguments,
        {.environment = {StrCat("CLUSTERVO_CACHE=", (folder_.path() / "cache").string())},
         .address_space_limit = memory_bytes});
  }
  void ExpectOneLine(const Arguments& arguments, const testing::Matcher<int>& exit_code,
                     const std::string& text) const {
    const ProcessResult result = Run(arguments);
    std::string line;
    for (const std::string& argument : arguments) line += argument.substr(0, 100) + " ";
    EXPECT_THAT(result.exit_code, exit_code) << line << result.err;
    EXPECT_EQ(test::LineCount(result.err), 1U) << line << result.err;
    EXPECT_THAT(result.err, AllOf(HasSubstr(text), Not(HasSubstr("internal")))) << line;
  }

  test::TempFolder folder_;
};

TEST_F(CliOddInput, APipeInsteadOfAFileIsRefused) {
  const fs::path pipe = folder_.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const std::string found = "a pipe or a device";
  ExpectOneLine(RunWall({"--config", pipe}), 1, found);
  ExpectOneLine(RunWall({"--detections", pipe}), 1, found);
  ExpectOneLine(RunWall({"--labels", pipe}), 1, found);
  ExpectOneLine({"eval", "--groundtruth", pipe, "--estimate", pipe}, 1, found);
  ExpectOneLine({"experiment", "table", "--from", pipe}, 1, pipe);
  for (const char* name : {"times.txt", "calib.txt", "poses.txt", "image_0/000000.png",
                           "image_1/000002.png", "objects.csv", "labels.txt", "manifest.json"}) {
    const fs::path file = wall() / name;
    const bool existed = fs::exists(file);
    if (existed) fs::rename(file, folder_.path() / "kept");
    ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
    ExpectOneLine(RunWall(), 1, found);
    fs::remove(file);
    if (existed) fs::rename(folder_.path() / "kept", file);
  }
}

TEST_F(CliOddInput, UnclosedBracketsAreRefused) {
  for (const char* bracket : {"[", "{\"a\":"}) {
    std::string text;
    for (int i = 0; i < 100'000; ++i) text += bracket;
    const std::string file = folder_.Write("deep.json", text);
    ExpectOneLine(RunWall({"--config", file}), 1, "more than 100 values");
    ExpectOneLine({"experiment", "run", file, "-o", out()}, 1, "more than 100 values");
    ExpectOneLine({"synth", "render", file, "-o", out()}, 1, "more than 100 values");
    ExpectOneLine(
        {"synth", "render", "tiny", "-o", out(), "--set", "objects.0=" + text.substr(0, 20'000)}, 1,
        "found");
    ExpectOneLine({"experiment", "table", "--from", file}, 1, file);
    ExpectOneLine({"check", folder_.path(), "--baseline", file}, 1, file);
  }
}

TEST_F(CliOddInput, InvalidPathsGiveOneLine) {
  const std::string circle = folder_.path() / "circle";
  fs::create_symlink(circle, circle);
  const std::string much = (folder_.path() / std::string(300, 'x')).string();
  for (const std::string& path : {circle, circle + "/below", much}) {
    for (const Arguments& reads : {Arguments{"run", path, "-o", out()},
                                   {"info", path},
                                   {"experiment", "run", path, "-o", out()},
                                   {"experiment", "status", path},
                                   {"experiment", "table", path},
                                   {"report", path},
                                   {"overlay", path, "-o", out()},
                                   {"check", path, "--baseline", path},
                                   {"synth", "check", path},
                                   RunWall({"--detections", path}),
                                   RunWall({"--config", path})}) {
      ExpectOneLine(reads, testing::AnyOf(1, 2), "");
    }
    for (const Arguments& writes : {Arguments{"run", wall(), "-o", path, "-q"},
                                    {"experiment", "run", "ci", "-o", path},
                                    {"synth", "preview", "tiny", "-o", path + "/sheet.png"},
                                    {"synth", "render", "tiny", "-o", path, "-q"}}) {
      ExpectOneLine(writes, 2, "");
    }
  }
}

TEST_F(CliOddInput, TooManyThreadsAreRefused) {
  const ProcessResult few = Run(RunWall({"--threads", "2"}), 3'000'000'000);
  if (few.exit_code != 0) GTEST_SKIP() << "this build needs more address space: " << few.err;
  const ProcessResult many = Run(RunWall({"--threads", "1000"}), 3'000'000'000);
  EXPECT_EQ(many.exit_code, 1);
  EXPECT_THAT(many.err, HasSubstr("threads: found 1000, expected at most "));
  EXPECT_EQ(test::LineCount(many.err), 1U) << many.err;
}

}  // namespace
}  // namespace cvo
