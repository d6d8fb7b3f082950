// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// `clustervo experiment run`, `status` and `job` as processes, on images drawn by the test.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mount.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "experiments/jobs/child_process.h"
#include "experiments/jobs/folder_lock.h"
#include "tests/experiments/cli/process.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/support/temp_folder.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using test::ProcessResult;
using test::RunProgram;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

class CliExperiment : public testing::Test {
 protected:
  CliExperiment() {
    test::WriteTinySequence(data() / "wall", 6);
    WriteSuite("{\"folder\": \"wall\"}", "1");
  }

  fs::path data() const { return folder_.path() / "data"; }
  fs::path out() const { return folder_.path() / "out"; }

  void WriteSuite(const std::string& sequences, const std::string& seeds) const {
    folder_.Write("suite.json",
                  StrCat("{\"name\": \"small\", \"about\": \"for tests\", \"sequences\": [",
                         sequences, "], \"variants\": [\"full\", \"static\"], \"seeds\": ", seeds,
                         ", \"table\": {\"rows\": [\"variant\"], \"metrics\": [\"camera_ate\"], ",
                         "\"reference\": \"full\"}}"));
  }
  ProcessResult Experiment(const std::vector<std::string>& arguments,
                           test::ProcessSetup setup = {}) const {
    std::vector<std::string> all = {"experiment"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    setup.environment = {StrCat("CLUSTERVO_CACHE=", (folder_.path() / "cache").string()),
                         StrCat("CLUSTERVO_DATA=", data().string())};
    return RunProgram(all, setup);
  }
  ProcessResult Run(const std::vector<std::string>& more = {},
                    const test::ProcessSetup& setup = {}) const {
    std::vector<std::string> all = {
        "run", (folder_.path() / "suite.json").string(), "-o", out().string(), "-j", "1"};
    all.insert(all.end(), more.begin(), more.end());
    return Experiment(all, setup);
  }
  Json Status() const {
    return ParseJson(Experiment({"status", out().string(), "--json"}).out, "status");
  }
  std::vector<fs::path> Results() const {
    std::vector<fs::path> results;
    for (const auto& job : fs::directory_iterator(out() / "jobs")) {
      if (fs::exists(job.path() / "result.json")) results.push_back(job.path() / "result.json");
    }
    std::sort(results.begin(), results.end());
    return results;
  }

  test::TempFolder folder_;
};

TEST_F(CliExperiment, RunsOnlyUnfinishedJobs) {
  const ProcessResult run = Run();
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, "small: 2 jobs: 2 done\n");
  EXPECT_THAT(run.err, HasSubstr("100 %  2/2 jobs  "));
  const ProcessResult status = Experiment({"status", out().string()});
  EXPECT_EQ(status.exit_code, 0);
  EXPECT_EQ(status.out, "small: 2 jobs: 2 done\n");

  // Finished jobs are not run again, but a damaged result is replaced.
  const std::vector<fs::path> results = Results();
  ASSERT_EQ(results.size(), 2U);
  const std::string bytes = test::ReadFile(results[0]);
  const auto kept = fs::last_write_time(results[1]);
  test::CutFile(results[0]);
  folder_.Write(results[0].parent_path() / ".result.json.tmp-node.1-0", "of a killed process");
  EXPECT_EQ(Status()["counts"]["missing"], 1);
  const ProcessResult again = Run();
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.err, HasSubstr("1/1 jobs"));
  EXPECT_EQ(test::ReadFile(results[0]), bytes);
  EXPECT_EQ(fs::last_write_time(results[1]), kept);
  EXPECT_FALSE(fs::exists(results[0].parent_path() / ".result.json.tmp-node.1-0"));
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
  const ProcessResult run = Run();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr(StrCat("in use by process ", ::getpid(), " on ")));
  EXPECT_EQ(test::LineCount(run.err), 1U);
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
  const Json status = Status();
  EXPECT_EQ(status["counts"]["failed"], 2);
  EXPECT_EQ(status["jobs"][0]["state"], "failed");
  EXPECT_EQ(status["jobs"][0]["message"], "stopped after 0.01 s");

  if (kLimitsMemory) {
    for (const char* limit_mb : {"60", "90"}) {
      EXPECT_EQ(Run({"--memory-limit", limit_mb}).exit_code, 1);
      EXPECT_THAT(Status()["jobs"][0]["message"].get<std::string>(),
                  HasSubstr(StrCat("memory limit of ", limit_mb, " MB")));
    }
  }
  EXPECT_EQ(Run().out, "small: 2 jobs: 2 done\n");
  EXPECT_EQ(Status()["counts"]["failed"], 0);
}

TEST_F(CliExperiment, BadInputGivesOneLine) {
  const std::vector<std::vector<std::string>> bad = {{"--engine", "cloud"},
                                                     {"-j", "0"},
                                                     {"--time-limit", "-1"},
                                                     {"--memory-limit", "nan"},
                                                     {"--seeds", "0"}};
  for (const std::vector<std::string>& flags : bad) {
    const ProcessResult run = Run(flags);
    EXPECT_EQ(run.exit_code, 2) << flags[0];
    EXPECT_EQ(test::LineCount(run.err), 1U) << run.err;
  }
  const ProcessResult option = Run({"--set", "no.such=1"});
  EXPECT_NE(option.exit_code, 0);
  EXPECT_EQ(test::LineCount(option.err), 1U) << option.err;
  const ProcessResult status = Experiment({"status", data().string()});
  EXPECT_EQ(status.exit_code, 1);
  EXPECT_THAT(status.err, HasSubstr("found no plan.json"));
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
  const ProcessResult status = Experiment({"status", out().string()});
  const std::string after = test::ReadFile(Results()[0]);
  ::umount(out().c_str());
  EXPECT_EQ(first, 0);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("cannot write: Read-only file system"));
  EXPECT_EQ(test::LineCount(run.err), 1U);
  EXPECT_EQ(status.out, "small: 2 jobs: 2 done\n");
  EXPECT_EQ(after, bytes);
}

TEST_F(CliExperiment, IncompleteFilesAreNoResults) {
  // The limit is below the size of a result, at least 20 kB, and above that of the plan, logs and
  // failure records.
  const ProcessResult run = Run({}, {.file_size_limit = 6000});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.out + run.err, HasSubstr("cannot write: "));
  EXPECT_TRUE(Results().empty());
  EXPECT_EQ(Run().out, "small: 2 jobs: 2 done\n");
}

}  // namespace
}  // namespace cvo
