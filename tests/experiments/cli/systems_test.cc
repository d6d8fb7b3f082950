// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "core/files/text_file.h"
#include "tests/experiments/cli/process.h"
#include "tests/experiments/runner/tiny_sequence.h"

namespace cvo::test::systems_test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

// Programs of others as systems of a suite: shell scripts on images drawn by the test.

constexpr int kFrames = 6;
// Writes a pose at rest for each time.
const std::string kAtRest = "awk '{print $1, 0, 0, 0, 0, 0, 0, 1}' {times} > camera.tum";

Json System(const std::string& name, const std::string& script) {
  return {{"name", name},
          {"command", {"sh", "-c", script}},
          {"writes", {{"camera", "{out}/camera.tum"}}}};
}

class CliSystems : public CommandTest {
 protected:
  CliSystems() { WriteTinySequence(Path("data/wall"), kFrames); }

  ProcessResult RunSuite(const Json& systems, const Json& sequence = {{"folder", "wall"}}) const {
    const Json suite = {{"name", "others"},
                        {"sequences", {sequence}},
                        {"variants", {"static"}},
                        {"systems", systems},
                        {"table", {{"rows", {"variant"}}, {"metrics", {"camera_ate"}}}}};
    folder_.Write("suite.json", suite.dump());
    return Run({"experiment", "run", Path("suite.json"), "-o", Path("out"), "-j", "2"});
  }
  // The folders of jobs by the variant of their result.
  std::map<std::string, fs::path> Jobs() const {
    std::map<std::string, fs::path> jobs;
    for (const std::string& name : NamesIn(Path("out/jobs"))) {
      const fs::path folder = fs::path(Path("out/jobs")) / name;
      if (!fs::exists(folder / "result.json")) continue;
      jobs[ReadJson(folder / "result.json")["variant"].get<std::string>()] = folder;
    }
    return jobs;
  }
};

TEST_F(CliSystems, AProgramIsAJobLikeAVariant) {
  const fs::path script = folder_.Write("run.sh",
                                        "#!/bin/sh\n"
                                        "[ \"$1\" = --version ] && echo 'mine 1.0' && exit\n"
                                        "ls $1 $2\ncat $3\nhead -n " +
                                            std::to_string(kFrames) + " " + Path("data/wall") +
                                            "/poses.txt > $4/poses\n");
  fs::permissions(script, fs::perms::owner_all);
  Json system = {{"name", "mine"},
                 {"command", {"./run.sh", "{left}", "{right}", "{calibration}", "{out}"}},
                 {"version", {"./run.sh", "--version"}},
                 {"writes", {{"camera", "poses"}}}};
  const ProcessResult first = RunSuite(Json::array({system}));
  ASSERT_EQ(first.exit_code, 0) << first.err;
  const fs::path job = Jobs().at("system:mine");
  const Json result = ReadJson(job / "result.json");
  EXPECT_EQ(result["system"]["program"]["version"], "mine 1.0");
  EXPECT_EQ(result["frame_counts"]["tracked"], kFrames);
  for (const Json& metric : result["metrics"]) {
    if (metric["name"] == "camera_ate") {
      EXPECT_LT(metric["value"], 1e-6);
    }
  }
  const Json timing = ReadJson(job / "timing.json");
  for (const char* key : {"wall_s", "cpu_s", "peak_memory_mb", "frames_per_second"}) {
    EXPECT_GT(timing[key], 0.0) << key;
  }
  const std::string output = ReadFileBytes(job / "output.txt");
  EXPECT_THAT(output, AllOf(HasSubstr("000005.png"), HasSubstr("P1: "), HasSubstr("P3: ")));
  const fs::path inputs = fs::path(Path("out/inputs")) / NamesIn(Path("out/inputs")).at(0);
  EXPECT_EQ(fs::read_symlink(inputs / "right" / "000001.png").parent_path().filename(), "image_1");
  const std::string made = ReadFileBytes(job / "timing.json");
  EXPECT_EQ(RunSuite(Json::array({system})).exit_code, 0);
  EXPECT_EQ(ReadFileBytes(job / "timing.json"), made);  // it has not run again

  folder_.Write("run.sh", ReadFileBytes(script) + "# another program\n");
  EXPECT_EQ(RunSuite(Json::array({system})).exit_code, 0);
  EXPECT_EQ(NamesIn(Path("out/jobs")).size(), 3U);  // the variant, and both programs

  for (const char* form : {"euroc", "orb_slam", "json"}) {
    system["calibration"] = form;
    system["command"] = {"sh", "-c", "cat {calibration} {calibration}/cam1/*; " + kAtRest};
    system["writes"]["camera"] = "{out}/camera.tum";
    EXPECT_EQ(RunSuite(Json::array({system})).exit_code, 0) << form;
  }
  std::string all;
  for (const std::string& id : NamesIn(Path("out/jobs"))) {
    const fs::path log = fs::path(Path("out/jobs")) / id / "output.txt";
    if (fs::exists(log)) all += ReadFileBytes(log);
  }
  for (const char* text : {"T_BS", "Camera.bf", "\"baseline_m\""}) {
    EXPECT_THAT(all, HasSubstr(text));
  }
}

// Perturbed images exist nowhere, so they are written.
TEST_F(CliSystems, PerturbedImagesBoxesAndKeyframesAreGiven) {
  folder_.Write("data/boxes.txt",
                "2 -1 Car -1 -1 -10 20 30 60 70 -1 -1 -1 -1000 -1000 -1000 -10 0.5\n"
                "3 -1 Tree -1 -1 -10 20 30 60 70 -1 -1 -1 -1000 -1000 -1000 -10 0.5\n");
  const Json system = System("keys", "cat {detections}; head -c 4 {left}/000003.png; " + kAtRest +
                                         "; sed -i 2,3d camera.tum");
  const ProcessResult run = RunSuite(Json::array({system}), {{"folder", "wall"},
                                                             {"frames", "1:6"},
                                                             {"detections", "boxes.txt"},
                                                             {"perturb", {{"blur_px", 1}}}});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const fs::path job = Jobs().at("system:keys");
  const std::string output = ReadFileBytes(job / "output.txt");
  EXPECT_THAT(output,
              AllOf(HasSubstr("1 -1 Car"), HasSubstr("PNG"), testing::Not(HasSubstr("Tree"))));
  EXPECT_EQ(ReadJson(job / "result.json")["frame_counts"]["skipped"], 2);
}

TEST_F(CliSystems, AFaultOfOneFailsOneJobWithOneLine) {
  struct Fault {
    const char* name;
    std::string script;
    const char* message;
  };
  const std::string with_objects = kAtRest + "; echo '";
  const std::vector<Fault> faults = {
      {"crash", "echo said; echo why >&2; exit 3", "crash: exit code 3, its last line is \"why\""},
      {"signal", "kill -SEGV $$", "killed by signal 11 (SIGSEGV)"},
      {"hang", "sleep 60 & sleep 60", "stopped after 1 s"},
      {"nothing", "true", "camera.tum: found no such file"},
      {"empty", ": > camera.tum", "no pose"},
      {"half", kAtRest + "; printf '0.5 1 2' >> camera.tum", "camera.tum:7"},
      {"nan", "awk '{print $1, 0, 0, 0, 0, 0, 0, \"nan\"}' {times} > camera.tum", "NaN"},
      {"clock", "awk '{print $1 + 9, 0, 0, 0, 0, 0, 0, 1}' {times} > camera.tum",
       "expected that of a frame"},
      {"count", "for i in 1 2 3; do echo 1 0 0 0 0 1 0 0 0 0 1 0; done > camera.tum",
       "one per frame"},
      {"length", "awk '{print $1, 0, 0, 0, 0, 0, 0, 0.5}' {times} > camera.tum",
       "a quaternion of length 0.5"},
      {"no_id", with_objects + "0 -1 Car 0 0 0 1 1 9 9 1 1 1 0 1 9 0 0.5' > objects", "track -1"},
      {"no_box", with_objects + "0 1 Car 0 0 0 1 1 9 9 -1 -1 -1 0 1 9 0 0.5' > objects",
       "without a 3D box"},
      {"no_objects", kAtRest, "objects: found no such file"}};
  Json systems = Json::array({System("good", kAtRest)});
  for (const Fault& fault : faults) {
    Json system = System(fault.name, fault.script);
    if (fault.script.starts_with(with_objects) || std::string(fault.name) == "no_objects") {
      system["writes"]["objects"] = "{out}/objects";
    }
    if (std::string(fault.name) == "hang") system["limits"] = {{"time_s", 1}, {"memory_mb", 0}};
    systems.push_back(system);
  }
  Json absent = System("absent", "");
  absent["command"] = Json::array({"./none.sh"});
  systems.push_back(absent);
  const ProcessResult run = RunSuite(systems);
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_THAT(run.out, HasSubstr(StrCat(faults.size() + 3, " jobs: 2 done, ", faults.size() + 1,
                                        " failed\n")));
  EXPECT_EQ(LineCount(run.out), faults.size() + 2);
  EXPECT_THAT(run.out, HasSubstr("failed: wall absent, seed 1: ./none.sh: found no such program"));
  for (const Fault& fault : faults) {
    const std::string line = StrCat("failed: wall ", fault.name, ", seed 1: ");
    const std::size_t at = run.out.find(line);
    ASSERT_NE(at, run.out.npos) << fault.name;
    EXPECT_THAT(run.out.substr(at, run.out.find('\n', at) - at), HasSubstr(fault.message));
  }
}

TEST_F(CliSystems, AVersionIsAskedForOnce) {
  Json system = System("unknown", kAtRest);
  system["version"] = {"sh", "-c", "echo asked >> " + Path("asked") + "; exit 3"};
  system["seeds"] = 3;
  const ProcessResult run = RunSuite(Json::array({system}));
  EXPECT_THAT(run.out, HasSubstr("failed: wall unknown, seed 3: sh -c"));
  EXPECT_EQ(ReadFileBytes(Path("asked")), "asked\n");
}

// A copy of somebody else's results, without images.
TEST_F(CliSystems, ResultsOfOthersAreCheckedAndShownBeside) {
  ASSERT_EQ(RunSuite(Json::array({System("mine", kAtRest)})).exit_code, 0);
  fs::copy(Path("out"), Path("theirs"), fs::copy_options::recursive);
  fs::remove_all(Path("theirs/inputs"));
  const auto table = [&] { return Run({"experiment", "table", Path("out"), Path("theirs")}); };
  EXPECT_THAT(table().out, AllOf(HasSubstr("\nstatic (theirs) "), HasSubstr("\nmine (theirs) "),
                                 HasSubstr("\n4 of 4 runs, ")));
  EXPECT_FALSE(fs::exists(Path("out/table.json")));

  const fs::path file = fs::path(Path("theirs/jobs")) / Jobs().at("static").filename();
  const std::string result = ReadFileBytes(file / "result.json");
  const auto with = [&](const std::string& old, const std::string& text) {
    std::string changed = result;
    changed.replace(changed.find(old), old.size(), text);
    folder_.Write(file / "result.json", changed);
    const ProcessResult run = table();
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.out, HasSubstr("\n3 of 4 runs, "));
    return Run({"experiment", "table", Path("out"), Path("theirs"), "--all"}).out;
  };
  EXPECT_THAT(with("\"n\": 6", "\"n\": 7"), HasSubstr("do not fit its checksum"));
  EXPECT_THAT(with("\"schema_version\": 3", "\"schema_version\": 9"), HasSubstr("schema"));
  folder_.Write(file / "result.json", result);
  std::string plan = ReadFileBytes(Path("theirs/plan.json"));
  plan.replace(plan.find(file.filename().string()), 2, "..");
  folder_.Write("theirs/plan.json", plan);
  ExpectError(table(), "expected the name of its folder");
}

TEST_F(CliSystems, AFileOfSystemsNeedsNoSuite) {
  const auto run = [&](const std::string& text) {
    folder_.Write("mine.json", text);
    return Run(
        {"experiment", "run", "--systems", Path("mine.json"), "-o", Path("out"), "--dry-run"});
  };
  const Json file = {{"systems", Json::array({System("mine", kAtRest)})}};
  EXPECT_THAT(run(file.dump()).out, HasSubstr("1 job: "));
  ExpectError(run("{}"), "mine.json: found no \"systems\"");
}

}  // namespace
}  // namespace cvo::test::systems_test
