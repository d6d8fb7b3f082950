// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// No command may overwrite its inputs or the results of another, or ignore that its output could
// not be written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <sstream>

#include "core/base/error.h"
#include "tests/experiments/cli/process.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/support/temp_folder.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using test::Arguments;
using test::ProcessResult;
using testing::AllOf;
using testing::HasSubstr;

// Returns the names of the subcommands of a command, as listed in its help.
Arguments CommandsOf(Arguments command) {
  command.emplace_back("--help");
  std::istringstream help(test::RunProgram(command).out);
  Arguments names;
  bool listed = false;
  for (std::string line; std::getline(help, line);) {
    if (listed && line.starts_with("  ") && line[2] != ' ') {
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
    }
    listed = line.empty() ? listed && names.empty() : listed || line == "Subcommands:";
  }
  return names;
}

// Returns every command of the program: {"run"}, {"synth", "render"}, ...
const std::vector<Arguments>& AllCommands() {
  static std::vector<Arguments> all;
  if (!all.empty()) return all;
  for (const std::string& name : CommandsOf({})) {
    const Arguments below = CommandsOf({name});
    if (below.empty()) all.push_back({name});
    for (const std::string& last : below) all.push_back({name, last});
  }
  return all;
}

bool StartsWith(const Arguments& arguments, const Arguments& start) {
  return arguments.size() >= start.size() &&
         std::equal(start.begin(), start.end(), arguments.begin());
}

bool IsIn(const std::vector<Arguments>& list, const Arguments& command) {
  return std::any_of(list.begin(), list.end(),
                     [&](const Arguments& arguments) { return StartsWith(arguments, command); });
}

// Provides a sequence, a run on it, and a suite that was run on it.
class CliOutputs : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<test::TempFolder>();
    test::WriteTinySequence(Path("data/wall"), 4);
    test::WriteTinyNetwork(*folder_);
    folder_->Write("two.names", "person\ncar\n");
    folder_->Write("suite.json",
                   "{\"name\": \"small\", \"sequences\": [{\"folder\": \"wall\"}], \"variants\": "
                   "[\"static\"], \"seeds\": 3, \"table\": {\"rows\": [\"variant\"], "
                   "\"metrics\": [\"camera_trpe_1_frame\"], \"reference\": \"static\"}}");
    const Arguments suite = {"experiment", "run", Path("suite.json"), "-o", Path("suite"), "-q"};
    const Arguments table = {"experiment", "table", Path("suite")};
    const Arguments baseline = {"check", Path("suite"), "--write-baseline", Path("base.json")};
    const Arguments run = {"run", Path("data/wall"), "-o", Path("run"), "-q", "--landmarks"};
    for (const Arguments& arguments : {suite, table, baseline, run}) {
      const ProcessResult result = Run(arguments);
      ASSERT_EQ(result.exit_code, 0) << result.err;
    }
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static std::string Path(const std::string& name) { return (folder_->path() / name).string(); }
  static ProcessResult Run(const Arguments& arguments, const std::string& out = "") {
    return test::RunProgram(arguments, {.environment = {StrCat("CLUSTERVO_CACHE=", Path("cache")),
                                                        StrCat("CLUSTERVO_DATA=", Path("data"))},
                                        .out = out});
  }
  // Returns the content of every file below a folder, by path.
  static std::map<std::string, std::string> Files(const std::string& name) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(Path(name))) {
      if (entry.is_regular_file()) files[entry.path()] = test::ReadFile(entry.path());
    }
    return files;
  }
  static void ExpectRefused(const Arguments& arguments) {
    const auto sequence = Files("data");
    const auto run = Files("run");
    const auto suite = Files("suite");
    const ProcessResult result = Run(arguments);
    std::string line;
    for (const std::string& argument : arguments) line += argument + " ";
    EXPECT_EQ(result.exit_code, 2) << line << result.err;
    EXPECT_EQ(test::LineCount(result.err), 1U) << line << result.err;
    EXPECT_THAT(result.err, AllOf(HasSubstr("found "), HasSubstr("expected "))) << line;
    EXPECT_TRUE(Files("data") == sequence) << line;
    EXPECT_TRUE(Files("run") == run) << line;
    EXPECT_TRUE(Files("suite") == suite) << line;
  }

  // Returns one call of every command that writes, with its output at or below `out`.
  static std::vector<Arguments> WritersTo(const std::string& out) {
    return {
        {"run", Path("data/wall"), "-o", out},
        {"eval", "trajectory", "--sequence", Path("data/wall"), "--estimate",
         Path("run/camera.tum"), "-o", out},
        {"overlay", Path("run"), "-o", out},
        {"crf", Path("data/wall"), "--figure", "0", "-o", out + "/terms.png"},
        {"detect", Path("data/wall"), "--model", Path("tiny.cfg"), "--names", Path("two.names"),
         "-o", out + "/boxes.txt"},
        {"info", "--left", Path("data/wall/image_0"), "--right", Path("data/wall/image_1"),
         "--calib", Path("data/wall/calib.txt"), "-o", out},
        {"plot", Path("suite"), "-o", out},
        {"report", Path("suite"), "-o", out},
        {"synth", "render", "tiny", "-o", out},
        {"synth", "render", "tiny", "--preview", "-o", out + "/sheet.png"},
        {"experiment", "run", Path("suite.json"), "-o", out},
        {"experiment", "table", Path("suite"), "--format", "csv", "-o", out + "/table.csv"},
        {"experiment", "compare", Path("suite"), Path("suite"), "-o", out + "/table.txt"},
        {"check", Path("suite"), "--write-baseline", out + "/base.json"},
        {"check", Path("suite"), "--baseline", Path("base.json"), "--junit", out + "/gate.xml"},
        {"check", Path("suite"), "--baseline", Path("base.json"), "--markdown", out + "/gate.md"},
        {"plot", Path("run"), "-o", out + "/plot.svg"}};
  }

  static std::unique_ptr<test::TempFolder> folder_;
};

std::unique_ptr<test::TempFolder> CliOutputs::folder_;

TEST_F(CliOutputs, NothingIsWrittenIntoASequence) {
  fs::create_directory_symlink(Path("data/wall/image_0"), Path("link"));
  for (const Arguments& arguments : WritersTo(Path("link"))) ExpectRefused(arguments);
  for (const char* place : {"data/wall", "data/wall/image_0", "data/wall/new/below"}) {
    for (std::size_t i : {0U, 7U, 11U}) ExpectRefused(WritersTo(Path(place))[i]);
  }
}

TEST_F(CliOutputs, EveryWritingCommandIsCovered) {
  for (Arguments command : AllCommands()) {
    const bool tried = IsIn(WritersTo(""), command);
    command.emplace_back("--help");
    const bool writes = test::RunProgram(command).out.find("--output") != std::string::npos;
    EXPECT_TRUE(tried || !writes) << command.front() << " " << command[1];
  }
}

TEST_F(CliOutputs, InputsAreNeverOverwritten) {
  const std::vector<Arguments> commands = {
      {"overlay", Path("run"), "-o", Path("run")},
      {"overlay", Path("run"), "-o", Path("run/clusters")},
      {"plot", Path("suite"), "-o", Path("suite")},
      {"report", Path("suite"), "-o", Path("suite")},
      {"run", Path("data/wall"), "-o", Path("suite/jobs/mine")},
      {"run", Path("data/wall"), "-o", Path("suite"), "--force"},
      {"experiment", "run", Path("suite.json"), "-o", Path("run")},
      {"experiment", "run", Path("other.json"), "-o", Path("suite")},
      {"run", Path("data/wall"), "-o", Path("mine"), "--config", Path("mine/result.json")},
      {"eval", "trajectory", "--sequence", Path("data/wall"), "--estimate", Path("run/camera.tum"),
       "--objects", Path("run/clusters"), "-o", Path("run/clusters")},
      {"experiment", "run", Path("suite.json"), "-o", Path("data")},
      {"experiment", "table", Path("suite"), "--format", "csv", "-o", Path("suite/plan.json")},
      {"experiment", "table", Path("suite"), "-o", Path("run/result.json")},
      {"experiment", "table", Path("suite"), "-o", Path("other.json")},
      {"check", Path("suite"), "--write-baseline", Path("suite/plan.json")},
      {"check", Path("suite"), "--baseline", Path("base.json"), "--markdown", Path("base.json")},
      {"check", Path("suite"), "--write-baseline", Path("run/result.json")},
      {"experiment", "table", Path("suite"), "--format", "csv", "-o", Path("run/objects.csv")}};
  fs::create_directories(Path("run/clusters"));
  std::string other = test::ReadFile(Path("suite.json"));
  folder_->Write("other.json", other.replace(other.find("small"), 5, "other"));
  folder_->Write("mine/result.json", "{}");
  for (const Arguments& arguments : commands) ExpectRefused(arguments);
}

TEST_F(CliOutputs, FailedOutputIsAnError) {
  const std::string wall = Path("data/wall"), suite = Path("suite"), run = Path("run");
  const std::string label = "0 1 Car 0 0 0 10 20 90 80 1.5 1.6 3.9 1 2 30 0.1";
  folder_->Write("label.txt", label + "\n");
  folder_->Write("box.txt", label + " 0.5\n");
  const std::vector<Arguments> commands = {
      {"--version"},
      {"--help"},
      {"run", "--help"},
      {"run", wall, "-o", Path("run_2"), "-q"},
      {"eval", "trajectory", "--groundtruth", run + "/camera.tum", "--estimate",
       run + "/camera.tum"},
      {"eval", "trajectory", "--groundtruth", run + "/camera.tum", "--estimate",
       run + "/camera.tum", "--json"},
      {"eval", "trajectory", "--sequence", wall, "--estimate", run + "/camera.tum", "--json"},
      {"detect", wall, "--model", Path("tiny.cfg"), "--names", Path("two.names"), "-o",
       Path("boxes.txt")},
      {"info", "--left", wall + "/image_0", "--right", wall + "/image_1", "--calib",
       wall + "/calib.txt", "-o", Path("imported")},
      {"info", wall},
      {"list", "variants"},
      {"list", "options"},
      {"list", "scenes"},
      {"synth", "check", Path("scene")},
      {"synth", "render", "tiny", "-o", Path("scene_2"), "-q", "--frames", "0:2"},
      {"synth", "render", "tiny", "--preview", "-o", Path("sheet.png"), "--frames", "0:2", "-q"},
      {"list", "suites"},
      {"list", "scenes", "room"},
      {"eval", "boxes", "--labels", Path("label.txt"), "--estimate", Path("box.txt")},
      {"experiment", "run", Path("suite.json"), "-o", suite, "--dry-run"},
      {"experiment", "run", Path("suite.json"), "-o", suite, "-q"},
      {"experiment", "table", suite},
      {"experiment", "table", suite, "--format", "csv"},
      {"experiment", "table", suite, "--times"},
      {"experiment", "compare", suite, suite},
      {"check", suite, "--baseline", Path("base.json")},
      {"check", suite, "--write-baseline", Path("base.json")},
      {"overlay", run, "-o", Path("pictures"), "-q"},
      {"report", suite, "-o", Path("page")},
      {"plot", suite, "-o", Path("figures")},
      {"plot", run, "-o", Path("plot.svg")},
      {"explain", Path("scene_run")},
      {"crf", Path("scene"), "-q"}};
  const ProcessResult rendered =
      Run({"synth", "render", "tiny", "-o", Path("scene"), "-q", "--frames", "0:2"});
  const bool draws = rendered.exit_code == 0;
  if (draws) Run({"run", Path("scene"), "-o", Path("scene_run"), "-q", "--landmarks"});
  for (const Arguments& arguments : commands) {
    const bool needs_scene = IsIn({{"explain"}, {"synth"}, {"crf"}}, {arguments[0]});
    if (!draws && needs_scene) continue;
    std::string line;
    for (const std::string& argument : arguments) line += argument + " ";
    const bool closed = arguments.back() == "--json" || arguments.back() == "-q";
    const ProcessResult result = Run(arguments, closed ? "closed" : "/dev/full");
    EXPECT_EQ(result.exit_code, 1) << line << "\n" << result.err;
    EXPECT_THAT(
        result.err,
        testing::EndsWith("clustervo: error: standard output: not all output could be written\n"))
        << line;
  }
  for (const Arguments& command : AllCommands()) {
    EXPECT_TRUE(IsIn(commands, command)) << command.front() << " " << command.back();
  }
  EXPECT_EQ(AllCommands().size(), 17U);
}

}  // namespace
}  // namespace cvo
