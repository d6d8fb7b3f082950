// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files/images/image_file.h"
#include "core/files/json/json.h"
#include "tests/experiments/cli/process.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/support/temp_folder.h"

namespace cvo::cli_test {
namespace {

namespace fs = std::filesystem;
using test::ProcessResult;
using test::RunProgram;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

// Command-line interface: messages and exit codes, mostly without running an estimator.

MATCHER_P2(FailsWith, exit_code, text, "") {
  const ProcessResult& result = arg;
  *result_listener << "exit code " << result.exit_code << ", stderr: " << result.err;
  return result.exit_code == exit_code && result.err.starts_with("clustervo: error: ") &&
         test::LineCount(result.err) == 1 && result.err.find(text) != std::string::npos &&
         result.out.empty();
}

class Cli : public testing::Test {
 protected:
  Cli() { test::WriteTinySequence(tiny(), 3); }

  std::string tiny() const { return (folder_.path() / "tiny").string(); }
  std::string out() const { return (folder_.path() / "out").string(); }

  // Expects a run to leave no output folder, for runs that must fail before the first frame.
  ProcessResult FailingRun(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"run", tiny(), "-o", out()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProcessResult result = RunProgram(arguments);
    EXPECT_FALSE(fs::exists(out()));
    return result;
  }

  test::TempFolder folder_;
};

// Every start would load it if the program were linked with it.
TEST(CliStart, LoadsNoLibraryForOpenGl) {
  const ProcessResult loaded =
      RunProgram({"--version"}, {.environment = {"LD_TRACE_LOADED_OBJECTS=1"}});
  EXPECT_THAT(loaded.out, AllOf(HasSubstr("libopencv_core"), Not(HasSubstr("libOSMesa"))));
}

TEST_F(Cli, WrongUsage) {
  for (const std::vector<std::string>& group : {std::vector<std::string>{}, {"synth"}}) {
    const ProcessResult none = RunProgram(group);
    EXPECT_EQ(none.exit_code, 2);
    EXPECT_THAT(none.err, AllOf(HasSubstr("Usage: clustervo"), HasSubstr("Subcommands:")));
  }
  EXPECT_THAT(RunProgram({"runn"}), FailsWith(2, "did you mean run"));
  EXPECT_THAT(RunProgram({"rnu"}), FailsWith(2, "did you mean run?) (see clustervo --help)"));
  EXPECT_THAT(RunProgram({"synth", "chek"}),
              FailsWith(2, "did you mean check?) (see clustervo synth --help)"));
  EXPECT_THAT(RunProgram({"manual", "bsh"}),
              FailsWith(2, "WHAT: found \"bsh\" (did you mean bash, zsh?), expected one of man, "));
  EXPECT_THAT(
      RunProgram({"info", tiny(), "more"}),
      FailsWith(2, "clustervo info: unexpected argument \"more\" (see clustervo info --help)"));
  EXPECT_THAT(FailingRun({"--zzzzzzzzzz"}), FailsWith(2, "clustervo run has no flag --zzzzzzzzzz"));
  EXPECT_THAT(RunProgram({"walk"}), FailsWith(2, "\"walk\", expected one of run, detect, "));
  EXPECT_THAT(RunProgram({"run", tiny()}), FailsWith(2, "--output"));
  EXPECT_THAT(RunProgram({"run", "-o", out()}), FailsWith(2, "no sequence"));
  EXPECT_THAT(RunProgram({"run"}), FailsWith(2, "no sequence: give a folder, or --left, "));
  EXPECT_THAT(RunProgram({"run", tiny(), "-o", ""}),
              FailsWith(2, "--output: found an empty name, expected "));
  EXPECT_THAT(FailingRun({"--no-such-option"}), FailsWith(2, "--no-such-option"));
  EXPECT_THAT(FailingRun({"--threads", "0"}), FailsWith(2, "--threads"));
  EXPECT_THAT(FailingRun({"--threads", "2x"}), FailsWith(2, "--threads"));
  EXPECT_THAT(FailingRun({"--seed", "-1"}), FailsWith(2, "--seed"));
  EXPECT_THAT(FailingRun({"--min-score", "nan"}), FailsWith(2, "--min-score"));
}

// Spellings of version 0.2 get one line that names the present ones.
TEST_F(Cli, FormerSpellingsNameThePresentOnes) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> former = {
      {{"variants"}, "list variants"},
      {{"options", "--json"}, "list options"},
      {{"synth", "list"}, "list scenes"},
      {{"synth", "generate", "room", "--seed", "3"}, "synth render FAMILY@SEED"},
      {{"experiment", "list"}, "list suites"},
      {{"experiment", "plan", "ci", "-o", "x"}, "experiment status SUITE -o DIR"},
      {{"experiment", "times", "x"}, "experiment table --times"},
      {{"compare", "a", "b"}, "experiment compare"},
      {{"figures", "a", "-o", "x"}, "plot DIR"},
      {{"eval", "--groundtruth", "a", "--estimate", "b"}, "eval trajectory, eval boxes or eval"}};
  for (const auto& [arguments, present] : former) {
    EXPECT_THAT(RunProgram(arguments), FailsWith(2, ", now clustervo " + present));
  }
}

TEST_F(Cli, HelpHidesTheManualAndSingleJobs) {
  EXPECT_THAT(RunProgram({"--help"}).out, Not(HasSubstr("\n  manual ")));
  EXPECT_THAT(RunProgram({"experiment", "--help"}).out, Not(HasSubstr("\n  job ")));
  EXPECT_EQ(RunProgram({"manual", "bash"}).exit_code, 0);
  EXPECT_EQ(RunProgram({"experiment", "job", "--help"}).exit_code, 0);
}

TEST_F(Cli, UnknownVariant) {
  EXPECT_THAT(FailingRun({"--variant", "statik"}),
              FailsWith(2, "found \"statik\" (did you mean static?), expected one of those"));
  EXPECT_THAT(FailingRun({"--variant", "nothing_like"}), FailsWith(2, "expected one of full, "));
}

TEST_F(Cli, SuggestsSimilarNames) {
  EXPECT_THAT(FailingRun({"--varient", "full"}),
              FailsWith(2,
                        "clustervo run has no flag --varient (did you mean --variant?) (see "
                        "clustervo run --help)"));
  EXPECT_THAT(
      RunProgram({"experiment", "run", "ci", "--outptu=x"}),
      FailsWith(2, "clustervo experiment run has no flag --outptu (did you mean --output?"));
  EXPECT_THAT(FailingRun({"--oracle", "boxs"}), FailsWith(2, "did you mean boxes?"));
  EXPECT_THAT(FailingRun({"--type", "kitti-odometri"}),
              FailsWith(2, "did you mean kitti-odometry"));
  EXPECT_THAT(FailingRun({"--detections", "lables"}), FailsWith(2, "did you mean labels?"));
  EXPECT_THAT(FailingRun({"--pair", "gray"}), FailsWith(2, "did you mean grey?"));
  EXPECT_THAT(FailingRun({"--dataset", "kiti"}), FailsWith(2, "did you mean kitti?"));
  const auto sequence = [this](const std::string& name) {
    return RunProgram({"run", (folder_.path() / name).string(), "-o", out()});
  };
  EXPECT_THAT(sequence("indoor_1"), FailsWith(2, "`clustervo synth render indoor_1 -o "));
  EXPECT_THAT(sequence("room@7"), FailsWith(2, "`clustervo synth render room@7 -o "));
  EXPECT_THAT(sequence("oclusion_2"), FailsWith(2, "did you mean occlusion_2?"));
  EXPECT_THAT(sequence("tin"), FailsWith(2, "did you mean tiny?"));
  const auto other = [this](std::vector<std::string> command) {
    command.insert(command.end(), {"-o", out()});
    return RunProgram(command);
  };
  EXPECT_THAT(other({"synth", "render", "indor_1"}), FailsWith(2, "did you mean indoor_1, "));
  EXPECT_THAT(other({"synth", "render", "romm@17"}), FailsWith(2, "did you mean room?"));
  EXPECT_THAT(other({"synth", "render", "room@3,mover=3"}), FailsWith(2, "did you mean movers?"));
  EXPECT_THAT(other({"experiment", "run", "ablaton"}), FailsWith(2, "did you mean ablation?"));
}

TEST_F(Cli, AFolderOfSequencesIsNoSequence) {
  test::WriteTinySequence(folder_.path() / "all" / "a", 2);
  test::WriteTinySequence(folder_.path() / "all" / "b", 2);
  const std::string all = (folder_.path() / "all").string();
  EXPECT_THAT(RunProgram({"run", all, "-o", out()}),
              FailsWith(1,
                        "all: found a folder that contains 2 sequences, expected one of them: "
                        "`clustervo info " +
                            all + "` lists them"));
}

// Classes that occur in the boxes are valid names too. Known classes may be absent from a whole
// sequence.
TEST_F(Cli, MisspeltClasses) {
  const std::string boxes =
      folder_.Write("boxes.txt", "0 3 Forklift -1 -1 -10 10 10 60 60 -1 -1 -1 -1 -1 -1 -10 0.5\n")
          .string();
  const auto classes = [&](const std::string& names) {
    return FailingRun({"--detections", boxes, "--classes", names});
  };
  EXPECT_THAT(classes("Car,Vann"), FailsWith(2, "--classes: found \"Vann\" (did you mean Van?)"));
  EXPECT_THAT(classes("Forklft"), FailsWith(2, "(did you mean Forklift?)"));
  EXPECT_EQ(RunProgram({"run", tiny(), "-o", out(), "-q", "--detections", boxes, "--classes",
                        "car,FORKLIFT,Zebra"})
                .exit_code,
            0);
}

TEST_F(Cli, UnknownOption) {
  EXPECT_THAT(FailingRun({"--set", "orb.feature=5"}), FailsWith(2, "did you mean orb.features"));
  EXPECT_THAT(FailingRun({"--set", "orb.features=many"}), FailsWith(2, "expected an integer"));
  EXPECT_THAT(FailingRun({"--set", "orb.features=1"}), FailsWith(2, "orb.features"));
}

TEST_F(Cli, BadConfiguration) {
  const auto config = [this](const char* json) {
    return FailingRun({"--config", folder_.Write("config.json", json).string()});
  };
  EXPECT_THAT(config(R"({"orb": {"feature": 5}})"), FailsWith(1, "unknown option orb.feature"));
  EXPECT_THAT(config(R"({"orb": {"features": "5"}})"), FailsWith(1, "option orb.features"));
  EXPECT_THAT(config("{\n\"orb\": "),
              FailsWith(1, "config.json: found text that ends after 9 bytes, at line 2"));
  EXPECT_THAT(FailingRun({"--config", "/no/such/file"}), FailsWith(1, "/no/such/file"));
}

TEST_F(Cli, BadSequence) {
  EXPECT_THAT(RunProgram({"run", "/no/such/folder", "-o", out()}), FailsWith(2, "/no/such/folder"));
  EXPECT_THAT(FailingRun({"--type", "bundler"}), FailsWith(2, "bundler"));
  const std::string file = folder_.Write("sheet.png", "").string();
  EXPECT_THAT(RunProgram({"run", file, "-o", out()}),
              FailsWith(1, "sheet.png: found a file, expected the folder of a sequence"));
  for (const char* flag : {"--labels", "--config", "--detections"}) {
    EXPECT_THAT(FailingRun({flag, tiny()}),
                FailsWith(2, std::string(flag) + ": found the folder " + tiny()));
  }
  EXPECT_THAT(FailingRun({"--frames", "5:9"}), FailsWith(2, ""));
  EXPECT_THAT(FailingRun({"--frames", "2"}), FailsWith(2, ""));
  fs::remove(fs::path(tiny()) / "image_1" / "000001.png");
  EXPECT_THAT(FailingRun({}), FailsWith(1, "image"));
}

TEST_F(Cli, UnwritableOutput) {
  const std::string file = folder_.Write("file", "mine").string();
  EXPECT_THAT(RunProgram({"run", tiny(), "-o", file}), FailsWith(1, file));
  EXPECT_THAT(RunProgram({"run", tiny(), "-o", file + "/out"}), FailsWith(1, file));
  EXPECT_EQ(test::ReadFile(file), "mine");
  EXPECT_THAT(RunProgram({"run", tiny(), "-o", "/proc/out"}), FailsWith(1, "/proc/out"));
}

// Without AVX2 all stages run their portable code, whose results differ only by rounding.
TEST_F(Cli, WithoutAvx2ResultsAgreeAndTheLevelIsReported) {
  const auto run = [&](const std::string& folder, const test::ProcessSetup& setup) {
    const ProcessResult result = RunProgram({"run", tiny(), "-o", folder}, setup);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return ParseJson(test::ReadFile(fs::path(folder) / "result.json"), "result");
  };
  const Json plain = run(out(), {.environment = {"OPENCV_CPU_DISABLE=AVX2"}});
  const Json any = run(out() + "2", {});
  EXPECT_THAT(plain["build"]["cpu_level"].get<std::string>(), testing::StartsWith("plain"));
  ASSERT_EQ(plain["frames"].size(), any["frames"].size());
  for (std::size_t k = 0; k < any["frames"].size(); ++k) {
    EXPECT_EQ(plain["frames"][k]["features"], any["frames"][k]["features"]);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(plain["frames"][k]["refined"][i], any["frames"][k]["refined"][i], 1e-6);
    }
  }
}

TEST_F(Cli, HelpAndVersion) {
  for (const char* command : {"run", "eval", "info", "list", "experiment"}) {
    const ProcessResult help = RunProgram({command, "--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_THAT(help.err, IsEmpty());
    EXPECT_THAT(help.out, HasSubstr("Usage: clustervo " + std::string(command)));
  }
  const ProcessResult version = RunProgram({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_THAT(version.out,
              AllOf(StartsWith("clustervo "), HasSubstr("OpenCV"), HasSubstr("build")));
}

TEST_F(Cli, ListsOptionsAndVariants) {
  const ProcessResult options = RunProgram({"list", "options", "--json"});
  ASSERT_EQ(options.exit_code, 0);
  for (const Json& option : ParseJson(options.out, "options")) {
    for (const char* field :
         {"path", "type", "unit", "min", "max", "default", "meaning", "source"}) {
      EXPECT_TRUE(option.contains(field)) << option["path"] << " " << field;
    }
  }
  EXPECT_THAT(RunProgram({"list", "options"}).out, HasSubstr("orb.features"));
  const ProcessResult variants = RunProgram({"list", "variants", "--json"});
  EXPECT_EQ(ParseJson(variants.out, "variants")[0]["name"], "full");
}

TEST_F(Cli, InfoDescribesAFolder) {
  const ProcessResult info = RunProgram({"info", tiny(), "--json", "--frames", "1:3"});
  ASSERT_EQ(info.exit_code, 0) << info.err;
  const Json json = ParseJson(info.out, "info");
  EXPECT_EQ(json["type"], "kitti-odometry");
  EXPECT_EQ(json["frames"], 2);
  EXPECT_EQ(json["total_frames"], 3);
  EXPECT_EQ(json["first_frame"], 1);
  EXPECT_EQ(json["groundtruth"], "official");
  EXPECT_NEAR(json["median_rate_hz"].get<double>(), 10.0, 1e-9);
  EXPECT_EQ(json["camera"]["width_px"], test::kTinyWidth_px);
  EXPECT_LT(json["rows"]["median_row_error_px"].get<double>(), 0.5);
  EXPECT_NEAR(json["rows"]["median_disparity_px"].get<double>(), 10.0, 0.5);
  fs::create_directory(fs::path(tiny()) / "detections");
  folder_.Write("tiny/detections/poor.txt", "");
  const std::string picture = (folder_.path() / "rows.png").string();
  EXPECT_THAT(
      RunProgram({"info", tiny(), "--picture", picture}).out,
      AllOf(HasSubstr("baseline 0.5 m"), HasSubstr("10 Hz, duration 0.2 s"),
            HasSubstr("0 boxes; --detections has poor"), testing::ContainsRegex("row error +0")));
  EXPECT_EQ(ReadImageFile(picture, cv::IMREAD_COLOR).size(),
            cv::Size(2 * test::kTinyWidth_px, test::kTinyHeight_px));
  EXPECT_THAT(RunProgram({"info", tiny(), "--picture", "rows.gif"}), FailsWith(2, ".png"));
}

TEST_F(Cli, InfoListsTheSequencesBelowAFolder) {
  test::WriteTinySequence(folder_.path() / "another", 1);
  const ProcessResult info = RunProgram({"info", folder_.path().string()});
  EXPECT_EQ(info.exit_code, 0);
  EXPECT_THAT(info.out, AllOf(HasSubstr(tiny()), HasSubstr("another")));
  EXPECT_THAT(RunProgram({"info", "/no/such/folder"}), FailsWith(2, "/no/such/folder"));
  fs::create_directory(folder_.path() / "empty");
  EXPECT_THAT(RunProgram({"info", (folder_.path() / "empty").string()}), FailsWith(1, "empty"));
}

class Eval : public Cli {
 protected:
  std::string Write(const std::string& name, const std::string& content) const {
    return folder_.Write(name, content).string();
  }
  static ProcessResult Evaluate(const std::string& truth, const std::string& estimate,
                                const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"eval", "trajectory", "--groundtruth",
                                          truth,  "--estimate", estimate};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunProgram(arguments);
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
  EXPECT_THAT(Evaluate(truth, estimate, {"--max-time-difference", "0.0001"}),
              FailsWith(1, "found 0 poses that match"));
  EXPECT_EQ(Evaluate(truth, estimate).err, "");
  const std::string other = Write("other.tum",
                                  "0.1 1 0 0 0 0 0 1\n0.2 2 0 1 0 0 0 1\n7 3 1 1 0 0 0 1\n"
                                  "8 0 0 0 0 0 0 1\n9 0 0 0 0 0 0 1\n");
  EXPECT_THAT(Evaluate(truth, other).err, HasSubstr("note: only 2 of 5 poses of "));
}

TEST_F(Eval, ReadsKittiPosesLineByLine) {
  const std::string truth = (fs::path(tiny()) / "poses.txt").string();
  const ProcessResult same = Evaluate(truth, truth, {"--json"});
  ASSERT_EQ(same.exit_code, 0) << same.err;
  const Json evaluation = ParseJson(same.out, "evaluation");
  for (const Json& metric : evaluation["metrics"]) {
    if (metric["name"] == "camera_ate") {
      EXPECT_LT(metric["value"].get<double>(), 1e-9);
    }
  }
  const std::string shorter = Write("short.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  EXPECT_THAT(Evaluate(truth, shorter), FailsWith(1, "found 1 poses, expected 3"));
}

TEST_F(Eval, BadTrajectories) {
  const std::string good = Write("good.tum", "0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n");
  const auto bad = [&](const std::string& text) { return Evaluate(good, Write("bad.tum", text)); };
  EXPECT_THAT(bad("0 0 0 0 0 0 0 1\n1 nan 0 0 0 0 0 1\n"), FailsWith(1, "bad.tum:2"));
  EXPECT_THAT(bad("1 0 0 0 0 0 0 1\n0 1 0 0 0 0 0 1\n"), FailsWith(1, "bad.tum:2"));
  EXPECT_THAT(bad("# no pose\n"), FailsWith(1, "bad.tum"));
  EXPECT_THAT(bad("1 2 3\n"), FailsWith(1, "bad.tum:1"));
  EXPECT_THAT(bad("1 0 0 0 0 1 0 0 0 0 1 0\n"), FailsWith(1, "kitti format"));
  EXPECT_THAT(Evaluate(good, "/no/such/file"), FailsWith(1, "/no/such/file"));
  EXPECT_THAT(Evaluate(good, good, {"--format", "euroc"}), FailsWith(2, "--format"));
  EXPECT_THAT(Evaluate(good, good, {"--max-time-difference", "nan"}),
              FailsWith(2, "--max-time-difference"));
}

}  // namespace
}  // namespace cvo::cli_test
