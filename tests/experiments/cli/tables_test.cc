// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// `clustervo experiment table` and `experiment compare` as processes, on hand-made results.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/record/run_summary.h"
#include "tests/experiments/cli/process.h"
#include "tests/reports/results/result_files.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using test::Arguments;
using test::ExpectError;
using test::Json;
using test::ProcessResult;
using test::Result;
using test::RunProgram;
using test::SuiteResults;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

ProcessResult MakeTable(const fs::path& folder) {
  return RunProgram({"experiment", "table", folder.string()});
}

ProcessResult Compare(const SuiteResults& a, const SuiteResults& b) {
  return RunProgram({"experiment", "compare", a.Written().string(), b.Written().string()});
}

TEST(CliTables, TabulatesAFinishedSuite) {
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

TEST(CliTables, ComparesWithAnotherReferenceRow) {
  SuiteResults suite;
  suite.Add(Result());
  suite.Add(Result(), "2d");
  const std::string folder = suite.Written().string();
  const ProcessResult table = RunProgram({"experiment", "table", folder, "--reference", "2d"});
  EXPECT_EQ(table.exit_code, 0) << table.err;
  EXPECT_EQ(table.out.find("difference from"), std::string::npos);
  EXPECT_THAT(RunProgram({"experiment", "table", folder, "--reference", "2d", "--all"}).out,
              HasSubstr("difference from 2d"));
  EXPECT_FALSE(fs::exists(fs::path(folder) / "table.json"));
  ExpectError(RunProgram({"experiment", "table", folder, "--reference", "3d"}),
              "reference \"3d\": found no such row");
}

TEST(CliTables, AnUnfinishedSuiteHasATable) {
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

TEST(CliTables, AnInvalidSuiteGivesOneLine) {
  SuiteResults suite;
  ExpectError(MakeTable(suite.folder().path()), "plan.json: found no such file");
  ExpectError(MakeTable(suite.Written()), "field jobs: found none");
  suite.folder().Write("plan.json", "{\"schema_version\": 1, \"kind\":");
  ExpectError(MakeTable(suite.folder().path()), "plan.json: found text that");
  EXPECT_FALSE(fs::exists(suite.folder().path() / "table.json"));
}

TEST(CliTables, CompareReportsChanges) {
  SuiteResults before;
  SuiteResults after;
  before.Add(Result());
  Json better = Result();
  better["metrics"][1]["value"] = 0.05;
  after.Add(better);
  const ProcessResult run = Compare(before, after);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(testing::ContainsRegex("-0.0125 +-20.0%\n"),
                             HasSubstr("\n1 of 2 values changed, 0 distinguishable from noise")));
  EXPECT_THAT(Compare(before, before).out, HasSubstr("\n0 of 2 values changed, 0 "));
  better["metrics"][1]["contract"]["delta"] = "1 frame";
  SuiteResults other;
  other.Add(better);
  ExpectError(Compare(before, other), "metric camera_ate");
}

// Runs `experiment table` with these flags on the written suite.
ProcessResult Print(const SuiteResults& suite, Arguments flags) {
  flags.insert(flags.begin(), {"experiment", "table", suite.Written().string()});
  return RunProgram(flags);
}

TEST(CliTables, EveryFormatIsPrinted) {
  SuiteResults suite;
  suite.Add(Result());
  EXPECT_THAT(Print(suite, {"--format", "markdown"}).out,
              AllOf(StartsWith("what it is\n\n| sequence | variant |"), Not(HasSubstr("frames")),
                    HasSubstr("\n1 of 1 runs, 1 scene a row; "), HasSubstr("; build abc\n")));
  EXPECT_THAT(Print(suite, {"--format", "markdown", "--all"}).out, StartsWith("**small**"));
  EXPECT_THAT(Print(suite, {"--format", "csv"}).out,
              AllOf(StartsWith("sequence,variant,frames,"), HasSubstr(",0.0625,")));
  EXPECT_THAT(Print(suite, {"--format", "latex"}).out,
              AllOf(StartsWith("% small\n"), HasSubstr("\\toprule")));
  EXPECT_FALSE(fs::exists(suite.folder().path() / "table.json")) << "asked for something else";
}

TEST(CliTables, ASuiteThatMeasuresTimesHasThemFirst) {
  SuiteResults suite;
  suite.Add(Result());
  reports::TimingData timing;
  timing.cpu_s = 5.4;  // of 108 frames
  suite.folder().Write("jobs/job0/timing.json", FileText(timing));
  EXPECT_THAT(Print(suite, {"--format", "markdown"}).out, Not(HasSubstr("CPU per frame")));
  const fs::path file = suite.folder().path() / "plan.json";
  Json plan = Json::parse(test::ReadFile(file));
  plan["definition"]["timed_threads"] = 1;
  suite.folder().Write("plan.json", plan.dump());
  EXPECT_THAT(
      RunProgram({"experiment", "table", file.parent_path().string(), "--format", "markdown"}).out,
      AllOf(HasSubstr("| CPU per frame [ms] | camera ATE [m] |"),
            HasSubstr(" | 50.00 | 0.0625 |")));
}

TEST(CliTables, WritesATableToAFile) {
  SuiteResults suite;
  suite.Add(Result());
  const fs::path file = suite.folder().path() / "new" / "table.tex";
  const ProcessResult run = Print(suite, {"--format", "latex", "-o", file.string()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, "written: " + file.string() + "\n");
  EXPECT_EQ(test::ReadFile(file), Print(suite, {"--format", "latex"}).out);
}

TEST(CliTables, ConflictingFlagsAreAnError) {
  SuiteResults suite;
  suite.Add(Result());
  const std::string folder = suite.Written().string();
  const Arguments compare = {"experiment", "compare", folder, folder};
  const std::vector<std::pair<Arguments, std::string>> cases = {
      {{"experiment", "table", folder, "--format", "pdf"}, "pdf"},
      {{"experiment", "table"}, "DIR is required"},
      {{"experiment", "table", folder, "--times", "--format", "csv"},
       "--format: does not apply with --times"},
      {test::With(compare, {folder}), "DIR: found 3 suites, expected 2"}};
  for (const auto& [arguments, message] : cases) ExpectError(RunProgram(arguments), message, 2);
}

std::string WriteRun(const test::TempFolder& folder, const std::string& variant, double error_m) {
  Json result = test::WithBodies(test::Result("room", 8),
                                 Json::array({test::BodyOf(1, std::vector<double>(8, error_m))}));
  result["variant"] = variant;
  result["job"] = "job of " + variant;
  folder.Write(variant + "/result.json", result.dump());
  return (folder.path() / variant).string();
}

TEST(CliCompare, PrintsRunsAsATableWithTheFirstAsReference) {
  const test::TempFolder folder;
  const std::string a = WriteRun(folder, "static", 0.04);
  const std::string b = WriteRun(folder, "full", 0.03);
  const auto text = RunProgram({"experiment", "compare", a, b});
  ASSERT_EQ(text.exit_code, 0) << text.err;
  EXPECT_THAT(text.out, AllOf(HasSubstr("Runs on room\n"), HasSubstr("difference from static"),
                              HasSubstr("-0.0100 "), HasSubstr("-25.0%\n")));
  EXPECT_THAT(RunProgram({"experiment", "compare", b, a}).out, HasSubstr("difference from full"));
  EXPECT_THAT(RunProgram({"experiment", "compare", a, b, "--format", "csv"}).out,
              HasSubstr("\r\nfull,"));
}

TEST(CliCompare, BadInputGivesOneLine) {
  const test::TempFolder folder;
  const std::string a = WriteRun(folder, "static", 0.04);
  folder.Write("suite/plan.json", "{}");
  ExpectError(RunProgram({"experiment", "compare", a, (folder.path() / "none").string()}),
              "none: found no result.json or plan.json, expected the output folder of a run or");
  ExpectError(RunProgram({"experiment", "compare", a, (folder.path() / "suite").string()}),
              "suite: found the folder of a suite, expected that of a run, as " + a, 2);
  ExpectError(RunProgram({"experiment", "compare", a, a}), "found the same run twice");
  EXPECT_EQ(RunProgram({"experiment", "compare", a}).exit_code, 2);
}

}  // namespace
}  // namespace cvo
