// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/cli/process.h"
#include "tests/reports/gate/gate_folder.h"

namespace cvo::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class CliCheckTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const ProcessResult write =
        RunProgram({"check", folder_.path(), "--write-baseline", baseline_, "--gate-seeds", "2"});
    ASSERT_EQ(write.exit_code, 0) << write.err;
    EXPECT_THAT(write.out, StartsWith("gate: 16 runs with 2 metrics; checked runs need 2 seeds"));
  }
  ProcessResult Check(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"check", folder_.path(), "--baseline", baseline_});
    return RunProgram(more);
  }

  TempFolder temp_;
  GateFolder folder_;
  std::string baseline_ = temp_.path() / "new" / "baseline.json";
};

TEST_F(CliCheckTest, SameResultsPass) {
  const ProcessResult check = Check();
  EXPECT_EQ(check.exit_code, 0) << check.out << check.err;
  EXPECT_THAT(check.out, StartsWith("gate: 16 runs compared with those of 0123456789ab: 0 worse"));
  EXPECT_THAT(check.out, HasSubstr("\nno regression\n"));
  EXPECT_EQ(check.err, "");
}

TEST_F(CliCheckTest, RegressionFailsAndIsWritten) {
  for (int seed = 1; seed <= 4; ++seed) {
    folder_.EditMetric(GateFolder::Id("room", "full", seed), 1, 0.2);
  }
  const std::string junit = temp_.path() / "check.xml";
  const std::string markdown = temp_.path() / "check.md";
  const ProcessResult check = Check({"--junit", junit, "--markdown", markdown});
  EXPECT_EQ(check.exit_code, 1);
  EXPECT_THAT(check.out, HasSubstr("WORSE"));
  EXPECT_THAT(check.out, HasSubstr("\nregression\n"));
  EXPECT_THAT(ReadFile(junit), HasSubstr("<failure message=\"regression\">gate: 16 runs"));
  EXPECT_THAT(ReadFile(markdown), StartsWith("### Regression\n"));
}

TEST_F(CliCheckTest, WrongUsageGivesOneLine) {
  const auto fails = [&](const std::vector<std::string>& arguments, int code, const char* part) {
    const ProcessResult process = RunProgram(arguments);
    EXPECT_EQ(process.exit_code, code);
    EXPECT_THAT(process.err, HasSubstr(part));
    EXPECT_EQ(LineCount(process.err), 1U) << process.err;
  };
  const std::string folder = folder_.path();
  fails({"check", folder}, 2, "--baseline or --write-baseline");
  fails({"check", folder, "--baseline", baseline_, "--write-baseline", baseline_}, 2, "excludes");
  fails({"check", folder, "--write-baseline", baseline_, "--junit", "a.xml"}, 2, "--baseline");
  fails({"check", folder, "--baseline", baseline_, "--gate-seeds", "2"}, 2, "--write-baseline");
  fails({"check", temp_.path() / "none", "--baseline", baseline_}, 1, "no such file");
  fails({"check", folder, "--baseline", temp_.path() / "none.json"}, 1, "none.json");
  fails({"check", folder, "--write-baseline", baseline_, "--gate-seeds", "9"}, 1, "found 4 seeds");
}

}  // namespace
}  // namespace cvo::test
