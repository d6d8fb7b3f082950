// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "core/base/error.h"
#include "tests/experiments/cli/process.h"
#include "tests/experiments/jobs/slurm/slurm_cluster.h"
#include "tests/support/temp_folder.h"

namespace cvo::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr const char* kSuite = R"({
  "name": "small",
  "about": "Two variants on one small scene",
  "sequences": [{"scene": "tiny", "detections": "good"}],
  "variants": ["full", "2d"],
  "seeds": 1,
  "table": {"rows": ["variant"], "metrics": ["camera_ate"], "reference": "full"}
})";

// Returns the files written by the jobs of a suite, except for their times.
std::map<std::string, std::string> ResultsIn(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder / "jobs")) {
    if (!entry.is_regular_file() || entry.path().filename() == "timing.json") continue;
    files[entry.path().lexically_relative(folder).string()] = ReadFile(entry.path());
  }
  return files;
}

ProcessResult RunSuiteOn(const std::string& engine, const TempFolder& temp) {
  const fs::path suite = temp.Write("suite.json", kSuite);
  return RunProgram(
      {"experiment", "run", suite.string(), "-o", (temp.path() / engine).string(), "--engine",
       engine, "-j", "2"},
      {.environment = {"CLUSTERVO_CACHE=" + (temp.path() / "cache").string() + engine}});
}

TEST(Slurm, GivesTheSameBytesAsTheLocalEngine) {
  const SlurmCluster cluster;
  if (!cluster.missing().empty()) GTEST_SKIP() << cluster.missing();
  const TempFolder temp;
  const ProcessResult local = RunSuiteOn("local", temp);
  ASSERT_EQ(local.exit_code, 0) << local.err;
  const ProcessResult slurm = RunSuiteOn("slurm", temp);
  ASSERT_EQ(slurm.exit_code, 0) << slurm.err;
  EXPECT_THAT(slurm.err, HasSubstr("slurm: job "));
  const std::map<std::string, std::string> results = ResultsIn(temp.path() / "slurm");
  EXPECT_EQ(results, ResultsIn(temp.path() / "local"));
  EXPECT_EQ(std::count_if(results.begin(), results.end(),
                          [](const auto& file) { return file.first.ends_with("/result.json"); }),
            2);
  EXPECT_EQ(slurm.out, local.out);
}

}  // namespace
}  // namespace cvo::test
