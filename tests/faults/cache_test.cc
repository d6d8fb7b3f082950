// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Faults of folders and of the cache: a rendered scene that has changed since it was written is
// rendered again, never read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <map>

#include "core/base/error.h"
#include "core/files/atomic_file.h"
#include "core/files/json/json.h"
#include "core/files/text_file.h"
#include "experiments/suite/build_plan.h"
#include "tests/experiments/cli/process.h"
#include "tests/support/temp_folder.h"

namespace cvo::cache_test {
namespace {

namespace fs = std::filesystem;
using test::ProcessResult;
using testing::AllOf;
using testing::HasSubstr;

class FolderFaults : public testing::Test {
 protected:
  void SetUp() override {
    folder_.Write("suite.json",
                  "{\"name\": \"small\", \"sequences\": [{\"scene\": \"tiny\", \"frames\": "
                  "\"0:2\", \"detections\": \"good\"}], \"variants\": [\"static\"], \"seeds\": 1, "
                  "\"table\": {\"rows\": [\"variant\"], \"metrics\": [\"camera_ate\"]}}");
    const ProcessResult run = Suite();
    if (run.err.find("no OSMesa") != std::string::npos) GTEST_SKIP() << run.err;
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const fs::path plan = folder_.path() / "out" / "plan.json";
    scene_ = ReadJson(plan)["jobs"][0]["folder"].get<std::string>();
    job_ = ReadJson(plan)["jobs"][0]["job"];
  }

  ProcessResult Program(const std::vector<std::string>& arguments) const {
    return test::RunProgram(
        arguments,
        {.environment = {StrCat("CLUSTERVO_CACHE=", (folder_.path() / "cache").string())}});
  }
  ProcessResult Suite(const std::string& flag = "-q") const {
    return Program({"experiment", "run", (folder_.path() / "suite.json").string(), "-o",
                    (folder_.path() / "out").string(), flag});
  }
  // Overwrites a file and restores its modification time.
  static void Damage(const fs::path& file, const std::string& bytes) {
    fs::permissions(file, fs::perms::owner_write, fs::perm_options::add);
    const fs::file_time_type modified = fs::last_write_time(file);
    WriteFileBytes(file, bytes);
    fs::last_write_time(file, modified);
  }
  static std::string Flipped(std::string bytes) {
    char& middle = bytes[bytes.size() / 2];
    middle = static_cast<char>(middle ^ 1);
    return bytes;
  }
  void Flip(const fs::path& name) const {
    Damage(scene_ / name, Flipped(ReadFileBytes(scene_ / name)));
  }
  std::map<std::string, std::string> Files() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(scene_)) {
      if (entry.is_regular_file()) files[entry.path()] = ReadFileBytes(entry.path());
    }
    return files;
  }

  test::TempFolder folder_;
  fs::path scene_;
  std::string job_;
};

// Kinds of damage: one flipped bit, a truncated file, and the file of another scene in its place.
TEST_F(FolderFaults, DamageOfEveryFileIsDetected) {
  if (IsSkipped()) return;
  const fs::path other = folder_.path() / "other";
  const ProcessResult render =
      Program({"synth", "render", "tiny", "-o", other.string(), "--frames", "1:3", "--set",
               "rig.width_px=512", "--set", "rate_hz=20", "-q"});
  ASSERT_EQ(render.exit_code, 0) << render.err;
  for (const auto& [path, whole] : Files()) {
    const fs::path file = path;
    const std::string swapped = ReadFileBytes(other / file.lexically_relative(scene_));
    for (const std::string& bytes : {Flipped(whole), whole.substr(0, whole.size() / 2), swapped}) {
      Damage(file, bytes);
      EXPECT_TRUE(FindSceneDamage(scene_, {})) << path;
    }
    Damage(file, whole);
  }
  EXPECT_EQ(FindSceneDamage(scene_, {}), std::nullopt);
}

TEST_F(FolderFaults, ARunRendersADamagedSceneAgain) {
  if (IsSkipped()) return;
  const auto before = Files();
  for (const char* name : {"poses.txt", "image_0/000000.png", "instance_0/000001.png"}) Flip(name);
  fs::resize_file(scene_ / "manifest.json", 300);
  fs::remove(scene_ / "times.txt");
  EXPECT_THAT(Suite("--dry-run").out, HasSubstr("scenes to render: 1"));
  const ProcessResult job = Program({"experiment", "job", (folder_.path() / "out").string(), job_});
  EXPECT_EQ(job.exit_code, 1) << job.err;
  EXPECT_EQ(test::LineCount(job.err), 1U) << job.err;
  const ProcessResult run = Suite();
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("a cached scene is damaged and will be rendered again:  "));
  EXPECT_TRUE(Files() == before);
  EXPECT_EQ(ReadJson(folder_.path() / "out" / "plan.json")["jobs"][0]["job"], job_);
}

// It is unknown how a folder outside the cache was rendered, so it cannot be rendered again.
TEST_F(FolderFaults, DamageOutsideTheCacheIsRefused) {
  if (IsSkipped()) return;
  const fs::path copy = folder_.path() / "copy";
  fs::copy(scene_, copy, fs::copy_options::recursive);
  scene_ = copy;
  const std::string out = (folder_.path() / "run").string();
  EXPECT_EQ(Program({"run", copy.string(), "-o", out, "-q"}).exit_code, 0);
  Flip("depth_0/000001.tiff");
  EXPECT_EQ(
      Program({"run", copy.string(), "-o", out, "-q", "--frames", "0:1", "--force"}).exit_code, 0);
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"run", copy.string(), "-o", out, "-q"},
        {"eval", "trajectory", "--sequence", copy.string(), "--estimate", out + "/camera.tum"}}) {
    const ProcessResult result = Program(arguments);
    EXPECT_EQ(result.exit_code, 1) << arguments[0];
    EXPECT_THAT(result.err, AllOf(HasSubstr("depth_0/000001.tiff has changed since it was written"),
                                  HasSubstr("render the scene again")));
    EXPECT_EQ(test::LineCount(result.err), 1U) << result.err;
  }
}

TEST_F(FolderFaults, AFolderWithOtherFilesIsNotReplaced) {
  if (IsSkipped()) return;
  const fs::path mine = folder_.path() / "mine";
  const std::vector<std::string> render = {"synth",       "render",   "tiny", "-o",
                                           mine.string(), "--frames", "0:2",  "-q"};
  EXPECT_EQ(Program(render).exit_code, 0);
  EXPECT_EQ(Program(render).exit_code, 0);
  const fs::path notes = folder_.Write("mine/detections/notes.txt", "mine");
  const ProcessResult refused = Program(render);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err,
              HasSubstr(notes.string() + ": found a file that manifest.json does not"));
  EXPECT_EQ(ReadFileBytes(notes), "mine");
}

}  // namespace
}  // namespace cvo::cache_test
