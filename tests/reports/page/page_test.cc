// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests the page of a suite's result folder in any state.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "reports/page/page_html.h"
#include "reports/web/assets.h"
#include "tests/reports/results/result_files.h"
#include "tests/support/error_message.h"

namespace cvo::reports {
namespace {

namespace fs = std::filesystem;
using test::BodyOf;
using test::Json;
using test::Result;
using test::SuiteResults;
using test::WithBodies;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

PageContent Read(const fs::path& folder) {
  PageRequest request;
  request.folder = folder;
  return ReadPage(request);
}

// The page without its embedded scripts and style sheet.
std::string OwnHtml(const PageContent& content) {
  std::string html = PageHtml(content);
  for (const std::string_view asset : {AppScript(), PlotlyScript(), AppStyle()}) {
    const auto at = html.find(asset);
    EXPECT_NE(at, std::string::npos);
    html.erase(at, asset.size());
  }
  return html;
}

std::string PageOf(const SuiteResults& suite) { return OwnHtml(Read(suite.Written())); }

std::size_t Occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(Page, StatesWhatWasCompared) {
  SuiteResults suite;
  suite.table["rows"] = {"variant"};
  suite.table["reference"] = "static";
  suite.Add(WithBodies(Result("room"), Json::array({BodyOf(1, {0.125, 0.125})})));
  suite.Add(WithBodies(Result("room"), Json::array({BodyOf(1, {0.25, 0.25})})), "full");
  const std::string page = PageOf(suite);
  EXPECT_THAT(page, HasSubstr("what it is"));
  EXPECT_THAT(page,
              HasSubstr("Compares 2 variants (static and full) on 1 sequence (room) with 1 seed."));
  EXPECT_THAT(page, HasSubstr("2 of 2 runs are complete; none failed."));
  EXPECT_THAT(page, HasSubstr("Undecided (1 pair, 6 needed): object ATE"));
  EXPECT_THAT(page, HasSubstr("Content-Security-Policy"));
}

TEST(Page, EscapesNamesAndMessages) {
  SuiteResults suite;
  suite.name = "<img src=x onerror=alert(1)>";
  const std::string hostile = "</script><script>alert(2)</script>\"'><b>";
  suite.Add(Result(hostile));
  suite.Plan("<i>room</i>", "<svg onload=alert(3)>");
  suite.AddFailure("<!--" + hostile);
  const std::string page = PageOf(suite);
  for (const char* markup : {"<img", "<script>alert", "<i>", "<svg", "<!--", "<b>"}) {
    EXPECT_THAT(page, Not(HasSubstr(markup))) << markup;
  }
  EXPECT_EQ(Occurrences(page, "</script"), Occurrences(page, "<script"));
  EXPECT_THAT(page, HasSubstr("&lt;svg onload=alert(3)&gt;"));
}

TEST(Page, AnEmptySuiteIsReported) {
  SuiteResults suite;
  EXPECT_THAT(PageOf(suite),
              AllOf(HasSubstr("field jobs: found none"), HasSubstr("There is no table"),
                    HasSubstr("No figure"), HasSubstr("No run can be shown")));
}

TEST(Page, ATruncatedPlanIsReported) {
  SuiteResults suite;
  suite.folder().Write("plan.json", "{\"schema_version\": 1, \"ki");
  const PageContent content = Read(suite.folder().path());
  ASSERT_FALSE(content.problems.empty());
  EXPECT_THAT(content.problems[0], HasSubstr("suite: plan.json: found text that"));
  EXPECT_THAT(OwnHtml(content), HasSubstr("plan.json: found text that"));
}

TEST(Page, AFolderWithoutAPlanIsAnError) {
  SuiteResults suite;
  EXPECT_THAT(ErrorMessage([&] { Read(suite.folder().path()); }),
              HasSubstr("plan.json: found no such file"));
}

TEST(Page, MissingResultsAreListedWithAReason) {
  SuiteResults suite;
  suite.Add(Result("good"));
  suite.Plan("failed", "static");
  suite.AddFailure("killed by signal 9");
  suite.Plan("waiting", "static");
  suite.Plan("cut", "static");
  suite.AddText("{\"schema_version\": 3, \"kind\": \"run\"");
  Json other = Result("old");
  other["schema_version"] = 1;
  suite.Add(other);
  const std::string page = PageOf(suite);
  EXPECT_THAT(page, HasSubstr("1 of 5 runs is complete; 3 failed; 1 not run yet."));
  EXPECT_THAT(page, HasSubstr("killed by signal 9 (log: logs/x.log)"));
  EXPECT_THAT(page, HasSubstr("<strong>not run</strong>"));
  EXPECT_THAT(page, HasSubstr("result.json: found"));
  EXPECT_THAT(page, HasSubstr("schema_version"));
  EXPECT_THAT(page, Not(HasSubstr(suite.folder().path().string())));
}

TEST(Page, AMetricThatSomeRunsLackIsReported) {
  SuiteResults suite;
  suite.Add(WithBodies(Result("a"), Json::array({BodyOf(1, {0.125})})));
  suite.Add(Result("b"));
  const std::string page = PageOf(suite);
  EXPECT_THAT(page, HasSubstr("Cells without a value"));
  EXPECT_THAT(page, HasSubstr("object ATE: "));
}

TEST(Page, MissingFilesAreNamed) {
  SuiteResults suite;
  suite.Add(Result("a"));
  const std::string page = PageOf(suite);
  EXPECT_THAT(page, HasSubstr("jobs/job0/timing.json"));
}

TEST(Page, ShowsTheOriginOfAResult) {
  SuiteResults suite;
  Json result = Result("a");
  result["build"]["commit"] = "0123abc+changes";
  result["build"]["cpu_level"] = "avx2";
  result["build"]["libraries"] = {{"opencv", "4.6.0"}};
  suite.Add(result);
  suite.folder().Write("jobs/job0/timing.json",
                       R"({"host": "node<7>", "cpu": "one", "date": "2026-01-02", "wall_s": 2.5})");
  const PageContent content = Read(suite.Written());
  ASSERT_EQ(content.runs.size(), 1U);
  EXPECT_THAT(content.runs[0].origin.build, testing::Contains(Fact{"commit", "0123abc+changes"}));
  EXPECT_THAT(content.runs[0].origin.build, testing::Contains(Fact{"cpu level", "avx2"}));
  EXPECT_THAT(content.runs[0].origin.build, testing::Contains(Fact{"opencv", "4.6.0"}));
  EXPECT_THAT(content.runs[0].origin.machine, testing::Contains(Fact{"host", "node<7>"}));
  EXPECT_THAT(content.runs[0].origin.time, testing::Contains(Fact{"took", "2.5 s"}));
  EXPECT_THAT(OwnHtml(content), HasSubstr("node&lt;7&gt;"));
}

TEST(Page, IsTheSameInAnyFolder) {
  const auto page = [] {
    SuiteResults suite;
    suite.Add(WithBodies(Result("a"), Json::array({BodyOf(1, {0.125, 0.25})})));
    suite.Plan("b", "static");
    suite.AddFailure("no");
    return PageHtml(Read(suite.Written()));
  };
  EXPECT_TRUE(page() == page());
}

TEST(Page, ComparesWithAnotherFolder) {
  SuiteResults before;
  before.Add(WithBodies(Result("a"), Json::array({BodyOf(1, {0.25})})));
  SuiteResults after;
  after.Add(WithBodies(Result("a"), Json::array({BodyOf(1, {0.125})})));
  PageRequest request;
  request.folder = after.Written();
  request.against = before.Written();
  const PageContent content = ReadPage(request);
  EXPECT_THAT(content.problems, IsEmpty());
  ASSERT_TRUE(content.comparison);
  const std::string page = OwnHtml(content);
  EXPECT_THAT(page,
              AllOf(HasSubstr("id=\"comparison\""), HasSubstr("data-table=\"comparison\""),
                    HasSubstr("Compared with " + before.folder().path().filename().string())));
  EXPECT_THAT(page, Not(HasSubstr(before.folder().path().string())));
}

TEST(Page, AnImpossibleComparisonIsReported) {
  SuiteResults after;
  after.Add(Result("a"));
  PageRequest request;
  request.folder = after.Written();
  request.against = after.folder().path() / "nowhere";
  const PageContent content = ReadPage(request);
  ASSERT_EQ(content.problems.size(), 1U);
  EXPECT_THAT(content.problems[0], HasSubstr("comparison: "));
  EXPECT_THAT(OwnHtml(content), HasSubstr("The two results cannot be compared"));
}

}  // namespace
}  // namespace cvo::reports
