// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// `clustervo overlay` as a process, on runs on images drawn by the test.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "core/base/error.h"
#include "core/files/images/image_file.h"
#include "core/files/json/json.h"
#include "tests/experiments/cli/process.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using test::Arguments;
using test::ExpectError;
using test::ProcessResult;
using test::ReadFile;
using test::RunProgram;
using test::With;
using testing::AllOf;
using testing::HasSubstr;

constexpr int kFrames = 6;

class CliOverlay : public test::TinyTest {
 protected:
  CliOverlay() : TinyTest(kFrames) {}

  fs::path tiny() const { return Path("tiny"); }
  fs::path run(const std::string& variant = "full") const { return Path(variant); }
  fs::path out(const std::string& name = "out") const { return Path(name); }

  // Makes a run with a detection in every frame, on what is really a wall.
  void MakeRun(const std::string& variant = "full", const Arguments& more = {"--landmarks"}) {
    std::string boxes;
    for (int i = 0; i < kFrames; ++i) {
      boxes += StrCat(i, " -1 Car -1 -1 -10 60 30 160 100 -1 -1 -1 -1000 -1000 -1000 -10 0.9\n");
    }
    folder_.Write("boxes.txt", boxes);
    const ProcessResult made =
        RunProgram(With({"run", tiny().string(), "-o", run(variant).string(), "--variant", variant,
                         "--detections", Path("boxes.txt")},
                        more));
    ASSERT_EQ(made.exit_code, 0) << made.err;
  }
  ProcessResult Overlay(const Arguments& arguments, const std::string& name = "out") const {
    return RunProgram(With({"overlay", "-o", out(name).string()}, arguments));
  }
};

TEST_F(CliOverlay, DrawsEveryFrameAndASheetReproducibly) {
  MakeRun();
  const ProcessResult one = Overlay({run().string(), "--sheet"}, "one");
  ASSERT_EQ(one.exit_code, 0) << one.err;
  EXPECT_THAT(one.out, AllOf(HasSubstr("000000.png to 000005.png (6 images)"),
                             HasSubstr("sheet.png (6 frames)")));
  EXPECT_THAT(one.err, AllOf(HasSubstr("100 %  6/6 frames"), testing::Not(HasSubstr("note"))));
  ASSERT_EQ(Overlay({run().string(), "--sheet", "-q"}, "two").exit_code, 0);
  for (const char* name : {"000000.png", "000005.png", "sheet.png"}) {
    const std::string bytes = ReadFile(out("one") / name);
    EXPECT_GT(bytes.size(), 1000U);
    EXPECT_EQ(bytes, ReadFile(out("two") / name)) << name;
  }
  fs::remove(folder_.path() / "boxes.txt");
  EXPECT_THAT(Overlay({run().string(), "--sheet"}, "gone").err,
              HasSubstr("the run's detection file was not found"));
  const cv::Mat picture = ReadImageFile(out("one") / "000003.png", cv::IMREAD_COLOR);
  EXPECT_EQ(picture.cols, test::kTinyWidth_px);
  EXPECT_GT(picture.rows, test::kTinyHeight_px);
}

TEST_F(CliOverlay, SelectsFrames) {
  MakeRun();
  const ProcessResult run_some = Overlay({run().string(), "--frames", "1:5", "--every", "2"});
  ASSERT_EQ(run_some.exit_code, 0) << run_some.err;
  EXPECT_EQ(std::distance(fs::directory_iterator(out()), {}), 2);
  EXPECT_TRUE(fs::exists(out() / "000003.png"));
  ASSERT_EQ(Overlay({run().string(), "--frame", "2", "--svg"}, "vectors").exit_code, 0);
  EXPECT_THAT(ReadFile(out("vectors") / "000002.svg"),
              AllOf(HasSubstr("<image "), HasSubstr("<circle ")));
}

TEST_F(CliOverlay, DrawsRunsSideBySide) {
  MakeRun("2d");
  MakeRun("full");
  const ProcessResult both = Overlay({run("2d").string(), run("full").string(), "--frame", "4"});
  ASSERT_EQ(both.exit_code, 0) << both.err;
  EXPECT_EQ(std::distance(fs::directory_iterator(out()), {}), 1);
  EXPECT_GT(ReadImageFile(out() / "000004.png", cv::IMREAD_COLOR).cols, 2 * test::kTinyWidth_px);
}

TEST_F(CliOverlay, ReportsMissingAndTruncatedLandmarks) {
  MakeRun("full", {});
  MakeRun("2d");
  test::CutFile(run("2d") / "landmarks.csv");
  for (const auto& [variant, problem] : {std::pair{"full", "landmarks.csv"}, {"2d", "line "}}) {
    const ProcessResult without = Overlay({run(variant).string(), "--frame", "2"});
    ASSERT_EQ(without.exit_code, 0) << without.err;
    EXPECT_THAT(without.err, AllOf(HasSubstr("drawn without landmarks"), HasSubstr(problem)));
    EXPECT_TRUE(fs::exists(out() / "000002.png"));
  }
}

TEST_F(CliOverlay, RefusesInvalidInput) {
  MakeRun();
  ExpectError(Overlay({out("none").string()}), "result.json");
  ExpectError(Overlay({run().string(), "--frame", "60"}),
              "--frame 60: found no such frame in the run, expected 0 to 5", 2);
  ExpectError(Overlay({run().string(), "--frames", "8:9"}), "--frames 8:9", 2);
  ExpectError(Overlay({run().string(), "RUN", "--svg"}), "--svg: found 2 runs, expected one", 2);
  ExpectError(RunProgram({"overlay", run().string(), "-o", "/proc/nowhere"}), "/proc/nowhere");
  fs::create_directories(out("blocked") / "000002.png");
  ExpectError(Overlay({run().string(), "--frame", "2"}, "blocked"), "000002.png");
  fs::copy(run(), out("other"));
  Json result = ReadJson(run() / "result.json");
  result["schema_version"] = 99;
  folder_.Write("other/result.json", result.dump());
  ExpectError(Overlay({out("other").string()}), "schema_version 99");
  result["schema_version"] = 3;
  result.erase("checksum");
  result["sequence"]["name"] = "another";
  folder_.Write("other/result.json", result.dump());
  ExpectError(Overlay({run().string(), out("other").string()}), "a run of another");
  EXPECT_FALSE(fs::exists(out()));
}

TEST_F(CliOverlay, ReportsMovedImagesAndReadsThemElsewhere) {
  MakeRun();
  fs::rename(tiny(), out("moved"));
  ExpectError(Overlay({run().string(), "--frame", "1"}),
              "are not in the folder that the run read them from");
  const ProcessResult moved =
      Overlay({run().string(), "--frame", "1", "--sequence", out("moved").string()});
  EXPECT_EQ(moved.exit_code, 0) << moved.err;
}

TEST_F(CliOverlay, ReportsWrongUsage) {
  for (const Arguments& wrong : {Arguments{},
                                 {"RUN", "--labels", "x"},
                                 {"RUN", "--no-images"},
                                 {"RUN", "--frame", "-1"},
                                 {"--suite", "DIR"},
                                 {"RUN", "--variant", "full"}}) {
    ExpectError(Overlay(wrong), "clustervo overlay --help", 2);
  }
}

TEST_F(CliOverlay, FindsTheRunsOfASuite) {
  MakeRun();
  fs::create_directories(out("suite") / "jobs");
  fs::rename(run(), out("suite") / "jobs" / "abc");
  const Json job = {{"sequence", "tiny"}, {"detections", ""},
                    {"variant", "full"},  {"system", ""},
                    {"seed", 4},          {"oracle", Json::array()},
                    {"missing", ""},      {"parameters", Json::object()},
                    {"job", "abc"}};
  Json lost = job;
  lost["variant"] = "2d";
  lost["job"] = "not there";
  const Json plan = {
      {"schema_version", 1},
      {"kind", "plan"},
      {"suite", {{"name", "small"}, {"about", "x"}}},
      {"build", "b"},
      {"table", {{"rows", {"variant"}}, {"metrics", {"camera_ate"}}, {"reference", ""}}},
      {"jobs", {job, lost}}};
  folder_.Write("suite/plan.json", plan.dump());
  const std::string suite = out("suite").string();
  const auto overlay = [&](const std::string& sequence, const std::string& variant,
                           const std::string& seed) {
    return Overlay({"--suite", suite, "--sequence", sequence, "--variant", variant, "--seed", seed,
                    "--frame", "2"});
  };
  EXPECT_EQ(overlay("tiny", "full", "4").exit_code, 0);
  EXPECT_TRUE(fs::exists(out() / "000002.png"));
  ExpectError(overlay("tin", "full", "4"), "did you mean tiny, full?");
  ExpectError(overlay("tiny", "2d", "4"), "result.json");
  ExpectError(overlay("tiny", "full", "5"), "no run of tiny, full, seed 5");
}

}  // namespace
}  // namespace cvo
