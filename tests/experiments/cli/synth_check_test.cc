// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// `clustervo synth list` and `check`, which need no renderer.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files/json/json.h"
#include "core/files/text_file.h"
#include "tests/experiments/cli/process.h"
#include "tests/experiments/datasets/scene_check/rays.h"
#include "tests/support/temp_folder.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using test::ProcessResult;
using test::RunProgram;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(CliSynth, ListsTheShippedScenes) {
  const ProcessResult list = RunProgram({"list", "scenes"});
  EXPECT_EQ(list.exit_code, 0) << list.err;
  EXPECT_THAT(list.out, AllOf(HasSubstr("movers"), HasSubstr("tiny"), HasSubstr("640x480")));
}

TEST(CliSynth, ListsTheKnobsOfAFamily) {
  EXPECT_THAT(RunProgram({"list", "scenes", "room"}).out, HasSubstr("speed_mps"));
  const ProcessResult wrong = RunProgram({"list", "scenes", "rom"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("did you mean room?"));
}

TEST(CliSynth, RefusesWrongSeedsAndKnobs) {
  const test::TempFolder folder;
  const auto render = [&](const std::string& scene) {
    return RunProgram({"synth", "render", scene, "-o", (folder.path() / "set").string()});
  };
  for (const char* seed : {"-1", "4294967296", "x"}) {
    const ProcessResult wrong = render(std::string("room@") + seed);
    EXPECT_EQ(wrong.exit_code, 2) << seed;
    EXPECT_THAT(wrong.err, HasSubstr("an integer from 0 to 4294967295"));
  }
  const ProcessResult wrong = render("room@17,mover=2");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("no knob \"mover\""));
  EXPECT_FALSE(fs::exists(folder.path() / "set"));
}

TEST(CliSynth, AMisspeltCommandIsWrongUsage) {
  const ProcessResult run = RunProgram({"synth", "chek"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("no subcommand \"chek\" (did you mean check?)"));
  EXPECT_THAT(RunProgram({"synth"}).err, HasSubstr("Usage: clustervo synth"));
  EXPECT_THAT(RunProgram({"synth", "check"}).err, HasSubstr("see clustervo synth check --help"));
}

class CliSynthCheck : public testing::Test {
 protected:
  CliSynthCheck() { test::WriteRayScene(rays()); }
  fs::path rays() const { return folder_.path() / "rays"; }
  fs::path json() const { return folder_.path() / "check.json"; }

  test::TempFolder folder_;
};

TEST_F(CliSynthCheck, PrintsAndWritesItsResults) {
  const ProcessResult run =
      RunProgram({"synth", "check", rays().string(), "--json", json().string(), "--threads", "2"});
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("disparity_offset"), HasSubstr("passed"), Not(HasSubstr("FAILED"))));
  const Json report = ReadJson(json());
  EXPECT_EQ(report["passed"], true);
  EXPECT_EQ(report["frames"], test::RayScene::kFrames);
}

TEST_F(CliSynthCheck, FailsOnDisagreement) {
  WriteFileBytes(rays() / "poses_right.txt", ReadFileBytes(rays() / "poses.txt"));
  const ProcessResult run =
      RunProgram({"synth", "check", rays().string(), "--json", json().string()});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.out, AllOf(HasSubstr("poses_right.txt"), HasSubstr("FAILED")));
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(ReadJson(json())["passed"], false);
}

TEST_F(CliSynthCheck, AFolderWithoutASceneIsBadInput) {
  const ProcessResult run = RunProgram({"synth", "check", folder_.path().string()});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("no objects.csv"));
  EXPECT_EQ(test::LineCount(run.err), 1U);
}

}  // namespace
}  // namespace cvo
