// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// `clustervo eval --sequence`, `--ap`, `--tracking` and `--clock-offset` as processes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/files/json/json.h"
#include "experiments/metrics/trajectory.h"
#include "tests/experiments/cli/process.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/support/temp_folder.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using test::ProcessResult;
using test::RunProgram;
using testing::AllOf;
using testing::HasSubstr;

class EvalSequence : public testing::Test {
 protected:
  EvalSequence() { test::WriteTinySequence(tiny(), 3); }

  std::string tiny() const { return (folder_.path() / "tiny").string(); }
  std::string out() const { return (folder_.path() / "out").string(); }
  std::string poses() const { return (fs::path(tiny()) / "poses.txt").string(); }
  ProcessResult Evaluate(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"eval", "--sequence", tiny(), "--estimate"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunProgram(arguments);
  }
  test::TempFolder folder_;
};

TEST_F(EvalSequence, ScoresAndWritesAResult) {
  const ProcessResult result = Evaluate({poses(), "--name", "other", "-o", out()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("poses of 3 of 3 frames"), HasSubstr("camera_ate")));
  const std::string written = test::ReadFile(fs::path(out()) / "result.json");
  EXPECT_EQ(ParseJson(written, "result")["variant"], "system:other");
  EXPECT_EQ(Evaluate({poses(), "--name", "other", "--json"}).out, written);
  EXPECT_EQ(Evaluate({poses(), "-o", out()}).exit_code, 0);
  EXPECT_EQ(ParseJson(test::ReadFile(fs::path(out()) / "result.json"), "result")["variant"],
            "system:poses");
}

TEST_F(EvalSequence, TheResultOfARunIsNotOverwritten) {
  folder_.Write("out/camera.tum", "");
  folder_.Write("out/result.json", "mine");
  test::ExpectError(Evaluate({poses(), "-o", out()}), "camera.tum of a run");
  EXPECT_EQ(test::ReadFile(fs::path(out()) / "result.json"), "mine");
}

TEST_F(EvalSequence, BadInputLeavesNothing) {
  const std::string bad = folder_.Write("bad.tum", "0 0 0 0 0 0 0 1\n7 0 0 0 0 0 0 1\n").string();
  test::ExpectError(Evaluate({bad, "-o", out()}), "bad.tum:2: ");
  const std::string rows = folder_.Write("rows.txt", "").string();
  test::ExpectError(Evaluate({poses(), "--objects", rows, "-o", out()}), "rows.txt:1: ");
  EXPECT_FALSE(fs::exists(out()));
}

TEST_F(EvalSequence, RefusesFlagsOfTheOtherMode) {
  test::ExpectError(RunProgram({"eval", "--estimate", poses()}), "--sequence", 2);
  test::ExpectError(
      RunProgram({"eval", "--estimate", poses(), "--groundtruth", poses(), "-o", out()}),
      "--output", 2);
  test::ExpectError(Evaluate({poses(), "--format", "kitti"}), "--format", 2);
}

TEST_F(EvalSequence, BodiesWithoutTruthAreNotScored) {
  const std::string rows =
      folder_.Write("rows.txt", "0 1 Car -1 -1 0 0 0 9 9 1 1 1 0 0 9 0 1\n").string();
  const ProcessResult result = Evaluate({poses(), "--objects", rows});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("1 object-frames"), HasSubstr("objects not scored")));
}

// Scores KITTI boxes. Flags of the other modes are refused, and the JSON states the contract.
TEST_F(EvalSequence, ScoresAveragePrecision) {
  const std::string row = "0 1 Car 0 0 0 10 20 90 80 1.5 1.6 3.9 1 2 30 0.1";
  const std::string labels = folder_.Write("labels.txt", row + "\n").string();
  const std::string rows = folder_.Write("rows.txt", row + " 0.5\n").string();
  const std::vector<std::string> boxes = {"eval", "--ap", "--labels", labels, "--estimate", rows};
  const auto run = [&boxes](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = boxes;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunProgram(arguments);
  };
  EXPECT_THAT(run({}).out, HasSubstr("bv           11      9.09"));
  const Json json = ParseJson(run({"--iou", "0.25", "--json"}).out, "eval --ap");
  EXPECT_EQ(json["kind"], "average precision");
  EXPECT_EQ(json["average_precision"][1]["contract"]["least_overlap"], 0.25);
  EXPECT_EQ(json["average_precision"][1]["levels"][0]["ap11"], 1.0 / 11.0);
  test::ExpectError(run({"--iou", "1.5"}), "--iou", 2);
  test::ExpectError(run({"--class", "Tram"}), "--class", 2);
  test::ExpectError(run({"--sequence", tiny()}), "--sequence", 2);
  test::ExpectError(run({"--frames", "4:"}), "--frames", 2);
  test::ExpectError(RunProgram({"eval", "--ap", "--estimate", rows}), "--labels", 2);
  test::ExpectError(Evaluate({poses(), "--iou", "0.5"}), "--iou", 2);
  test::ExpectError(run({"--tracking"}), "--tracking", 2);
}

TEST_F(EvalSequence, ScoresTracking) {
  const std::string row = "0 1 Car 0 0 0 10 20 90 80 1.5 1.6 3.9 1 2 30 0.1";
  const std::string labels = folder_.Write("labels.txt", row + "\n").string();
  const std::string rows = folder_.Write("rows.txt", row + " 0.5\n").string();
  const ProcessResult result =
      RunProgram({"eval", "--tracking", "--labels", labels, "--estimate", rows, "--json"});
  const Json json = ParseJson(result.out, "eval --tracking");
  EXPECT_EQ(json["tracking"].size(), 2U);
  EXPECT_EQ(json["tracking"][1]["overlap"], "3d");
  EXPECT_EQ(json["tracking"][1]["clear"]["mota"], 1.0);
  const std::string folder = folder_.path().string();
  test::ExpectError(RunProgram({"eval", "--tracking", "--labels", folder, "--estimate", folder}),
                    "");
  test::ExpectError(
      RunProgram({"eval", "--tracking", "--labels", labels, "--estimate", rows, "--iou", "0.5"}),
      "--iou", 2);
}

// The trajectory of a camera that rotates back and forth, with 10 poses per second and a clock that
// is `ahead_s` ahead.
std::string TurningCamera(double ahead_s) {
  Trajectory trajectory;
  for (int i = 0; i < 100; ++i) {
    const double angle = 0.3 * std::sin(0.25 * i) + 0.2 * std::sin(0.41 * i);
    trajectory.push_back({std::llround(1e9 * (1.0 + 0.1 * i + ahead_s)),
                          {ExpSo3({0.0, angle, 0.0}), Eigen::Vector3d::Zero()}});
  }
  return FormatTumTrajectory(trajectory);
}

TEST_F(EvalSequence, EstimatesTheClockOffsetOfTheTruth) {
  const std::string truth = folder_.Write("truth.tum", TurningCamera(0.25)).string();
  const std::string estimate = folder_.Write("estimate.tum", TurningCamera(0.0)).string();
  const std::vector<std::string> clock = {"eval", "--clock-offset", "1",     "--groundtruth",
                                          truth,  "--estimate",     estimate};
  const ProcessResult result = RunProgram(clock);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("clock offset (ground truth minus estimate): +0.2500"));
  std::vector<std::string> with_json = clock;
  with_json.emplace_back("--json");
  const Json json = ParseJson(RunProgram(with_json).out, "eval --clock-offset");
  EXPECT_NEAR(json["clock"]["offset_s"].get<double>(), 0.25, 1e-3);
  test::ExpectError(
      RunProgram({"eval", "--clock-offset", "1", "--groundtruth", truth, "--estimate", poses()}),
      "clocks are compared by times");
  test::ExpectError(Evaluate({poses(), "--clock-offset", "1"}), "2 pairs of poses");
  test::ExpectError(Evaluate({poses(), "--clock-offset", "1", "-o", out()}),
                    "does not apply with --clock-offset", 2);
}

}  // namespace
}  // namespace cvo
