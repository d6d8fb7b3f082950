// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// `clustervo figures` as a process, on hand-made results. Drawing needs Chromium.
#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdlib>

#include "tests/experiments/cli/process.h"
#include "tests/reports/results/result_files.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using test::BodyOf;
using test::Json;
using test::ProcessResult;
using test::ProcessSetup;
using test::RunProgram;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

constexpr char kHostile[] = "room <script>alert(1)</script>";

// Two variants on one sequence whose name contains markup.
struct HostileSuite : test::SuiteResults {
  HostileSuite() {
    table["rows"] = {"variant"};
    table["reference"] = "full";
    for (const auto& [variant, error_m] : {std::pair{"full", 0.02}, {"2d", 0.04}}) {
      const Json bodies = {BodyOf(1, {error_m, error_m, -1.0})};
      Add(test::WithBodies(test::Result(kHostile), bodies), variant, 1);
    }
  }
  fs::path out() const { return folder().path() / "figures"; }
  ProcessResult Draw(std::vector<std::string> more, const ProcessSetup& setup = {}) const {
    std::vector<std::string> arguments = {"figures", Written().string(), "-o", out().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunProgram(arguments, setup);
  }
};

bool HasBrowser() {
  const char* chosen = std::getenv("CLUSTERVO_BROWSER");
  return ::access(chosen != nullptr ? chosen : "/usr/bin/chromium", X_OK) == 0;
}

TEST(CliFigures, JsonNeedsNoBrowser) {
  const HostileSuite suite;
  const ProcessResult run =
      suite.Draw({"--format", "json"}, {.environment = {"CLUSTERVO_BROWSER=/nowhere"}});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("error-reduction.json: Change in error relative to full"),
                             HasSubstr("not drawn: Time by stage")));
  const std::string text = test::ReadFile(suite.out() / "error-reduction.json");
  const Json figure = Json::parse(text);
  EXPECT_EQ(figure["layout"]["yaxis"]["ticktext"][1], "room &lt;script&gt;alert(1)&lt;/script&gt;");
  suite.Draw({"--format", "json"});
  EXPECT_EQ(test::ReadFile(suite.out() / "error-reduction.json"), text);
}

TEST(CliFigures, DrawsOneFigureByName) {
  const HostileSuite suite;
  const ProcessResult run = suite.Draw({"--format", "json", "--only", "error-reduction"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(fs::exists(suite.out() / "error-reduction.json"));
  EXPECT_FALSE(fs::exists(suite.out() / "error-over-coverage-object-ate.json"));
  EXPECT_THAT(run.out, Not(HasSubstr("not drawn")));
  test::ExpectError(
      suite.Draw({"--only", "error-reductoin"}),
      "--only: found \"error-reductoin\" (did you mean error-reduction?), expected one of: ", 2);
}

TEST(CliFigures, MissingInputGivesOneLine) {
  const HostileSuite suite;
  test::ExpectError(suite.Draw({}, {.environment = {"CLUSTERVO_BROWSER=/nowhere"}}),
                    "/nowhere: found a program that cannot be run, expected a Chromium");
  EXPECT_FALSE(fs::exists(suite.out())) << "nothing is left of what was not made";
  test::ExpectError(suite.Draw({}, {.environment = {"CLUSTERVO_BROWSER=/bin/false"}}),
                    "/bin/false: found exit code 1");
  test::ExpectError(suite.Draw({}, {.environment = {"CLUSTERVO_BROWSER=/bin/true"}}),
                    "browser: found 0 figures drawn");
  const test::TempFolder empty;
  test::ExpectError(RunProgram({"figures", empty.path().string(), "-o", suite.out().string()}),
                    "plan.json");
  const ProcessResult usage = suite.Draw({"--format", "png"});
  EXPECT_EQ(usage.exit_code, 2);
  EXPECT_EQ(test::LineCount(usage.err), 1U);
}

TEST(CliFigures, DrawsNothingForASuiteThatHasNotRun) {
  test::SuiteResults suite;
  suite.Plan("room", "full");
  const fs::path out = suite.folder().path() / "figures";
  const ProcessResult run = RunProgram({"figures", suite.Written().string(), "-o", out.string()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(StartsWith("not drawn: "), HasSubstr("Error over coverage")));
  EXPECT_FALSE(fs::exists(out));
}

TEST(CliFigures, NamesStayTextAndBytesAreReproducible) {
  if (!HasBrowser()) GTEST_SKIP() << "no Chromium: /usr/bin/chromium or CLUSTERVO_BROWSER";
  const HostileSuite suite;
  const std::vector<std::string> one = {"--only", "error-reduction"};
  const ProcessResult run = suite.Draw(one);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string svg = test::ReadFile(suite.out() / "error-reduction.svg");
  EXPECT_THAT(svg, StartsWith("<svg"));
  EXPECT_THAT(svg, AllOf(HasSubstr("Change in error relative to full, in percent"),
                         HasSubstr("room &#60;script&#62;alert(1)&#60;/script&#62;"),
                         HasSubstr("(+100)"), HasSubstr("In brackets:")));
  EXPECT_THAT(svg, Not(HasSubstr("<script")));
  suite.Draw(one);
  EXPECT_EQ(test::ReadFile(suite.out() / "error-reduction.svg"), svg);
}

TEST(CliFigures, PdfIsReproducible) {
  if (!HasBrowser()) GTEST_SKIP() << "no Chromium: /usr/bin/chromium or CLUSTERVO_BROWSER";
  const HostileSuite suite;
  const std::vector<std::string> one = {"--only", "error-reduction", "--format", "pdf"};
  const ProcessResult run = suite.Draw(one);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string pdf = test::ReadFile(suite.out() / "error-reduction.pdf");
  EXPECT_THAT(pdf, StartsWith("%PDF-"));
  suite.Draw(one);
  EXPECT_TRUE(test::ReadFile(suite.out() / "error-reduction.pdf") == pdf);
}

}  // namespace
}  // namespace cvo
