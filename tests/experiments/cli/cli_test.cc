// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Command-line interface: messages and exit codes, mostly without running an estimator.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files/json/json.h"
#include "tests/experiments/cli/process.h"

namespace cvo::cli_test {
namespace {

namespace fs = std::filesystem;
using test::Arguments;
using test::ExpectError;
using test::ProcessResult;
using test::RunProgram;
using test::With;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

struct Wrong {
  Arguments arguments;
  std::string message;  // a part of it
  int exit_code = 2;
};

class Cli : public test::TinyTest {
 protected:
  // Runs that must fail before the first frame, without an output folder.
  void ExpectNoRun(const std::vector<Wrong>& cases) const {
    for (const auto& [more, message, code] : cases) {
      ExpectError(RunProgram(With({"run", tiny(), "-o", out()}, more)), message, code);
      EXPECT_FALSE(fs::exists(out())) << message;
    }
  }
  static void ExpectErrors(const std::vector<Wrong>& cases) {
    for (const auto& [arguments, message, code] : cases) {
      ExpectError(RunProgram(arguments), message, code);
    }
  }
};

// Every start would load it if the program were linked with it.
TEST(CliStart, LoadsNoLibraryForOpenGl) {
  const ProcessResult loaded =
      RunProgram({"--version"}, {.environment = {"LD_TRACE_LOADED_OBJECTS=1"}});
  EXPECT_THAT(loaded.out, AllOf(HasSubstr("libopencv_core"), Not(HasSubstr("libOSMesa"))));
}

TEST_F(Cli, WrongUsage) {
  for (const Arguments& group : {Arguments{}, {"synth"}}) {
    const ProcessResult none = RunProgram(group);
    EXPECT_EQ(none.exit_code, 2);
    EXPECT_THAT(none.err, AllOf(HasSubstr("Usage: clustervo"), HasSubstr("Subcommands:")));
  }
  ExpectErrors(
      {{{"runn"}, "did you mean run"},
       {{"rnu"}, "did you mean run?) (see clustervo --help)"},
       {{"synth", "chek"}, "did you mean check?) (see clustervo synth --help)"},
       {{"synth", "check"}, "see clustervo synth check --help"},
       {{"list", "suits"}, "WHAT: found \"suits\" (did you mean suites?), expected one of var"},
       {{"info", tiny(), "more"},
        "clustervo info: unexpected argument \"more\" (see clustervo info"},
       {{"walk"}, "\"walk\", expected one of run, detect, "},
       {{"run", "-o", out()}, "no sequence"},
       {{"run"}, "no sequence: give a folder, or --left, "},
       {{"run", tiny(), "-o", ""}, "--output: found an empty name, expected "}});
  ExpectNoRun({{{"--zzzzzzzzzz"}, "clustervo run has no flag --zzzzzzzzzz"},
               {{"--no-such-option"}, "--no-such-option"},
               {{"--threads", "0"}, "--threads"},
               {{"--threads", "2x"}, "--threads"},
               {{"--seed", "-1"}, "--seed"},
               {{"--min-score", "nan"}, "--min-score"}});
}

// Spellings of version 0.2 get one line that names the present ones.
TEST_F(Cli, FormerSpellingsNameThePresentOnes) {
  const std::vector<Wrong> former = {
      {{"variants"}, "list variants"},
      {{"options"}, "list options"},
      {{"synth", "list"}, "list scenes"},
      {{"synth", "generate", "room", "--seed", "3"}, "synth render FAMILY@SEED"},
      {{"experiment", "list"}, "list suites"},
      {{"experiment", "plan", "ci", "-o", "x"}, "experiment run SUITE -o DIR --dry-run"},
      {{"experiment", "status", "x"}, "experiment table DIR"},
      {{"synth", "preview", "x"}, "synth render SCENE -o FILE --preview"},
      {{"import", "-o", "x"}, "info --left L"},
      {{"experiment", "times", "x"}, "experiment table --times"},
      {{"compare", "a", "b"}, "experiment compare"},
      {{"figures", "a", "-o", "x"}, "plot DIR"},
      {{"eval", "--groundtruth", "a", "--estimate", "b"}, "eval trajectory or eval boxes"}};
  for (const Wrong& one : former) {
    ExpectError(RunProgram(one.arguments), ", now clustervo " + one.message, 2);
  }
}

TEST_F(Cli, HelpHidesSingleJobs) {
  EXPECT_THAT(RunProgram({"experiment", "--help"}).out, Not(HasSubstr("\n  job ")));
  EXPECT_EQ(RunProgram({"experiment", "job", "--help"}).exit_code, 0);
}

TEST_F(Cli, SuggestsSimilarNames) {
  ExpectNoRun(
      {{{"--variant", "statik"}, "found \"statik\" (did you mean static?), expected one of full"},
       {{"--variant", "nothing_like"}, "expected one of full, "},
       {{"--varient", "full"},
        "clustervo run has no flag --varient (did you mean --variant?) (see clustervo run --help)"},
       {{"--oracle", "boxs"}, "did you mean boxes?"},
       {{"--type", "kitti-odometri"}, "did you mean kitti-odometry"},
       {{"--detections", "lables"}, "did you mean labels?"},
       {{"--pair", "gray"}, "did you mean grey?"},
       {{"--set", "orb.feature=5"}, "did you mean orb.features"},
       {{"--set", "orb.features=many"}, "expected an integer"},
       {{"--set", "orb.features=1"}, "orb.features"}});
  ExpectErrors({{{"experiment", "run", "ci", "--outptu=x"},
                 "clustervo experiment run has no flag --outptu (did you mean --output?"},
                {{"run", Path("indoor_1"), "-o", out()}, "`clustervo synth render indoor_1 -o "},
                {{"run", Path("room@7"), "-o", out()}, "`clustervo synth render room@7 -o "},
                {{"run", Path("oclusion_2"), "-o", out()}, "did you mean occlusion_2?"},
                {{"run", Path("tin"), "-o", out()}, "did you mean tiny?"},
                {{"synth", "render", "indor_1", "-o", out()}, "did you mean indoor_1, "},
                {{"synth", "render", "romm@17", "-o", out()}, "did you mean room?"},
                {{"synth", "render", "room@3,mover=3", "-o", out()}, "did you mean movers?"},
                {{"list", "scenes", "rom"}, "did you mean room?"},
                {{"experiment", "run", "ablaton", "-o", out()}, "did you mean ablation?"}});
}

// Classes that occur in the boxes are valid names too. Known classes may be absent from a whole
// sequence.
TEST_F(Cli, MisspeltClasses) {
  const std::string boxes =
      folder_.Write("boxes.txt", "0 3 Forklift -1 -1 -10 10 10 60 60 -1 -1 -1 -1 -1 -1 -10 0.5\n")
          .string();
  ExpectNoRun({{{"--detections", boxes, "--classes", "Car,Vann"},
                "--classes: found \"Vann\" (did you mean Van?)"},
               {{"--detections", boxes, "--classes", "Forklft"}, "(did you mean Forklift?)"}});
  EXPECT_EQ(RunProgram({"run", tiny(), "-o", out(), "-q", "--detections", boxes, "--classes",
                        "car,FORKLIFT,Zebra"})
                .exit_code,
            0);
}

TEST_F(Cli, BadConfiguration) {
  ExpectNoRun({{{"--config", "/no/such/file"}, "/no/such/file", 1}});
  for (const auto& [json, message] : std::vector<std::pair<const char*, const char*>>{
           {R"({"orb": {"feature": 5}})", "unknown option orb.feature"},
           {R"({"orb": {"features": "5"}})", "option orb.features"},
           {"{\n\"orb\": ", "config.json: found text that ends after 9 bytes, at line 2"}}) {
    ExpectNoRun({{{"--config", folder_.Write("config.json", json).string()}, message, 1}});
  }
}

TEST_F(Cli, BadSequence) {
  const std::string file = folder_.Write("sheet.png", "").string();
  test::WriteTinySequence(Path("all/a"), 2);
  test::WriteTinySequence(Path("all/b"), 2);
  ExpectErrors({{{"run", "/no/such/folder", "-o", out()}, "/no/such/folder"},
                {{"info", "/no/such/folder"}, "/no/such/folder"},
                {{"run", file, "-o", out()},
                 "sheet.png: found a file, expected the folder of a sequence",
                 1},
                {{"run", Path("all"), "-o", out()},
                 "all: found a folder that contains 2 sequences, expected one of them: `clustervo "
                 "info " +
                     Path("all") + "` lists them",
                 1}});
  for (const std::string flag : {"--labels", "--config", "--detections"}) {
    ExpectNoRun({{{flag, tiny()}, tiny() + ": found a folder, expected ", 1}});
  }
  ExpectNoRun(
      {{{"--type", "bundler"}, "bundler"}, {{"--frames", "5:9"}, ""}, {{"--frames", "2"}, ""}});
  fs::remove(Path("tiny/image_1/000001.png"));
  ExpectNoRun({{{}, "image", 1}});
}

TEST_F(Cli, UnwritableOutput) {
  const std::string file = folder_.Write("file", "mine").string();
  ExpectErrors({{{"run", tiny(), "-o", file}, file, 1},
                {{"run", tiny(), "-o", file + "/out"}, file, 1},
                {{"run", tiny(), "-o", "/proc/out"}, "/proc/out", 1}});
  EXPECT_EQ(test::ReadFile(file), "mine");
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
  EXPECT_THAT(RunProgram({"list", "options"}).out, HasSubstr("orb.features"));
  EXPECT_THAT(RunProgram({"list", "variants"}).out, testing::ContainsRegex("name .*\nfull "));
  EXPECT_THAT(RunProgram({"list", "metrics"}).out, HasSubstr("camera_ate "));
}

TEST_F(Cli, InfoDescribesAFolder) {
  folder_.Write("tiny/detections/poor.txt", "");
  const ProcessResult info = RunProgram({"info", tiny(), "--frames", "1:3"});
  ASSERT_EQ(info.exit_code, 0) << info.err;
  for (const char* line :
       {"type +kitti-odometry", "frames +2 .1 to 2 of 3.", "rate +10 Hz, duration 0.1 s",
        "baseline 0.5 m", "row error +0", "median disparity (9[.]|10)",
        "ground truth +official, 2 ", "detections +0 boxes; --detections has poor"}) {
    EXPECT_THAT(info.out, testing::ContainsRegex(line));
  }
}

TEST_F(Cli, InfoListsTheSequencesBelowAFolder) {
  test::WriteTinySequence(Path("another"), 1);
  const ProcessResult info = RunProgram({"info", folder_.path().string()});
  EXPECT_EQ(info.exit_code, 0);
  EXPECT_THAT(info.out, AllOf(HasSubstr(tiny()), HasSubstr("another")));
  fs::create_directory(Path("empty"));
  ExpectErrors({{{"info", Path("empty")}, "empty", 1}});
}

}  // namespace
}  // namespace cvo::cli_test
