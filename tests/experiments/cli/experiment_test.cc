// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mount.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <map>

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "experiments/suite/engine.h"
#include "experiments/suite/job_status.h"
#include "tests/experiments/cli/process.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/experiments/suite/slurm_cluster.h"
#include "tests/support/temp_folder.h"

namespace cvo::test::experiment_test {
namespace {

namespace fs = std::filesystem;
using test::Arguments;
using test::ProcessResult;
using test::RunProgram;
using test::With;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

// `clustervo experiment run` and `job` as processes, on images drawn by the test.

class CliExperiment : public test::CommandTest {
 protected:
  CliExperiment() {
    test::WriteTinySequence(data() / "wall", 6);
    WriteSuite("{\"folder\": \"wall\"}", "1");
  }

  fs::path data() const { return Path("data"); }
  fs::path out() const { return Path("out"); }

  void WriteSuite(const std::string& sequences, const std::string& seeds) const {
    folder_.Write("suite.json",
                  StrCat("{\"name\": \"small\", \"about\": \"for tests\", \"sequences\": [",
                         sequences, "], \"variants\": [\"full\", \"static\"], \"seeds\": ", seeds,
                         ", \"table\": {\"rows\": [\"variant\"], \"metrics\": [\"camera_ate\"], ",
                         "\"reference\": \"full\"}}"));
  }
  ProcessResult Experiment(const Arguments& arguments, const test::ProcessSetup& setup = {}) const {
    return CommandTest::Run(With({"experiment"}, arguments), setup);
  }
  ProcessResult Run(const Arguments& more = {}, const test::ProcessSetup& setup = {}) const {
    return Experiment(With({"run", Path("suite.json"), "-o", out().string(), "-j", "1"}, more),
                      setup);
  }
  // What is done in the output folder and what would run.
  std::string Status() const { return Run({"--dry-run"}).out; }
  std::vector<fs::path> Results() const {
    std::vector<fs::path> results;
    for (const auto& job : fs::directory_iterator(out() / "jobs")) {
      if (fs::exists(job.path() / "result.json")) results.push_back(job.path() / "result.json");
    }
    std::sort(results.begin(), results.end());
    return results;
  }
};

TEST_F(CliExperiment, RunsOnlyUnfinishedJobs) {
  const ProcessResult run = Run();
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, "small: 2 jobs: 2 done\n");
  EXPECT_THAT(run.err, HasSubstr("100 %  2/2 jobs  "));
  EXPECT_THAT(Status(), StartsWith("small (given split): 2 jobs: 2 done\n"));

  // Finished jobs are not run again, but a damaged result is replaced.
  const std::vector<fs::path> results = Results();
  ASSERT_EQ(results.size(), 2U);
  const std::string bytes = test::ReadFile(results[0]);
  const auto kept = fs::last_write_time(results[1]);
  test::CutFile(results[0]);
  folder_.Write(results[0].parent_path() / ".result.json.tmp-0123456789abcdef",
                "of a killed process");
  EXPECT_THAT(Status(), HasSubstr("1 done, 1 not run yet\n"));
  const ProcessResult again = Run();
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.err, HasSubstr("1/1 jobs"));
  EXPECT_EQ(test::ReadFile(results[0]), bytes);
  EXPECT_EQ(fs::last_write_time(results[1]), kept);
  EXPECT_FALSE(fs::exists(results[0].parent_path() / ".result.json.tmp-0123456789abcdef"));
}

TEST_F(CliExperiment, AnEditedSuiteReusesResults) {
  ASSERT_EQ(Run().exit_code, 0);
  WriteSuite("{\"folder\": \"wall\"}", "2");
  const ProcessResult more = Run();
  EXPECT_EQ(more.out, "small: 4 jobs: 4 done\n") << more.err;
  EXPECT_THAT(more.err, HasSubstr("2/2 jobs"));
  WriteSuite("{\"folder\": \"wall\"}", "1");
  EXPECT_EQ(Run().out, "small: 2 jobs: 2 done\n");
  EXPECT_EQ(Results().size(), 4U);
}

TEST_F(CliExperiment, AMissingSequenceIsListed) {
  WriteSuite("{\"folder\": \"wall\"}, {\"folder\": \"door\"}", "1");
  const ProcessResult run = Run();
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(StartsWith("small: 4 jobs: 2 done, 2 with missing input\n"),
                             HasSubstr("missing input: door: ")));
  WriteSuite("{\"folder\": \"door\"}", "1");
  const ProcessResult none = Run();
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_THAT(none.err, HasSubstr("found no sequence"));
}

TEST_F(CliExperiment, ADamagedSequenceFailsOnlyItsJobs) {
  test::WriteTinySequence(data() / "door", 6);
  fs::remove(data() / "door" / "image_1" / "000003.png");
  WriteSuite("{\"folder\": \"wall\"}, {\"folder\": \"door\"}", "1");
  const ProcessResult run = Run();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.out, HasSubstr("small: 4 jobs: 2 done, 2 failed\n"));
  EXPECT_THAT(run.err, EndsWith("2 of 4 jobs failed; the same command tries them again\n"));
}

TEST_F(CliExperiment, AJobRefusesFilesChangedSincePlanning) {
  ASSERT_EQ(Run().exit_code, 0);
  const std::string id = Results()[0].parent_path().filename().string();
  fs::remove_all(out() / "jobs" / id);
  ASSERT_EQ(Experiment({"job", out().string(), id}).exit_code, 0);
  const std::string image = (data() / "wall" / "image_0" / "000002.png").string();
  fs::copy_file(data() / "wall" / "image_0" / "000001.png", image,
                fs::copy_options::overwrite_existing);
  fs::remove_all(out() / "jobs" / id);
  const ProcessResult job = Experiment({"job", out().string(), id});
  EXPECT_EQ(job.exit_code, 1);
  EXPECT_THAT(job.err, HasSubstr("differ from when the suite was planned"));
  EXPECT_FALSE(fs::exists(out() / "jobs" / id));
  EXPECT_THAT(Experiment({"job", out().string(), "none"}).err, HasSubstr("found no job \"none\""));
  // Planning again gives the changed jobs new identities and keeps the old results.
  EXPECT_EQ(Run().out, "small: 2 jobs: 2 done\n");
  EXPECT_EQ(Results().size(), 3U);
}

TEST_F(CliExperiment, AdmitsOneRunnerAtATime) {
  fs::create_directory(out());
  const FolderLock lock(out() / "lock");
  ExpectError(Run(), StrCat("in use by process ", ::getpid(), " on "), 1);
  EXPECT_FALSE(fs::exists(out() / "plan.json"));
}

TEST_F(CliExperiment, AnInterruptKeepsFinishedJobs) {
  WriteSuite("{\"folder\": \"wall\"}", "3");
  const ProcessResult run = Run({}, {.interrupt_at = "  2/6 jobs"});
  EXPECT_EQ(run.exit_code, 130) << run.err;
  EXPECT_THAT(run.err, EndsWith("clustervo: stopped; finished jobs are kept, and running the same "
                                "command again continues\n"));
  const std::size_t done = Results().size();
  EXPECT_GE(done, 2U);
  EXPECT_FALSE(fs::exists(out() / "failed") && !fs::is_empty(out() / "failed"));
  const ProcessResult rest = Run();
  EXPECT_EQ(rest.out, "small: 6 jobs: 6 done\n");
  EXPECT_THAT(rest.err, HasSubstr(StrCat("/", 6 - done, " jobs")));
}

TEST_F(CliExperiment, LimitsFailJobsUntilTheyAreRaised) {
  const ProcessResult late = Run({"--time-limit", "0.01"});
  EXPECT_EQ(late.exit_code, 1);
  EXPECT_THAT(late.out, HasSubstr("stopped after 0.01 s"));
  EXPECT_THAT(late.err, HasSubstr("2 of 2 jobs failed"));
  EXPECT_THAT(Status(), AllOf(HasSubstr("0 done, 2 failed\n"),
                              HasSubstr("full, seed 1: stopped after 0.01 s")));

  if (kLimitsMemory) {
    for (const char* limit_mb : {"60", "90"}) {
      EXPECT_EQ(Run({"--memory-limit", limit_mb}).exit_code, 1);
      EXPECT_THAT(Status(), HasSubstr(StrCat("memory limit of ", limit_mb, " MB")));
    }
  }
  EXPECT_EQ(Run().out, "small: 2 jobs: 2 done\n");
  EXPECT_THAT(Status(), testing::Not(HasSubstr("failed")));
}

TEST_F(CliExperiment, BadInputGivesOneLine) {
  const std::vector<Arguments> bad = {{"--engine", "cloud"},
                                      {"-j", "0"},
                                      {"--time-limit", "-1"},
                                      {"--memory-limit", "nan"},
                                      {"--seeds", "0"}};
  for (const Arguments& flags : bad) {
    const ProcessResult run = Run(flags);
    EXPECT_EQ(run.exit_code, 2) << flags[0];
    EXPECT_EQ(test::LineCount(run.err), 1U) << run.err;
  }
  const ProcessResult option = Run({"--set", "no.such=1"});
  EXPECT_NE(option.exit_code, 0);
  EXPECT_EQ(test::LineCount(option.err), 1U) << option.err;
  EXPECT_FALSE(fs::exists(out()));
}

TEST_F(CliExperiment, AFolderThatBecomesReadOnlyLosesNothing) {
  fs::create_directory(out());
  if (::mount("tmpfs", out().c_str(), "tmpfs", 0, "size=50m") != 0) {
    GTEST_SKIP() << "cannot mount a disk: " << std::strerror(errno);
  }
  const int first = Run().exit_code;
  const std::string bytes = test::ReadFile(Results()[0]);
  ::mount("tmpfs", out().c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, "size=50m");
  WriteSuite("{\"folder\": \"wall\"}", "2");
  const ProcessResult run = Run();
  const std::string status = Status();
  const std::string after = test::ReadFile(Results()[0]);
  ::umount(out().c_str());
  EXPECT_EQ(first, 0);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("cannot write: Read-only file system"));
  EXPECT_EQ(test::LineCount(run.err), 1U);
  EXPECT_THAT(status, HasSubstr("2 done, 2 not run yet\n"));
  EXPECT_EQ(after, bytes);
}

TEST_F(CliExperiment, SweepsWithoutAFile) {
  const ProcessResult run =
      Experiment({"run", "--scenes", "tiny", "--variants", "full,static", "--grid",
                  "orb.features=300,500", "--frames", "0:2", "-o", out().string(), "-q"});
  if (run.err.find("no OSMesa") != std::string::npos) GTEST_SKIP() << run.err;
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, "out: 4 jobs: 4 done\n");
  EXPECT_EQ(Experiment({"run", (out() / "suite.json").string(), "-o", out().string(), "-q"}).out,
            run.out);
  ExpectError(Experiment({"run", "-o", Path("none")}), "no suite: give SUITE", 2);
  ExpectError(Experiment({"run", "--scenes", "tiny", "--grid", "x", "-o", Path("none")}),
              "--grid x: found no PATH=A,B", 2);
}

TEST_F(CliExperiment, ATimedSuiteShowsItsTimes) {
  folder_.Write("suite.json", R"({"name": "timed", "sequences": [{"folder": "wall"}], )"
                              R"("variants": ["static"], "timed_threads": 1})");
  const ProcessResult run =
      Experiment({"run", Path("suite.json"), "-o", out().string(), "-j", "2"});
  ASSERT_EQ(run.exit_code, 0) << run.err << run.out;
  EXPECT_THAT(run.err, HasSubstr("timed: one job at a time, because the suite measures times"));
  EXPECT_FALSE(fs::exists(Path("cache/frontend")));  // not shared between jobs
  EXPECT_THAT(Experiment({"table", out().string(), "--times"}).out,
              AllOf(HasSubstr("clusters per frame"), HasSubstr("features [ms]"),
                    HasSubstr("wall    none        static   1     0.0"), HasSubstr("machine: ")));
  test::ExpectError(Experiment({"table", data().string(), "--times"}), "plan.json");
}

TEST_F(CliExperiment, ADryRunListsJobsAndMissingSequences) {
  WriteSuite("{\"folder\": \"wall\"}, {\"folder\": \"door\"}", "1");
  const ProcessResult plan = Run({"--seeds", "2", "--dry-run"});
  EXPECT_EQ(plan.exit_code, 0) << plan.err;
  EXPECT_THAT(plan.out, AllOf(HasSubstr("8 jobs: 0 done, 4 not run yet, 4 with missing input\n"),
                              HasSubstr("missing input: door: no door below ")));
  EXPECT_FALSE(fs::exists(out()));
  for (const Arguments& wrong :
       {Arguments{"no_such_suite"}, {"ci", "--set", "window.spatail=3"}, {"ci", "--seeds", "0"}}) {
    ExpectError(Experiment(With({"run", "--dry-run", "-o", out().string()}, wrong)), "", 2);
  }
}

TEST(CliExperimentList, HasTheSizesOfSuites) {
  const ProcessResult list = RunProgram({"list", "suites"});
  EXPECT_EQ(list.exit_code, 0) << list.err;
  EXPECT_THAT(list.out, testing::ContainsRegex("ablation +test +520 "));
}

constexpr const char* kSuite = R"({
  "name": "small",
  "about": "Two variants on one small scene",
  "sequences": [{"scene": "tiny", "detections": "good"}],
  "variants": ["full", "2d"],
  "seeds": 1,
  "table": {"rows": ["variant"], "metrics": ["camera_ate"], "reference": "full"}
})";

// Returns the files written by the jobs of a suite, except for their times.
std::map<std::string, std::string> ResultsIn(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder / "jobs")) {
    if (!entry.is_regular_file() || entry.path().filename() == "timing.json") continue;
    files[entry.path().lexically_relative(folder).string()] = ReadFile(entry.path());
  }
  return files;
}

ProcessResult RunSuiteOn(const std::string& engine, const TempFolder& temp) {
  const fs::path suite = temp.Write("suite.json", kSuite);
  return RunProgram(
      {"experiment", "run", suite.string(), "-o", (temp.path() / engine).string(), "--engine",
       engine, "-j", "2"},
      {.environment = {"CLUSTERVO_CACHE=" + (temp.path() / "cache").string() + engine}});
}

TEST(Slurm, GivesTheSameBytesAsTheLocalEngine) {
  const SlurmCluster cluster;
  if (!cluster.missing().empty()) GTEST_SKIP() << cluster.missing();
  const TempFolder temp;
  const ProcessResult local = RunSuiteOn("local", temp);
  ASSERT_EQ(local.exit_code, 0) << local.err;
  const ProcessResult slurm = RunSuiteOn("slurm", temp);
  ASSERT_EQ(slurm.exit_code, 0) << slurm.err;
  EXPECT_THAT(slurm.err, HasSubstr("slurm: job "));
  const std::map<std::string, std::string> results = ResultsIn(temp.path() / "slurm");
  EXPECT_EQ(results, ResultsIn(temp.path() / "local"));
  EXPECT_EQ(std::count_if(results.begin(), results.end(),
                          [](const auto& file) { return file.first.ends_with("/result.json"); }),
            2);
  EXPECT_EQ(slurm.out, local.out);
}

}  // namespace
}  // namespace cvo::test::experiment_test
