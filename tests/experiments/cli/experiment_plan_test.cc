// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// `clustervo experiment list` and `plan` as processes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/cli/process.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/experiments/suite/examples.h"
#include "tests/support/temp_folder.h"

namespace cvo {
namespace {

using test::ProcessResult;
using test::RunProgram;
using testing::HasSubstr;

class CliExperimentPlan : public testing::Test {
 protected:
  ProcessResult Plan(std::vector<std::string> more) const {
    std::vector<std::string> arguments = {"experiment", "plan", "-q", "-o",
                                          (folder_.path() / "out").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunProgram(arguments,
                      {.environment = {"CLUSTERVO_CACHE=" + (folder_.path() / "cache").string(),
                                       "CLUSTERVO_DATA=" + folder_.path().string()}});
  }

  test::TempFolder folder_;
};

TEST_F(CliExperimentPlan, ListsTheSuitesWithTheirSizes) {
  const ProcessResult list = RunProgram({"experiment", "list"});
  EXPECT_EQ(list.exit_code, 0) << list.err;
  EXPECT_THAT(list.out, HasSubstr("oracle_ladder"));
  EXPECT_THAT(list.out, testing::ContainsRegex("ablation +test +40 +6 +1 +1 +240 "));
}

TEST_F(CliExperimentPlan, ListsJobsAndMissingSequences) {
  test::WriteTinySequence(folder_.path() / "07", 4);
  Json json = test::FolderSuite("07");
  json["sequences"].push_back({{"folder", "08"}});
  const std::string suite = folder_.Write("s.json", json.dump()).string();
  const ProcessResult plan = Plan({suite, "--seeds", "2"});
  EXPECT_EQ(plan.exit_code, 0) << plan.err;
  EXPECT_THAT(plan.out, HasSubstr("suite small: 4 jobs on 2 sequences"));
  EXPECT_THAT(plan.out, HasSubstr("to run: 2\n  2 x new"));
  EXPECT_THAT(plan.out, HasSubstr("missing, left out: 2\n  2 x no 08 below"));
  EXPECT_THAT(plan.out, HasSubstr("estimated time: 1 s with 1 process"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out"));
}

TEST_F(CliExperimentPlan, BadInputGivesOneLineAndAnExitCode) {
  const std::string file = folder_.Write("s.json", R"({"name": "s", "sedes": 3})").string();
  for (const auto& arguments :
       std::vector<std::vector<std::string>>{{"no_such_suite"},
                                             {file},
                                             {"ci", "--set", "window.spatail=3"},
                                             {"ci", "--seeds", "0"}}) {
    const ProcessResult plan = Plan(arguments);
    EXPECT_EQ(plan.exit_code, 2) << plan.err;
    EXPECT_EQ(test::LineCount(plan.err), 1U) << plan.err;
    EXPECT_EQ(plan.out, "");
  }
}

}  // namespace
}  // namespace cvo
