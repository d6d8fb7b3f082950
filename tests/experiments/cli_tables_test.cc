// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// `experiment table` and `experiment compare` from outside, on results made by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/cli_process.h"
#include "tests/reports/result_files.h"

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

ProcessResult MakeTable(const fs::path& folder) {
  return RunProgram({"experiment", "table", folder.string()});
}

ProcessResult Compare(const SuiteResults& a, const SuiteResults& b) {
  return RunProgram({"experiment", "compare", a.Written().string(), b.Written().string()});
}

void ExpectOneLine(const ProcessResult& run, const std::string& text) {
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr(text));
  EXPECT_EQ(test::LineCount(run.err), 1U);
  EXPECT_THAT(run.out, IsEmpty());
}

TEST(CliTables, AFinishedSuite) {
  SuiteResults suite;
  Json result = Result();
  result["options"]["orb"]["features"] = 1999;
  suite.Add(result);
  const ProcessResult first = MakeTable(suite.Written());
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_THAT(first.err, IsEmpty());
  EXPECT_THAT(first.out, AllOf(HasSubstr("1 of 1 runs"), HasSubstr("0.0625")));
  const std::string bytes = test::ReadFile(suite.folder().path() / "table.json");
  const Json table = Json::parse(bytes);
  EXPECT_EQ(table["rows"][0]["cells"][1]["value"], 0.0625);
  ASSERT_EQ(table["provenance"]["options"].size(), 1U);
  EXPECT_EQ(table["provenance"]["options"][0]["path"], "orb.features");
  EXPECT_TRUE(fs::exists(suite.folder().path() / table["rows"][0]["runs"][0]["result"]));
  EXPECT_THAT(test::ReadFile(suite.folder().path() / "table.md"), HasSubstr("| 0.0625 |"));
  EXPECT_EQ(MakeTable(suite.Written()).out, first.out);
  EXPECT_EQ(test::ReadFile(suite.folder().path() / "table.json"), bytes);
}

TEST(CliTables, AnUnfinishedSuiteHasATableToo) {
  SuiteResults suite;
  suite.Add(Result());
  suite.Plan("b", "static");
  suite.AddFailure("killed by signal 9");
  const ProcessResult run = MakeTable(suite.Written());
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.out, AllOf(HasSubstr("1 of 2 runs, 1 failed"), HasSubstr("killed by signal 9"),
                             HasSubstr("0.0625")));
  EXPECT_TRUE(fs::exists(suite.folder().path() / "table.json"));
}

TEST(CliTables, WhatIsNoSuiteIsSaidInOneLine) {
  SuiteResults suite;
  ExpectOneLine(MakeTable(suite.folder().path()), "plan.json: found no such file");
  ExpectOneLine(MakeTable(suite.Written()), "field jobs: found none");
  suite.folder().Write("plan.json", "{\"schema_version\": 1, \"kind\":");
  ExpectOneLine(MakeTable(suite.folder().path()), "plan.json: found text that");
  EXPECT_FALSE(fs::exists(suite.folder().path() / "table.json"));
}

TEST(CliTables, CompareSaysWhatMoved) {
  SuiteResults before;
  SuiteResults after;
  before.Add(Result());
  Json better = Result();
  better["metrics"][1]["value"] = 0.05;
  after.Add(better);
  const ProcessResult run = Compare(before, after);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("moved, not distinguishable from noise:\n"
                                 "  2011_09_26_drive_0001 static, camera_ate: -0.0125 m (-20 %), "
                                 "no interval, 1 pair\n"));
  EXPECT_THAT(Compare(before, before).out, HasSubstr("\nnothing moved\n"));
  better["metrics"][1]["contract"]["delta"] = "1 frame";
  SuiteResults other;
  other.Add(better);
  ExpectOneLine(Compare(before, other), "metric camera_ate");
}

}  // namespace
}  // namespace cvo
