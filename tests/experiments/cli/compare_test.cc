// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// `clustervo compare` as a process, on hand-made results.
#include <gmock/gmock.h>

#include "tests/experiments/cli/process.h"
#include "tests/reports/results/result_files.h"

namespace cvo {
namespace {

using test::ExpectError;
using test::Json;
using test::RunProgram;
using testing::AllOf;
using testing::HasSubstr;

std::string WriteRun(const test::TempFolder& folder, const std::string& variant, double error_m) {
  Json result = test::WithBodies(test::Result("room", 8),
                                 Json::array({test::BodyOf(1, std::vector<double>(8, error_m))}));
  result["variant"] = variant;
  result["frames"] = Json::array();
  folder.Write(variant + "/result.json", result.dump());
  return (folder.path() / variant).string();
}

TEST(CliCompare, PrintsMetricsAndPairs) {
  const test::TempFolder folder;
  const std::string a = WriteRun(folder, "static", 0.04);
  const std::string b = WriteRun(folder, "full", 0.03);
  const auto text = RunProgram({"compare", a, b});
  ASSERT_EQ(text.exit_code, 0) << text.err;
  EXPECT_THAT(text.out, AllOf(HasSubstr("camera_ate "), HasSubstr("3 (8 frames)"),
                              HasSubstr("-0.01"), HasSubstr("undecided (3 blocks, 6 needed)"),
                              HasSubstr("by SE(3)"), HasSubstr("unit  static  full"),
                              HasSubstr("they say nothing about other scenes")));
  const auto json = RunProgram({"compare", a, b, "--json"});
  ASSERT_EQ(json.exit_code, 0) << json.err;
  const Json parsed = Json::parse(json.out);
  EXPECT_EQ(parsed["kind"], "comparison of runs");
  EXPECT_EQ(parsed["by_frame"][0]["frames"], 8);
  EXPECT_EQ(RunProgram({"compare", a, b, "--json"}).out, json.out);
}

TEST(CliCompare, BadInputGivesOneLine) {
  const test::TempFolder folder;
  const std::string a = WriteRun(folder, "static", 0.04);
  folder.Write("suite/plan.json", "{}");
  ExpectError(RunProgram({"compare", a, (folder.path() / "none").string()}),
              "none: found no result.json, expected the output folder of a run");
  ExpectError(RunProgram({"compare", a, (folder.path() / "suite").string()}),
              "suite: found a suite's folder");
  EXPECT_EQ(RunProgram({"compare", a}).exit_code, 2);
}

}  // namespace
}  // namespace cvo
