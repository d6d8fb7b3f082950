// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>

#include "tests/experiments/cli/process.h"
#include "tests/support/temp_folder.h"

namespace cvo::test {
namespace {

using ::testing::HasSubstr;

const std::string& Folder() {
  static const std::string folder = CVO_REGRESSION_FOLDER;
  return folder;
}

// Runs the program with its cache below the build folder.
ProcessResult RunCached(const Arguments& arguments) {
  const ProcessSetup setup{.environment = {"CLUSTERVO_CACHE=" + Folder() + "/cache"}};
  return RunProgram(arguments, setup);
}

ProcessResult RunSuite(const std::string& suite, const std::string& output, Arguments more = {}) {
  const Arguments arguments =
      With({"experiment", "run", suite, "-o", output, "-j", "2", "-q"}, more);
  return RunCached(arguments);
}

TEST(Regression, Ci) {
  std::filesystem::create_directories(Folder());
  const std::string output = Folder() + "/ci";
  const ProcessResult suite = RunSuite("ci", output);
  EXPECT_EQ(suite.exit_code, 0) << suite.out << suite.err;
  const ProcessResult check = RunCached({"check", output, "--baseline", CVO_BASELINE, "--junit",
                                         Folder() + "/ci.xml", "--markdown", Folder() + "/ci.md"});
  std::cout << check.out << check.err;
  EXPECT_EQ(check.exit_code, 0) << "where the change is meant: make baseline";
}

// Spoils the estimator: a sixth of the features, and no rejection of uncertain disparities.
TEST(Regression, SpoiledEstimatorIsCaught) {
  const TempFolder temp;
  const std::string suite = temp.Write("short.json", R"({
    "name": "short", "about": "for this test",
    "sequences": [{"scene": "tiny", "detections": "good"}],
    "variants": ["full", "static"], "seeds": 12,
    "table": {"metrics": ["camera_ate", "object_success_10cm", "moving_recall"]}
  })");
  const std::string good = (temp.path() / "good").string();
  const std::string bad = (temp.path() / "bad").string();
  const std::string baseline = (temp.path() / "baseline.json").string();
  const ProcessResult first = RunSuite(suite, good);
  ASSERT_EQ(first.exit_code, 0) << first.out << first.err;
  const ProcessResult second =
      RunSuite(suite, bad, {"--set", "orb.features=300", "--set", "stereo.max_sigma_medians=1000"});
  ASSERT_EQ(second.exit_code, 0) << second.out << second.err;
  ASSERT_EQ(RunCached({"check", good, "--write-baseline", baseline}).exit_code, 0);
  const ProcessResult same = RunCached({"check", good, "--baseline", baseline});
  EXPECT_EQ(same.exit_code, 0) << same.out << same.err;
  EXPECT_THAT(same.out, HasSubstr("0 worse, 0 better, 0 within tolerance"));
  const ProcessResult spoiled = RunCached({"check", bad, "--baseline", baseline});
  EXPECT_EQ(spoiled.exit_code, 1) << spoiled.out << spoiled.err;
  EXPECT_THAT(spoiled.out, HasSubstr("WORSE"));
  EXPECT_THAT(spoiled.out, HasSubstr("camera_ate"));
}

}  // namespace
}  // namespace cvo::test
