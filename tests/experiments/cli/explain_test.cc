// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// `clustervo explain` as a process, on three frames of a rendered scene.
#include <gmock/gmock.h>

#include <memory>

#include "core/files/images/image_file.h"
#include "tests/experiments/cli/process.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using test::ExpectError;
using test::ProcessResult;
using test::RunProgram;
using testing::AllOf;
using testing::HasSubstr;

class CliExplain : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<test::TempFolder>();
    RunProgram({"synth", "render", "tiny", "-o", Path("scene"), "--frames", "0:3"});
    RunProgram({"run", Path("scene"), "-o", Path("run"), "--landmarks", "--detections", "oracle"});
  }
  static void TearDownTestSuite() { folder_.reset(); }
  void SetUp() override {
    if (!fs::exists(Path("run"))) GTEST_SKIP() << "the scene cannot be drawn";
  }
  static std::string Path(const std::string& name) { return (folder_->path() / name).string(); }

  static std::unique_ptr<test::TempFolder> folder_;
};

std::unique_ptr<test::TempFolder> CliExplain::folder_;

TEST_F(CliExplain, ListsBodiesAndExplainsOneWithOracles) {
  const ProcessResult list = RunProgram({"explain", Path("run")});
  ASSERT_EQ(list.exit_code, 0) << list.err;
  EXPECT_THAT(list.out, AllOf(HasSubstr("within 10 cm  mostly"), HasSubstr("chair_1")));
  const ProcessResult one =
      RunProgram({"explain", Path("run"), "chair_1", "-o", Path("chair.svg"), "--oracles", "-q"});
  ASSERT_EQ(one.exit_code, 0) << one.err;
  EXPECT_THAT(one.out, AllOf(HasSubstr("chair_1 (Chair, stands, cluster "),
                             HasSubstr("first estimated"), HasSubstr("landmarks at first"),
                             HasSubstr("as run: "), HasSubstr("true labels: ")));
  const std::string chart = test::ReadFile(Path("chair.svg"));
  EXPECT_THAT(chart, AllOf(testing::StartsWith("<svg"), HasSubstr("position error (cm)"),
                           HasSubstr("first estimated")));
  ASSERT_EQ(RunProgram({"explain", Path("run"), "chair_1", "-o", Path("again.svg")}).exit_code, 0);
  EXPECT_EQ(chart, test::ReadFile(Path("again.svg")));
}

// The run records where its boxes were read from.
TEST_F(CliExplain, FindsBoxesOutsideTheSequence) {
  fs::copy_file(Path("scene") + "/detections/oracle.txt", Path("elsewhere.txt"));
  const ProcessResult run = RunProgram({"run", Path("scene"), "-o", Path("given"), "--landmarks",
                                        "--detections", Path("elsewhere.txt"), "-q"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  fs::remove_all(Path("scene") + "/detections");
  const ProcessResult one = RunProgram({"explain", Path("given"), "chair_1", "--oracles", "-q"});
  ASSERT_EQ(one.exit_code, 0) << one.err;
  EXPECT_THAT(one.out, AllOf(HasSubstr("3 of 3"), HasSubstr("true labels: ")));
  EXPECT_EQ(one.err, "");
  fs::remove(Path("elsewhere.txt"));
  EXPECT_THAT(RunProgram({"explain", Path("given"), "chair_1"}).err,
              HasSubstr("the run's detection file was not found"));
}

TEST_F(CliExplain, BadInputGivesOneLine) {
  ExpectError(RunProgram({"explain", Path("run"), "chairs_1"}),
              "BODY: found \"chairs_1\" (did you mean chair_1?), expected one of ball_1, ");
  ExpectError(RunProgram({"explain", Path("scene")}), "scene: found no result.json");
  EXPECT_EQ(RunProgram({"explain", Path("run"), "--oracles"}).exit_code, 2);
  EXPECT_EQ(RunProgram({"explain", Path("run"), "chair_1", "-o", Path("a.gif")}).exit_code, 2);
  folder_->Write("bare/result.json", "{}");
  ExpectError(RunProgram({"explain", Path("bare")}), "expected a run with --landmarks");
}

}  // namespace
}  // namespace cvo
