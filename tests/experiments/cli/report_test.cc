// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// `clustervo report` as a process, on hand-made results.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/record/result_files.h"
#include "tests/experiments/cli/process.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using test::Json;
using test::ProcessResult;
using test::Result;
using test::RunProgram;
using test::SuiteResults;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

std::string Page(const fs::path& folder) { return test::ReadFile(folder / "index.html"); }

TEST(CliReport, WritesOnePageBesideTheResults) {
  SuiteResults suite;
  test::Json result = Result();
  result["options"]["orb"]["features"] = 1999;
  suite.Add(result);
  const ProcessResult run = RunProgram({"report", suite.Written().string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, IsEmpty());
  const fs::path out = suite.folder().path() / "report";
  EXPECT_EQ(run.out, "written: " + (out / "index.html").string() + "\n");
  EXPECT_THAT(Page(out), AllOf(HasSubstr("1 of 1 run is complete; none failed."),
                               HasSubstr("<code>orb.features</code>: 1999 (default "),
                               HasSubstr("no clusters: the static-world baseline")));
  EXPECT_EQ(std::distance(fs::directory_iterator(out), fs::directory_iterator()), 1);
}

TEST(CliReport, SameBytesInAnyFolder) {
  SuiteResults suite;
  suite.Add(Result());
  const fs::path other = suite.folder().path() / "a" / "b";
  ASSERT_EQ(RunProgram({"report", suite.Written().string()}).exit_code, 0);
  ASSERT_EQ(RunProgram({"report", suite.Written().string() + "/", "-o", other.string()}).exit_code,
            0);
  EXPECT_TRUE(Page(suite.folder().path() / "report") == Page(other));
}

TEST(CliReport, WritesNothingIfTheOtherSuiteIsMissing) {
  SuiteResults suite;
  suite.Add(Result());
  const ProcessResult run =
      RunProgram({"report", suite.Written().string(), "--against", "no/such/folder"});
  test::ExpectError(run, "--against no/such/folder: found no plan.json", 2);
  EXPECT_FALSE(fs::exists(suite.folder().path() / "report"));
}

TEST(CliReport, AMissingPartIsReportedAndTheRestIsWritten) {
  SuiteResults suite;  // without a job
  const ProcessResult run = RunProgram({"report", suite.Written().string()});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("missing: suite: plan.json, field jobs: found none"));
  EXPECT_THAT(Page(suite.folder().path() / "report"), HasSubstr("field jobs: found none"));
}

TEST(CliReport, AnInvalidSuiteGivesOneLine) {
  SuiteResults suite;
  const ProcessResult run = RunProgram({"report", suite.folder().path().string()});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("plan.json: found no such file"));
  EXPECT_EQ(test::LineCount(run.err), 1U);
  EXPECT_FALSE(fs::exists(suite.folder().path() / "report"));
}

TEST(CliReport, ShowsRunsSideBySide) {
  const test::TempFolder folder;
  std::vector<std::string> runs;
  for (const char* variant : {"2d", "full"}) {
    Json result = Result();
    result["variant"] = variant;
    result["job"] = std::string("job-") + variant;
    folder.Write(std::string(variant) + "/result.json", result.dump());
    runs.push_back((folder.path() / variant).string());
  }
  const std::string out = (folder.path() / "page").string();
  const ProcessResult run = RunProgram({"report", runs[0], runs[1], "-o", out});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(Page(out), AllOf(HasSubstr("2 of 2 runs are complete"), HasSubstr("Runs on ")));
  test::ExpectError(RunProgram({"report", runs[0], runs[0], "-o", out}), "the same run twice");
  test::ExpectError(RunProgram({"report", runs[0], out, "-o", out}), "found no result.json");
  EXPECT_EQ(RunProgram({"report", runs[0], runs[1]}).exit_code, 2);
}

TEST(CliReport, InvalidFlags) {
  EXPECT_EQ(RunProgram({"report", "x", "--every", "0"}).exit_code, 2);
  EXPECT_EQ(RunProgram({"report", "x", "--every", "2", "--no-images"}).exit_code, 2);
  EXPECT_EQ(RunProgram({"report", "x", "--all-images", "--no-images"}).exit_code, 2);
  EXPECT_EQ(RunProgram({"report"}).exit_code, 2);
}

}  // namespace
}  // namespace cvo
