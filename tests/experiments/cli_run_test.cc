// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// clustervo run to its end, on images that the test draws.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/files/json.h"
#include "tests/experiments/cli_process.h"
#include "tests/experiments/runner_tiny_sequence.h"
#include "tests/support/temp_folder.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using test::ProcessResult;
using test::ReadFile;
using test::RunProgram;
using testing::AllOf;
using testing::HasSubstr;

constexpr int kFrames = 8;
const std::vector<std::string> kRecorded = {"result.json", "camera.tum", "camera.kitti"};

class CliRun : public testing::Test {
 protected:
  CliRun() { test::WriteTinySequence(tiny(), kFrames); }

  fs::path tiny() const { return folder_.path() / "tiny"; }
  fs::path out(const std::string& name = "out") const { return folder_.path() / name; }

  ProcessResult Run(const fs::path& output, const std::vector<std::string>& more = {},
                    const test::ProcessSetup& setup = {}) const {
    std::vector<std::string> arguments = {"run", tiny().string(), "-o", output.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunProgram(arguments, setup);
  }
  static Json ResultOf(const fs::path& output) { return ReadJson(output / "result.json"); }

  test::TempFolder folder_;
};

TEST_F(CliRun, WritesFourFilesAndPrintsTheMetrics) {
  const ProcessResult run = Run(out(), {"--set", "orb.features=500", "--seed", "7"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("camera_ate"), HasSubstr("8 frames"), HasSubstr("status")));
  EXPECT_THAT(run.err, AllOf(HasSubstr("100 %  8/8 frames"), HasSubstr("frames/s")));
  const Json result = ResultOf(out());
  EXPECT_EQ(result["seed"], 7);
  EXPECT_EQ(result["options"]["orb"]["features"], 500);
  EXPECT_EQ(result["frames"].size(), 8U);
  EXPECT_EQ(test::LineCount(ReadFile(out() / "camera.kitti")), 8U);
  EXPECT_EQ(test::LineCount(ReadFile(out() / "camera.tum")), 8U);
  EXPECT_EQ(ReadJson(out() / "timing.json")["job"], result["job"]);
  EXPECT_EQ(std::distance(fs::directory_iterator(out()), {}), 4);
}

TEST_F(CliRun, TheSameBytesEveryTimeAndForAnyNumberOfThreads) {
  ASSERT_EQ(Run(out("one"), {"--threads", "1"}).exit_code, 0);
  ASSERT_EQ(Run(out("two"), {"--threads", "2"}).exit_code, 0);
  ASSERT_EQ(Run(out("four"), {"--threads", "4", "--quiet"}).exit_code, 0);
  for (const std::string& name : kRecorded) {
    EXPECT_EQ(ReadFile(out("one") / name), ReadFile(out("two") / name)) << name;
    EXPECT_EQ(ReadFile(out("one") / name), ReadFile(out("four") / name)) << name;
  }
}

TEST_F(CliRun, SkipsADamagedImageAndListsIt) {
  test::CutFile(tiny() / "image_1" / "000004.png");
  const ProcessResult run = Run(out());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("frame 4 skipped: image_1/000004.png"));
  const Json result = ResultOf(out());
  EXPECT_EQ(result["undecodable"][0]["frame"], 4);
  EXPECT_EQ(result["frames"][4]["status"], "skipped");
  EXPECT_EQ(result["trajectories"]["camera.kitti"]["predicted_rows"], Json::array({4}));
  EXPECT_EQ(test::LineCount(ReadFile(out() / "camera.kitti")), 8U);
  EXPECT_EQ(test::LineCount(ReadFile(out() / "camera.tum")), 7U);
  for (const Json& metric : result["metrics"]) {
    if (metric["name"] == "camera_coverage") {
      EXPECT_EQ(metric["value"], 0.875);
    }
  }
}

TEST_F(CliRun, StrictFailsOnADamagedImageAndWritesNothing) {
  test::CutFile(tiny() / "image_1" / "000004.png");
  const ProcessResult run = Run(out(), {"--strict", "--quiet"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, AllOf(HasSubstr("clustervo: error: "), HasSubstr("image_1/000004.png")));
  EXPECT_EQ(test::LineCount(run.err), 1U);
  EXPECT_FALSE(fs::exists(out()));
}

TEST_F(CliRun, AFullDiskLosesNothing) {
  ASSERT_EQ(Run(out()).exit_code, 0);
  const std::string before = ReadFile(out() / "result.json");
  // Room for the trajectories, which are written first, but not for the result.
  const ProcessResult run = Run(out(), {"--quiet", "--seed", "1"}, {.file_size_limit = 4096});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, AllOf(HasSubstr("json"), HasSubstr("cannot write")));
  EXPECT_EQ(test::LineCount(run.err), 1U);
  EXPECT_EQ(ReadFile(out() / "result.json"), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(out()), {}), 4);
}

TEST_F(CliRun, AnInterruptEndsTheRunCleanly) {
  test::WriteTinySequence(tiny(), 150);
  const ProcessResult run = Run(out(), {"--threads", "1"}, {.interrupt_at = " 10 %"});
  EXPECT_EQ(run.exit_code, 130);
  EXPECT_THAT(run.err, testing::EndsWith("clustervo: stopped, nothing was written\n"));
  EXPECT_FALSE(fs::exists(out()));
}

}  // namespace
}  // namespace cvo
