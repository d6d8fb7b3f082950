// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// `clustervo check` and `report` on hand-made results; `explain` and `crf` on three rendered
// frames.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <sstream>

#include "tests/experiments/cli/process.h"
#include "tests/reports/gate/gate_folder.h"
#include "tests/reports/results/result_files.h"

namespace cvo::test::reports_test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

class CliCheckTest : public testing::Test {
 protected:
  void SetUp() override {
    const ProcessResult write =
        RunProgram({"check", folder_.path(), "--write-baseline", baseline_, "--gate-seeds", "2"});
    ASSERT_EQ(write.exit_code, 0) << write.err;
    EXPECT_THAT(write.out, StartsWith("gate: 16 runs with 2 metrics; checked runs need 2 seeds"));
  }
  ProcessResult Check(Arguments more = {}) const {
    more.insert(more.begin(), {"check", folder_.path(), "--baseline", baseline_});
    return RunProgram(more);
  }

  TempFolder temp_;
  GateFolder folder_;
  std::string baseline_ = temp_.path() / "new" / "baseline.json";
};

TEST_F(CliCheckTest, SameResultsPass) {
  const ProcessResult check = Check();
  EXPECT_EQ(check.exit_code, 0) << check.out << check.err;
  EXPECT_THAT(check.out, StartsWith("gate: 16 runs compared with those of 0123456789ab: 0 worse"));
  EXPECT_THAT(check.out, HasSubstr("\nno regression\n"));
  EXPECT_EQ(check.err, "");
}

TEST_F(CliCheckTest, RegressionFailsAndIsWritten) {
  for (int seed = 1; seed <= 4; ++seed) {
    folder_.EditMetric(GateFolder::Id("room", "full", seed), 1, 0.2);
  }
  const std::string junit = temp_.path() / "check.xml";
  const std::string markdown = temp_.path() / "check.md";
  const ProcessResult check = Check({"--junit", junit, "--markdown", markdown});
  EXPECT_EQ(check.exit_code, 1);
  EXPECT_THAT(check.out, HasSubstr("WORSE"));
  EXPECT_THAT(check.out, HasSubstr("\nregression\n"));
  EXPECT_THAT(ReadFile(junit), HasSubstr("<failure message=\"regression\">gate: 16 runs"));
  EXPECT_THAT(ReadFile(markdown), StartsWith("### Regression\n"));
}

TEST_F(CliCheckTest, WrongUsageGivesOneLine) {
  const auto fails = [&](const Arguments& arguments, int code, const char* part) {
    const ProcessResult process = RunProgram(arguments);
    EXPECT_EQ(process.exit_code, code);
    EXPECT_THAT(process.err, HasSubstr(part));
    EXPECT_EQ(LineCount(process.err), 1U) << process.err;
  };
  const std::string folder = folder_.path();
  fails({"check", folder}, 2, "--baseline or --write-baseline");
  fails({"check", folder, "--baseline", baseline_, "--write-baseline", baseline_}, 2, "excludes");
  fails({"check", folder, "--write-baseline", baseline_, "--junit", "a.xml"}, 2, "--baseline");
  fails({"check", folder, "--baseline", baseline_, "--gate-seeds", "2"}, 2, "--write-baseline");
  fails({"check", temp_.path() / "none", "--baseline", baseline_}, 1, "no such file");
  fails({"check", folder, "--baseline", temp_.path() / "none.json"}, 1, "none.json");
  fails({"check", folder, "--write-baseline", baseline_, "--gate-seeds", "9"}, 1, "found 4 seeds");
}

std::string Page(const fs::path& folder) { return ReadFile(folder / "index.html"); }

TEST(CliReport, WritesOnePageBesideTheResults) {
  SuiteResults suite;
  Json result = Result();
  result["options"]["orb"]["features"] = 1999;
  suite.Add(result);
  const ProcessResult run = RunProgram({"report", suite.Written().string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, IsEmpty());
  const fs::path out = suite.folder().path() / "report";
  EXPECT_EQ(run.out, "written: " + (out / "index.html").string() + "\n");
  EXPECT_THAT(Page(out),
              AllOf(HasSubstr("1 of 1 runs."), HasSubstr("option orb.features: 1999 (default "),
                    HasSubstr("no clusters: the static-world baseline")));
  EXPECT_EQ(std::distance(fs::directory_iterator(out), fs::directory_iterator()), 1);
}

TEST(CliReport, SameBytesInAnyFolder) {
  SuiteResults suite;
  suite.Add(Result());
  const fs::path other = suite.folder().path() / "a" / "b";
  ASSERT_EQ(RunProgram({"report", suite.Written().string()}).exit_code, 0);
  ASSERT_EQ(RunProgram({"report", suite.Written().string() + "/", "-o", other.string()}).exit_code,
            0);
  EXPECT_TRUE(Page(suite.folder().path() / "report") == Page(other));
}

TEST(CliReport, AMissingPartIsReportedAndTheRestIsWritten) {
  SuiteResults suite;  // without a job
  const ProcessResult run = RunProgram({"report", suite.Written().string()});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("missing: suite: plan.json, field jobs: found none"));
  EXPECT_THAT(Page(suite.folder().path() / "report"), HasSubstr("field jobs: found none"));
}

TEST(CliReport, AnInvalidSuiteGivesOneLine) {
  SuiteResults suite;
  ExpectError(RunProgram({"report", suite.folder().path().string()}),
              "plan.json: found no such file", 1);
  EXPECT_FALSE(fs::exists(suite.folder().path() / "report"));
}

class CliExplain : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TempFolder>();
    RunProgram({"synth", "render", "tiny", "-o", Path("scene"), "--frames", "0:3"});
    RunProgram({"run", Path("scene"), "-o", Path("run"), "--landmarks", "--detections", "oracle"});
  }
  static void TearDownTestSuite() { folder_.reset(); }
  void SetUp() override {
    if (!fs::exists(Path("run"))) GTEST_SKIP() << "the scene cannot be drawn";
  }
  static std::string Path(const std::string& name) { return (folder_->path() / name).string(); }

  static std::unique_ptr<TempFolder> folder_;
};

std::unique_ptr<TempFolder> CliExplain::folder_;

TEST_F(CliExplain, ListsBodiesAndExplainsOne) {
  const ProcessResult list = RunProgram({"explain", Path("run")});
  ASSERT_EQ(list.exit_code, 0) << list.err;
  EXPECT_THAT(list.out, AllOf(HasSubstr("within 10 cm  mostly"), HasSubstr("chair_1")));
  const ProcessResult one = RunProgram({"explain", Path("run"), "chair_1"});
  ASSERT_EQ(one.exit_code, 0) << one.err;
  EXPECT_THAT(one.out, AllOf(HasSubstr("chair_1 (Chair, stands, cluster "),
                             HasSubstr("worst error: "), HasSubstr("landmarks at first")));
}

TEST_F(CliExplain, ANumberIsThatOfATrack) {
  fs::copy(Path("run"), Path("tracks"), fs::copy_options::recursive);
  Json truth = ReadJson(Path("tracks") + "/truth.json");
  for (std::size_t i = 0; i < truth["bodies"].size(); ++i) {
    truth["bodies"][i]["name"] = StrCat("track ", i);
  }
  folder_->Write("tracks/truth.json", truth.dump());
  for (const char* name : {"1", "track1", "track 1"}) {
    const ProcessResult one = RunProgram({"explain", Path("tracks"), name});
    EXPECT_THAT(one.out, testing::StartsWith("track 1 (")) << one.err;
  }
}

// The run records where its boxes were read from.
TEST_F(CliExplain, FindsBoxesOutsideTheSequence) {
  fs::copy_file(Path("scene") + "/detections/oracle.txt", Path("elsewhere.txt"));
  const ProcessResult run = RunProgram({"run", Path("scene"), "-o", Path("given"), "--landmarks",
                                        "--detections", Path("elsewhere.txt"), "-q"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  fs::rename(Path("scene") + "/detections", Path("away"));
  const ProcessResult one = RunProgram({"explain", Path("given"), "chair_1"});
  ASSERT_EQ(one.exit_code, 0) << one.err;
  EXPECT_EQ(one.err, "");
  fs::remove(Path("elsewhere.txt"));
  EXPECT_THAT(RunProgram({"explain", Path("given"), "chair_1"}).err,
              HasSubstr("the run's detection file was not found"));
  fs::rename(Path("away"), Path("scene") + "/detections");
}

// The run's own labels are a row of the table: they must have the metrics of the run.
TEST_F(CliExplain, CrfScoresLabelsAsRunsDo) {
  const ProcessResult tried = RunProgram({"crf", Path("scene"), "--detections", "oracle", "-q",
                                          "--figure", "2", "-o", Path("terms.png")});
  ASSERT_EQ(tried.exit_code, 0) << tried.err;
  std::map<std::string, std::vector<double>> rows;
  std::istringstream lines(tried.out);
  std::string line;
  std::getline(lines, line);
  const std::size_t first = line.find("moving precision");
  while (std::getline(lines, line) && line.size() > first) {
    std::istringstream cells(line.substr(first));
    std::vector<double>& row = rows[line.substr(0, line.find("  "))];
    for (double value = 0.0; cells >> value;) row.push_back(value);
  }
  const Json result = ReadJson(Path("run") + "/result.json");
  std::vector<double> of_run;
  for (const char* name : {"moving_precision", "moving_recall", "clustering_iou"}) {
    for (const Json& metric : result["metrics"]) {
      if (metric["name"] == name) of_run.push_back(metric["value"]);
    }
  }
  ASSERT_THAT(of_run, SizeIs(3));
  EXPECT_THAT(rows["run"], testing::Pointwise(testing::DoubleNear(1e-3), of_run)) << tried.out;
  ASSERT_THAT(rows["2D+3D+motion"], SizeIs(3)) << tried.out;
  EXPECT_GT(rows["2D+3D+motion"][2], 0.5) << tried.out;
  ASSERT_THAT(rows["all, printed kernel"], SizeIs(3)) << tried.out;
  EXPECT_LT(rows["all, printed kernel"][2], rows["2D+3D+motion"][2]) << tried.out;
  EXPECT_THAT(ReadFile(Path("terms.png")), StartsWith("\x89PNG"));
}

TEST_F(CliExplain, CrfNeedsTheBodiesOfPixels) {
  ExpectError(RunProgram({"crf", Path("scene"), "--figure", "1"}), "--figure and -o", 2);
  ExpectError(RunProgram({"crf", Path("scene"), "--variant", "none"}), "--variant: ", 2);
  ExpectError(RunProgram({"crf", Path("scene"), "-q", "--figure", "9", "-o", Path("x.png")}),
              "found no frame 9", 1);
  ExpectError(RunProgram({"crf", Path("scene"), Path("none")}), "none: found no such folder", 2);
  WriteTinySequence(Path("wall"), 2);
  ExpectError(RunProgram({"crf", Path("wall"), "-q"}),
              "wall: found no ground truth of the bodies at pixels, expected a rendered scene", 1);
}

TEST_F(CliExplain, BadInputGivesOneLine) {
  ExpectError(RunProgram({"explain", Path("run"), "chairs_1"}),
              "BODY: found \"chairs_1\" (did you mean chair_1?), expected one of ball_1, ");
  ExpectError(RunProgram({"explain", Path("scene")}), "scene: found no result.json");
  folder_->Write("bare/result.json", "{}");
  ExpectError(RunProgram({"explain", Path("bare")}), "expected a run with --landmarks");
}

}  // namespace
}  // namespace cvo::test::reports_test
