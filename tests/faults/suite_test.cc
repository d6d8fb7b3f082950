// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Regression tests for faults of suites, their plans and their results.
#include <sstream>

#include "core/files/atomic_file.h"
#include "tests/faults/fault_folder.h"

namespace cvo::suite_test {
namespace {

namespace fs = std::filesystem;
using test::ProcessResult;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

class SuiteFaults : public test::FaultFolder {
 protected:
  // Expects that no table is made of the first run.
  void ExpectNoRun(const std::string& case_name) const {
    const ProcessResult result = Run({"experiment", "table", out()});
    EXPECT_EQ(result.exit_code, 1) << case_name << ": " << result.out;
  }
  void RunSuite() const {
    ExpectDone(Suite("run"));
    ExpectDone({"check", out(), "--write-baseline", At("baseline.json"), "--gate-seeds", "2"});
  }
};

// Commands used to disagree on what is a valid result, and a row to show the value of another job.
TEST_F(SuiteFaults, OnlyValidResultsOfThePlanCount) {
  RunSuite();
  const std::string good = ReadFileBytes(FirstResult());
  const std::string status = "\"status\": \"ok\"";
  const std::vector<std::string> spoilt = {
      Replaced(good, "\"total_frames\": 3", "\"total_frames\": nan"),
      Replaced(good, status, "\"status\": \"o\x01k\""),
      Replaced(good, status, "\"status\": \"ok\xff\""), std::string(100'000, '['),
      good.substr(0, good.size() / 2)};
  for (const std::string& bytes : spoilt) {
    WriteFileBytes(FirstResult(), bytes);
    ExpectNoRun(bytes.substr(0, 20));
  }
  EXPECT_EQ(Run({"check", out(), "--baseline", At("baseline.json")}).exit_code, 1);
  ExpectDone(Suite("run"));  // recreates it
  EXPECT_EQ(ReadFileBytes(FirstResult()), good);

  const std::string plan = ReadFileBytes(At("out/plan.json"));
  const std::vector<std::function<void(Json&)>> edits = {
      [](Json& jobs) { std::swap(jobs[0]["job"], jobs[1]["job"]); },
      [](Json& jobs) { jobs[0]["seed"] = 77; },
      [](Json& jobs) { jobs[0]["oracle"] = {"camera"}; },
      [](Json& jobs) { jobs[0]["content"] = std::string(64, 'a'); },
      [](Json& jobs) { jobs[0]["parameters"]["noise.corner_px"] = 0.6; },
      [](Json& jobs) { jobs[0].erase("job"); },
      [](Json& jobs) { jobs[0]["job"] = "../../data"; }};
  for (std::size_t i = 0; i < edits.size(); ++i) {
    Edit(At("out/plan.json"), [&](Json& json) { edits[i](json["jobs"]); });
    ExpectNoRun(StrCat("edit ", i));
    WriteFileBytes(At("out/plan.json"), plan);
  }
}

// Grids, lists and counts too large to run used to take all memory, or minutes, before an error.
TEST_F(SuiteFaults, Size) {
  const auto axis = [](int steps) { return Json{{"from", 0.1}, {"to", 0.9}, {"steps", steps}}; };
  Json list = Json::array();
  for (int i = 0; i < 100'001; ++i) list.push_back(i);
  Json sequences = Json::array();
  for (int i = 0; i < 100'001; ++i) {
    sequences.push_back({{"folder", "wall"}, {"name", StrCat("s", i)}});
  }
  const std::vector<std::pair<std::string, Json>> changes = {
      {"grid", {{"noise.corner_px", axis(1000)}, {"crf.eta", axis(1000)}}},
      {"grid", {{"noise.corner_px", axis(200'000)}}},
      {"grid", {{"noise.corner_px", list}}},
      {"seeds", list},
      {"seeds", 100'000},
      {"sequences", sequences},
      {"sequences", Json::array({Json{{"family", "room"}, {"seeds", "0:4294967295"}}})}};
  for (const auto& [key, value] : changes) {
    Json json = ReadJson(At("suite.json"));
    json[key] = value;
    const std::string suite = folder_.Write("large.json", json.dump());
    ExpectOneLine({"experiment", "run", suite, "-o", out(), "--data", At("data"), "--dry-run"},
                  AnyOf(1, 2), "expected");
  }
}

// A link in the name of a suite used to stay active in the report for pull requests.
TEST_F(SuiteFaults, Markdown) {
  RunSuite();
  Edit(At("out/plan.json"), [](Json& plan) {
    plan["suite"]["name"] = "[x](javascript:y) <b> https://a.b ![i](c) www.d.e \x1b[31m";
  });
  const std::string file = At("check.md");
  ExpectOneLine({"check", out(), "--baseline", At("baseline.json")}, 1, "the suite \"[x]");
  ExpectDone({"check", out(), "--write-baseline", At("other.json"), "--gate-seeds", "2"});
  ExpectDone({"check", out(), "--baseline", At("other.json"), "--markdown", file});
  const std::string text = ReadFileBytes(file);
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
  const std::string verdict = text.substr(0, text.find("\n\n"));
  for (const char* active : {"](", "<b>", "https://", "www."}) {
    EXPECT_THAT(verdict, Not(HasSubstr(active)));
  }
  // Everything but the verdict is in an indented block of code, where nothing is active.
  std::istringstream lines(text.substr(text.find("\n\n") + 2));
  for (std::string line; std::getline(lines, line);) EXPECT_TRUE(line.starts_with("    ")) << line;
}

// Killed processes used to leave files behind that were never removed.
TEST_F(SuiteFaults, Leftovers) {
  std::vector<fs::path> left;
  const auto leave = [&](const fs::path& folder) {
    left.push_back(folder_.Write(folder / TemporaryName("x") / "a", "half").parent_path());
    fs::last_write_time(left.back(), fs::file_time_type::clock::now() - std::chrono::hours(25));
  };
  leave("cache/frontend");
  ExpectDone(Suite("run"));
  leave("out");
  leave("out/failed");
  left.push_back(folder_.Write(fs::path("out") / TemporaryName("plan.json"), "half"));
  const fs::path live = folder_.Write(fs::path("out") / TemporaryName("live"), "table");
  fs::remove(FirstResult());
  ExpectDone(Suite("run"));
  EXPECT_TRUE(fs::exists(live));
  for (const fs::path& path : left) EXPECT_FALSE(fs::exists(path)) << path;
}

// Old files behind a link used to be removed as if they belonged to the run.
TEST_F(SuiteFaults, Symlinks) {
  const fs::path mine = folder_.Write("mine/99.tum", "mine");
  fs::create_directories(out());
  fs::create_directory_symlink(mine.parent_path(), fs::path(out()) / "clusters");
  ExpectOneLine(RunWall(), 1, "clusters: found a link");
  EXPECT_EQ(ReadFileBytes(mine), "mine");
  fs::remove(fs::path(out()) / "clusters");
  const fs::path file = folder_.Write("mine.json", "mine");
  fs::create_symlink(file, fs::path(out()) / "result.json");
  ExpectDone(RunWall({"--force"}));
  EXPECT_EQ(ReadFileBytes(file), "mine");
}

// The error over all pairs of poses used to take quadratic time: 11 s for 30,000 poses, so hours
// for 10^6.
TEST_F(SuiteFaults, Quadratic) {
  std::string truth;
  std::string estimate;
  for (int i = 0; i < 120'000; ++i) {
    const char* turned = i % 2 == 0 ? " 0 0 0 0 0 1\n" : " 0 0 0 0 0.6 0.8\n";
    truth += StrCat(i, " ", i, turned);
    estimate += StrCat(i, " ", i + i % 2, turned);
  }
  const std::string a = folder_.Write("a.tum", truth);
  const std::string b = folder_.Write("b.tum", estimate);
  const ProcessResult eval =
      Run({"eval", "trajectory", "--groundtruth", a, "--estimate", b, "--json"});
  EXPECT_EQ(eval.exit_code, 0) << eval.err;
  EXPECT_THAT(eval.out, HasSubstr("camera_trpe_all_pairs"));
  EXPECT_THAT(eval.out, Not(HasSubstr("camera_rrpe_all_pairs")));
  EXPECT_THAT(eval.out, HasSubstr("more than 100000 poses"));
}

}  // namespace
}  // namespace cvo::suite_test
