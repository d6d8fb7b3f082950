// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// `clustervo synth` as processes: render and preview, on the scene made for tests, and check.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "core/files/json/json.h"
#include "core/files/sha256.h"
#include "core/files/text_file.h"
#include "experiments/datasets/formats/scene_truth.h"
#include "experiments/datasets/sequence.h"
#include "experiments/metrics/trajectory.h"
#include "tests/experiments/cli/process.h"
#include "tests/experiments/datasets/scene_check/rays.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using test::Arguments;
using test::ExpectError;
using test::ProcessResult;
using test::RunProgram;
using test::With;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

constexpr int kFrames = 6;

// Golden images of scene "tiny", by version of Mesa and LLVM, as other versions round differently:
// the SHA-256 of the concatenated hashes in the manifest.
const std::map<std::string, std::string>& GoldenHashes() {
  static const std::map<std::string, std::string> hashes = {
      {"4.5 (Core Profile) Mesa 22.3.6, llvmpipe (LLVM 15.0.6, 256 bits)",
       "d384855d0af353ec932b11646acb149ee9e561cdf342d3de7032e9253ddbfc97"}};
  return hashes;
}

class CliSynthRender : public test::CommandTest {
 protected:
  fs::path out(const std::string& name) const { return Path(name); }
  // Renders into "tiny". Skips the test if this build cannot render.
  void RenderTiny(const Arguments& more = {}) const {
    const ProcessResult render = Render("tiny", more);
    if (render.err.find("no OSMesa") != std::string::npos) GTEST_SKIP() << render.err;
    ASSERT_EQ(render.exit_code, 0) << render.err;
  }
  // Renders into the cache of this name; a new name renders everything again.
  ProcessResult Render(const std::string& name, const Arguments& more,
                       const std::string& cache = "cache", test::ProcessSetup setup = {}) const {
    setup.environment = {"CLUSTERVO_CACHE=" + Path(cache)};
    return RunProgram(With({"synth", "render", "tiny", "-o", Path(name)}, more), setup);
  }
  // Returns the SHA-256 of every file of a rendered scene, by name.
  std::map<std::string, std::string> HashesOf(const std::string& name) const {
    std::map<std::string, std::string> hashes;
    const Json manifest = ReadJson(out(name) / "manifest.json");
    for (const Json& file : manifest["files"]) {
      hashes[file["name"]] = file["sha256"];
    }
    return hashes;
  }
};

TEST_F(CliSynthRender, PassesItsCheck) {
  RenderTiny({"-q"});
  if (IsSkipped() || HasFatalFailure()) return;
  const ProcessResult check = RunProgram({"synth", "check", out("tiny").string()});
  EXPECT_EQ(check.exit_code, 0) << check.out << check.err;
  EXPECT_THAT(check.out, HasSubstr("mask_point_out_of_box"));
}

TEST_F(CliSynthRender, ARunOnItScoresItsBodies) {
  RenderTiny({"--frames", "0:3", "-q"});
  if (IsSkipped() || HasFatalFailure()) return;
  const ProcessResult run =
      RunProgram({"run", out("tiny").string(), "-o", out("out").string(), "--detections", "good",
                  "--oracle", "camera,labels,boxes", "--landmarks", "--all", "-q"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("detections: "), HasSubstr("object_standing_coverage"),
                             HasSubstr("bodies, refined poses"), HasSubstr("chair_1")));
  const Json result = ReadJson(out("out") / "result.json");
  EXPECT_EQ(result["given"]["oracle"], Json::array({"boxes", "labels", "camera"}));
  ASSERT_EQ(result["bodies"]["refined"].size(), 3U);
  EXPECT_EQ(result["bodies"]["causal"][1]["name"], "chair_1");
  EXPECT_EQ(result["bodies"]["refined"][1]["visible_frames"], 3);
  EXPECT_GT(result["detection_counts"]["given"], 0);
}

TEST_F(CliSynthRender, IsReadAsAKittiSequence) {
  RenderTiny();
  if (IsSkipped() || HasFatalFailure()) return;
  const Sequence sequence = OpenSequence({.folder = out("tiny"), .detections_file = "oracle"});
  EXPECT_EQ(sequence.name, "tiny");
  EXPECT_EQ(sequence.type, "kitti-odometry");
  EXPECT_EQ(sequence.images.size(), kFrames);
  EXPECT_DOUBLE_EQ(sequence.camera.fx, 450.0);
  EXPECT_DOUBLE_EQ(sequence.camera.baseline_m, 0.12);
  EXPECT_EQ(sequence.camera.width_px, 640);
  EXPECT_EQ(sequence.camera.right_shift_px, 0.0);
  EXPECT_EQ(sequence.timestamps_ns[3], 100'000'000);
  EXPECT_EQ(sequence.groundtruth, "official");
  const auto& truth = sequence.groundtruth_world_from_camera;
  EXPECT_EQ(truth[0]->translation(), Eigen::Vector3d::Zero());
  EXPECT_GT(truth[5]->translation().norm(), 0.01);
  const auto bodies = ReadSceneBodies(out("tiny") / "objects.csv", kFrames);
  EXPECT_EQ(sequence.labels.size(), bodies.size() * bodies[0].size());
  EXPECT_EQ(sequence.detections.size(), sequence.labels.size());
  EXPECT_THAT(sequence.missing, testing::IsEmpty());
  // Numbers are written with enough digits to be read back exactly.
  std::vector<RigidTransform> poses = ReadKittiPoses(out("tiny") / "poses.txt");
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(poses[i].translation(), truth[i]->translation());
    EXPECT_LT(RotationAngle(poses[i].rotation().inverse() * truth[i]->rotation()), 1e-12);
  }
}

TEST_F(CliSynthRender, SameBytesForAnyNumberOfThreads) {
  RenderTiny({"--frames", "0:2"});
  if (IsSkipped() || HasFatalFailure()) return;
  ASSERT_EQ(Render("again", {"--frames", "0:2", "--threads", "1"}, "other cache").exit_code, 0);
  ASSERT_EQ(Render("three", {"--frames", "0:2", "--threads", "3"}, "third cache").exit_code, 0);
  EXPECT_EQ(test::ReadFile(out("again") / "manifest.json"),
            test::ReadFile(out("tiny") / "manifest.json"));
  EXPECT_EQ(HashesOf("three"), HashesOf("tiny"));
}

TEST_F(CliSynthRender, ASeedChangesOnlyNoiseAndDetections) {
  RenderTiny({"--frames", "0:2"});
  if (IsSkipped() || HasFatalFailure()) return;
  const ProcessResult render = Render("seeded", {"--frames", "0:2", "--seed", "77"});
  ASSERT_EQ(render.exit_code, 0) << render.err;
  const auto first = HashesOf("tiny"), second = HashesOf("seeded");
  ASSERT_GT(first.size(), 10U);
  ASSERT_EQ(first.size(), second.size());
  for (const auto& [name, hash] : first) {
    const bool seeded = name.starts_with("image_") || name == "detections/good.txt" ||
                        name == "detections/poor.txt" || name == "scene.json";
    EXPECT_EQ(hash == second.at(name), !seeded) << name;
  }
}

TEST_F(CliSynthRender, MatchesGoldenImages) {
  RenderTiny();
  if (IsSkipped() || HasFatalFailure()) return;
  const Json renderer = ReadJson(out("tiny") / "manifest.json")["renderer"];
  const std::string version =
      renderer["gl"].get<std::string>() + ", " + renderer["renderer"].get<std::string>();
  const auto golden = GoldenHashes().find(version);
  if (golden == GoldenHashes().end()) GTEST_SKIP() << "no golden images of " << version;
  std::string images;
  for (const auto& [name, hash] : HashesOf("tiny")) {
    if (name.starts_with("image_") || name.starts_with("instance_")) images += hash;
  }
  EXPECT_EQ(Sha256Hex(images), golden->second);
}

TEST_F(CliSynthRender, RendersARangeOfFrames) {
  RenderTiny({"--frames", "0:1"});
  if (IsSkipped() || HasFatalFailure()) return;
  ASSERT_EQ(Render("part", {"--frames", "2:4", "--detector", "poor"}).exit_code, 0);
  const Sequence sequence = OpenSequence({.folder = out("part")});
  EXPECT_EQ(sequence.images.size(), 2U);
  EXPECT_TRUE(fs::exists(out("part") / "detections/poor.txt"));
  EXPECT_FALSE(fs::exists(out("part") / "detections/good.txt"));
}

TEST_F(CliSynthRender, AnInterruptLeavesNothing) {
  RenderTiny({"--frames", "0:1"});
  if (IsSkipped() || HasFatalFailure()) return;
  const ProcessResult render =
      Render("stopped", {"--threads", "1"}, "empty cache", {.interrupt_at = " 16 %"});
  EXPECT_EQ(render.exit_code, 130);
  EXPECT_THAT(render.err, EndsWith("clustervo: stopped, nothing was written\n"));
  EXPECT_FALSE(fs::exists(out("stopped")));
  for (const auto& entry : fs::recursive_directory_iterator(out("empty cache"))) {
    EXPECT_NE(entry.path().filename(), "manifest.json");
  }
}

TEST_F(CliSynthRender, AFullDiskLeavesNothing) {
  RenderTiny({"--frames", "0:1"});
  if (IsSkipped() || HasFatalFailure()) return;
  const ProcessResult render = Render("full", {"-q"}, "full cache", {.file_size_limit = 4096});
  EXPECT_EQ(render.exit_code, 1);
  EXPECT_EQ(test::LineCount(render.err), 1U) << render.err;
  EXPECT_FALSE(fs::exists(out("full")));
}

TEST_F(CliSynthRender, NeverReplacesWhatItDidNotWrite) {
  folder_.Write("mine/notes.txt", "mine");
  ExpectError(Render("mine", {"-q"}), "other files in it", 2);
  EXPECT_TRUE(fs::exists(out("mine") / "notes.txt"));
}

TEST_F(CliSynthRender, BadScenesGiveOneLine) {
  RenderTiny({"--frames", "0:1"});
  if (IsSkipped() || HasFatalFailure()) return;
  struct Case {
    std::string assignment;
    std::string expected;
    int exit_code = 2;  // 2: wrong usage; 1: bad input
  };
  const std::vector<Case> cases = {
      {"objects.0.colour=1", "colour"},
      {"objects.2.path.still.at=[2.1, 0.1]", "ball_2", 1},    // in the wall
      {"objects.2.path.still.at=[-1.9, -0.1]", "ball_2", 1},  // behind the camera
      {"objects.2={\"name\": \"ball_2\", \"model\": \"mesh\", \"file\": \"absent.obj\", "
       "\"category\": \"Ball\", \"size_m\": 0.5, \"path\": {\"still\": {\"at\": [1.3, 0.1]}}}",
       "objects.2"},
      {"rig.width_px=0", "width_px"},
      {"sensor.no_such=1", "no_such", 1}};
  for (const auto& [assignment, expected, exit_code] : cases) {
    const ProcessResult render = Render("bad", {"-q", "--set", assignment});
    EXPECT_EQ(render.exit_code, exit_code) << assignment;
    EXPECT_EQ(test::LineCount(render.err), 1U) << assignment << ": " << render.err;
    EXPECT_THAT(render.err, AllOf(HasSubstr("clustervo: error: "), HasSubstr(expected)));
    EXPECT_FALSE(fs::exists(out("bad"))) << assignment;
  }
  EXPECT_THAT(Render("bad", {"--detector", "best"}).err, HasSubstr("oracle, good or poor"));
  EXPECT_THAT(Run({"synth", "render", "tyni", "-o", Path("bad")}).err, HasSubstr("tiny"));
}

TEST_F(CliSynthRender, PreviewDrawsASheet) {
  RenderTiny({"--frames", "0:1"});
  if (IsSkipped() || HasFatalFailure()) return;
  const ProcessResult preview =
      Run({"synth", "render", "tiny", "--preview", "-o", Path("sheet.png"), "-q"});
  EXPECT_EQ(preview.exit_code, 0) << preview.err;
  EXPECT_GT(fs::file_size(out("sheet.png")), 100'000U);
}

TEST(CliSynth, ListsScenesAndKnobs) {
  const ProcessResult list = RunProgram({"list", "scenes"});
  EXPECT_EQ(list.exit_code, 0) << list.err;
  EXPECT_THAT(list.out, AllOf(HasSubstr("tiny"), HasSubstr("640x480")));
  EXPECT_THAT(RunProgram({"list", "scenes", "room"}).out, HasSubstr("speed_mps"));
}

TEST(CliSynth, RefusesWrongSeedsAndKnobs) {
  const test::TempFolder folder;
  const auto render = [&](const std::string& scene) {
    return RunProgram({"synth", "render", scene, "-o", (folder.path() / "set").string()});
  };
  for (const char* seed : {"-1", "4294967296", "x"}) {
    ExpectError(render(std::string("room@") + seed), "an integer from 0 to 4294967295", 2);
  }
  ExpectError(render("room@17,mover=2"), "no knob \"mover\"", 2);
  EXPECT_FALSE(fs::exists(folder.path() / "set"));
}

class CliSynthCheck : public test::CommandTest {
 protected:
  CliSynthCheck() { test::WriteRayScene(rays()); }
  fs::path rays() const { return Path("rays"); }
};

TEST_F(CliSynthCheck, PrintsItsResults) {
  const ProcessResult run = RunProgram({"synth", "check", rays().string(), "--threads", "2"});
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("disparity_offset"), HasSubstr("passed"), Not(HasSubstr("FAILED"))));
}

TEST_F(CliSynthCheck, FailsOnDisagreement) {
  WriteFileBytes(rays() / "poses_right.txt", ReadFileBytes(rays() / "poses.txt"));
  const ProcessResult run = RunProgram({"synth", "check", rays().string()});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.out, AllOf(HasSubstr("poses_right.txt"), HasSubstr("FAILED")));
  EXPECT_EQ(run.err, "");
}

TEST_F(CliSynthCheck, AFolderWithoutASceneIsBadInput) {
  ExpectError(RunProgram({"synth", "check", folder_.path().string()}), "no objects.csv", 1);
}

}  // namespace
}  // namespace cvo
