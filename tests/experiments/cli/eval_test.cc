// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// `clustervo eval trajectory` and `boxes` as processes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "tests/experiments/cli/process.h"

namespace cvo::eval_test {
namespace {

namespace fs = std::filesystem;
using test::Arguments;
using test::ExpectError;
using test::ProcessResult;
using test::RunProgram;
using test::With;
using testing::AllOf;
using testing::HasSubstr;

class Eval : public test::TinyTest {
 protected:
  std::string Write(const std::string& name, const std::string& content) const {
    return folder_.Write(name, content).string();
  }
  static ProcessResult Evaluate(const std::string& truth, const std::string& estimate,
                                const Arguments& more = {}) {
    return RunProgram(
        With({"eval", "trajectory", "--groundtruth", truth, "--estimate", estimate}, more));
  }
};

TEST_F(Eval, MatchesTumPosesByTime) {
  const std::string truth = Write("truth.tum",
                                  "# time x y z and a rotation\n0.0 0 0 0 0 0 0 1\n"
                                  "0.1 1 0 0 0 0 0 1\n0.2 2 0 1 0 0 0 1\n0.3 3 1 1 0 0 0 1\n");
  const std::string estimate =
      Write("estimate.tum",
            "0.101 1 0 0 0 0 0 1\n0.201 2 0 1 0 0 0 1\n0.301 3 1 1 0 0 0 1\n5 0 0 0 0 0 0 1\n");
  const ProcessResult result = Evaluate(truth, estimate, {"--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = ParseJson(result.out, "evaluation");
  EXPECT_EQ(json["matched"], 3);
  EXPECT_EQ(json["unmatched_groundtruth"], 1);
  EXPECT_EQ(json["unmatched_estimate"], 1);
  EXPECT_EQ(json["metrics"][0]["name"], "camera_coverage");
  EXPECT_EQ(json["metrics"][0]["value"], 0.75);
  EXPECT_THAT(Evaluate(truth, estimate).out,
              HasSubstr("3 poses matched, unmatched: 1 of the ground truth, 1 of the estimate"));
  ExpectError(Evaluate(truth, estimate, {"--max-time-difference", "0.0001"}),
              "found 0 poses that match one of truth, at 0.101000000 to 5.000000000 s", 1);
}

// The estimate is the truth at twice its size and 10 s later.
TEST_F(Eval, AlignsSeveralEstimatesAndShiftsTheirTimes) {
  const auto rows = [](double scale, double later_s) {
    std::string text;
    for (int i = 0; i < 8; ++i) {
      text +=
          StrCat(i + later_s, " ", scale * i, " ", scale * (i % 3), " 0 0 0 ", 0.01 * i, " 1\n");
    }
    return text;
  };
  const std::string truth = Write("truth.tum", rows(1.0, 0.0));
  const std::string twice = Write("twice.tum", rows(2.0, 10.0));
  const std::string same = Write("same.tum", rows(1.0, 10.0));
  const auto rms = [&](const char* align) {
    const ProcessResult result = RunProgram({"eval", "trajectory", truth, twice, same, "--align",
                                             align, "--time-offset", "-10", "--json"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const Json estimates = ParseJson(result.out, "evaluation").at("estimates");
    EXPECT_LT(estimates[1]["rms_m"].get<double>(), 1e-9);
    return estimates[0]["rms_m"].get<double>();
  };
  EXPECT_LT(rms("sim3"), 1e-9);
  EXPECT_NEAR(rms("origin"), std::sqrt((140.0 + 11.0) / 8.0), 1e-9);
  EXPECT_LT(rms("se3"), rms("origin"));
  EXPECT_LE(rms("se3"), rms("yaw") + 1e-9);
  EXPECT_THAT(RunProgram({"eval", "trajectory", truth, twice, same, "--time-offset", "-10"}).out,
              AllOf(HasSubstr("Aligned by SE(3)"), testing::ContainsRegex("metric +twice +same")));
  const std::string positions =
      Write("p.tum", "0 0 0 0 0 0 0 0\n1 1 1 0 0 0 0 0\n2 2 0 1 0 0 0 0\n");
  const ProcessResult result = Evaluate(positions, truth);
  EXPECT_THAT(result.err, HasSubstr("p.tum: quaternions that are missing, all zero"));
  EXPECT_THAT(result.out, testing::Not(HasSubstr("rpe")));
  ExpectError(Evaluate(positions, truth, {"--align", "origin"}), "positions without rotations", 1);
}

TEST_F(Eval, ReadsKittiPosesLineByLine) {
  const std::string truth = Path("tiny/poses.txt");
  const ProcessResult same = Evaluate(truth, truth, {"--json"});
  ASSERT_EQ(same.exit_code, 0) << same.err;
  const Json evaluation = ParseJson(same.out, "evaluation");
  for (const Json& metric : evaluation["metrics"]) {
    if (metric["name"] == "camera_ate") {
      EXPECT_LT(metric["value"].get<double>(), 1e-9);
    }
  }
  const std::string shorter = Write("short.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  ExpectError(Evaluate(truth, shorter), "found 3 poses, expected 1, as many as", 1);
}

TEST_F(Eval, BadTrajectories) {
  const std::string good = Write("good.tum", "0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n");
  const auto bad = [&](const std::string& text) { return Evaluate(good, Write("bad.tum", text)); };
  ExpectError(bad("0 0 0 0 0 0 0 1\n1 nan 0 0 0 0 0 1\n"), "bad.tum: found 1 poses that match", 1);
  ExpectError(bad("1 0 0 0 0 0 0 1\n0 1 0 0 0 0 0 1\n"), "bad.tum:2", 1);
  ExpectError(bad("# no pose\n"), "bad.tum", 1);
  ExpectError(bad("1 2 3\n"), "bad.tum:1", 1);
  ExpectError(bad("1 0 0 0 0 1 0 0 0 0 1 0\n"), "found 2 poses, expected 1, as many as", 1);
  ExpectError(Evaluate(good, "/no/such/file"), "/no/such/file", 1);
  ExpectError(Evaluate(good, good, {"--max-time-difference", "nan"}), "--max-time-difference", 2);
}

class EvalSequence : public test::TinyTest {
 protected:
  std::string poses() const { return Path("tiny/poses.txt"); }
  ProcessResult Evaluate(const Arguments& more) const {
    return RunProgram(With({"eval", "trajectory", "--sequence", tiny(), "--estimate"}, more));
  }
};

TEST_F(EvalSequence, ScoresAndWritesAResult) {
  const ProcessResult result = Evaluate({poses(), "--name", "other", "-o", out()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("poses of 3 of 3 frames"), HasSubstr("camera_ate")));
  const std::string written = test::ReadFile(Path("out/result.json"));
  EXPECT_EQ(ParseJson(written, "result")["variant"], "system:other");
  EXPECT_EQ(Evaluate({poses(), "--name", "other", "--json"}).out, written);
  EXPECT_EQ(Evaluate({poses(), "-o", out()}).exit_code, 0);
  EXPECT_EQ(ParseJson(test::ReadFile(Path("out/result.json")), "result")["variant"],
            "system:poses");
}

TEST_F(EvalSequence, TheResultOfARunIsNotOverwritten) {
  folder_.Write("out/camera.tum", "");
  folder_.Write("out/result.json", "mine");
  ExpectError(Evaluate({poses(), "-o", out()}), "camera.tum of a run");
  EXPECT_EQ(test::ReadFile(Path("out/result.json")), "mine");
}

TEST_F(EvalSequence, BadInputLeavesNothing) {
  const std::string bad = folder_.Write("bad.tum", "0 0 0 0 0 0 0 1\n7 0 0 0 0 0 0 1\n").string();
  ExpectError(Evaluate({bad, "-o", out()}), "bad.tum:2: ");
  const std::string rows = folder_.Write("rows.txt", "").string();
  ExpectError(Evaluate({poses(), "--objects", rows, "-o", out()}), "rows.txt:1: ");
  EXPECT_FALSE(fs::exists(out()));
}

TEST_F(EvalSequence, RefusesFlagsOfTheOtherMode) {
  ExpectError(RunProgram({"eval", "trajectory", "--estimate", poses()}), "--sequence", 2);
  ExpectError(RunProgram({"eval", "trajectory", "--estimate", poses(), "--groundtruth", poses(),
                          "-o", out()}),
              "--output", 2);
  ExpectError(Evaluate({poses(), "--max-time-difference", "1"}), "--max-time-difference", 2);
}

TEST_F(EvalSequence, BodiesWithoutTruthAreNotScored) {
  const std::string rows =
      folder_.Write("rows.txt", "0 1 Car -1 -1 0 0 0 9 9 1 1 1 0 0 9 0 1\n").string();
  const ProcessResult result = Evaluate({poses(), "--objects", rows});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("1 object-frames"), HasSubstr("objects not scored")));
}

// Flags of other commands are refused.
TEST_F(EvalSequence, ScoresBoxes) {
  const std::string row = "0 1 Car 0 0 0 10 20 90 80 1.5 1.6 3.9 1 2 30 0.1";
  const std::string labels = folder_.Write("labels.txt", row + "\n").string();
  const std::string rows = folder_.Write("rows.txt", row + " 0.5\n").string();
  const Arguments boxes = {"eval", "boxes", "--labels", labels, "--estimate", rows};
  const auto run = [&boxes](const Arguments& more) { return RunProgram(With(boxes, more)); };
  EXPECT_THAT(run({}).out,
              AllOf(HasSubstr("fewer than 41 labels"), HasSubstr("bv           11      100.00")));
  EXPECT_THAT(run({"--iou", "0.25"}).out, HasSubstr("IoU > 0.25"));
  EXPECT_THAT(run({"--score", "tracking"}).out, testing::ContainsRegex("3d +100.00 .*100.00 "));
  const std::string in_3d =
      folder_.Write("in_3d.txt", "0 1 Car 0 0 0 -1 -1 -1 -1 1.5 1.6 3.9 1 2 30 0.1 0.5\n").string();
  const std::string vans =
      folder_.Write("vans.txt", "0 1 Vans 0 0 0 10 20 90 80 1.5 1.6 3.9 1 2 30 0.1\n").string();
  for (const char* score : {"ap", "tracking"}) {
    const ProcessResult result =
        RunProgram({"eval", "boxes", "--labels", labels, "--estimate", in_3d, "--score", score});
    EXPECT_THAT(result.out, AllOf(HasSubstr("no detection has a box in the image"),
                                  testing::ContainsRegex("3d +(11 +|)100.00 ")));
    ExpectError(
        RunProgram({"eval", "boxes", "--labels", vans, "--estimate", rows, "--score", score}),
        "vans.txt: found labels: 1 Vans, expected at least one of Car", 1);
  }
  for (const Arguments& wrong : {Arguments{"--iou", "1.5"},
                                 {"--class", "Tram"},
                                 {"--sequence", tiny()},
                                 {"--frames", "4:"},
                                 {"--score", "hota"}}) {
    ExpectError(run(wrong), wrong[0], 2);
  }
  ExpectError(run({"--score", "tracking", "--iou", "0.5"}), "--iou", 2);
  // Track 1 of another sequence is another body: its track 2 is no switch of identity.
  const std::string other = folder_.Write("other", "0 2" + row.substr(3) + " 0.5\n").string();
  const Arguments two = {"eval", "boxes", "--labels", labels, labels, "--estimate", rows};
  EXPECT_THAT(RunProgram(With(two, {other, "--score", "tracking"})).out,
              testing::ContainsRegex("2 frames(.|\n)*3d +100.00 .*100.00 "));
  ExpectError(RunProgram(With(two, {labels})), "of all or of none", 2);
  ExpectError(RunProgram(two), "--estimate: 1 given, expected 2", 2);
  ExpectError(RunProgram({"eval", "boxes", "--estimate", rows}), "--labels", 2);
  ExpectError(Evaluate({poses(), "--iou", "0.5"}), "--iou", 2);
  ExpectError(RunProgram({"eval", "boxes", "--score", "tracking", "--labels", Path("tiny"),
                          "--estimate", Path("tiny")}),
              "");
}

}  // namespace
}  // namespace cvo::eval_test
