// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/page/page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/reports/results/result_files.h"
#include "tests/reports/tables/hostile_table.h"
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

// The page without its script and style.
std::string OwnHtml(const PageContent& content) {
  std::string html = PageHtml(content);
  for (const std::string_view asset : {PageScript(), PageStyle()}) {
    const auto at = html.find(asset);
    EXPECT_NE(at, std::string::npos);
    html.erase(at, asset.size());
  }
  return html;
}

std::string PageOf(const SuiteResults& suite) { return OwnHtml(Read(suite.Written())); }

// Returns the first unescaped '<' within a tag or the first element that is not closed in order;
// empty if there is neither.
std::string FirstFlaw(const std::string& html) {
  std::vector<std::string> open;
  std::size_t at = 0;
  while ((at = html.find('<', at)) != std::string::npos) {
    std::size_t end = at + 1;
    for (bool quoted = false; end < html.size() && (quoted || html[end] != '>'); ++end) {
      if (html[end] == '"') quoted = !quoted;
      if (!quoted && html[end] == '<') return "unescaped <: " + html.substr(at, 60);
    }
    const std::string tag = html.substr(at + 1, end - at - 1);
    const std::string name = tag.substr(0, tag.find_first_of(" >"));
    if (name[0] == '/') {
      if (open.empty() || open.back() != name.substr(1)) return "closes nothing: " + tag;
      open.pop_back();
    } else if (name != "meta" && name != "!DOCTYPE" && name != "img" && name != "input" &&
               !tag.ends_with("/")) {
      open.push_back(name);
    }
    at = end;
  }
  return open.empty() ? "" : "not closed: " + open.back();
}

TEST(Page, StatesWhatWasCompared) {
  SuiteResults suite;
  suite.table["rows"] = {"variant"};
  suite.table["reference"] = "static";
  suite.Add(WithBodies(Result("room"), Json::array({BodyOf(1, {0.125, 0.125})})));
  suite.Add(WithBodies(Result("room"), Json::array({BodyOf(1, {0.25, 0.25})})), "full");
  const std::string page = PageOf(suite);
  EXPECT_THAT(page, HasSubstr("what it is"));
  EXPECT_THAT(page, HasSubstr("<p>2 of 2 runs. Differences are relative to static.</p>"));
  EXPECT_THAT(page, HasSubstr("<table class=\"short\">\n<thead><tr><th></th><th scope=\"col\""));
  EXPECT_THAT(page, HasSubstr("<p>Seeds: 0</p>"));
  EXPECT_THAT(page, AllOf(HasSubstr("Content-Security-Policy"), HasSubstr("script-src 'sha256-")));
}

TEST(Page, EscapesNamesAndMessages) {
  SuiteResults suite;
  suite.name = "<img src=x onerror=alert(1)>";
  const std::string hostile = "</script><script>alert(2)</script>\"'><b>";
  suite.Add(Result(hostile));
  suite.Plan("<i>room</i>", "<svg onload=alert(3)>");
  suite.AddFailure("<!--" + hostile);
  const std::string page = PageOf(suite);
  for (const char* markup : {"<img", "<script>alert", "<i>", "<svg onload", "<!--", "<b>"}) {
    EXPECT_THAT(page, Not(HasSubstr(markup))) << markup;
  }
  EXPECT_EQ(FirstFlaw(page), "");
  EXPECT_THAT(page, HasSubstr("&lt;svg onload=alert(3)&gt;"));
}

TEST(Page, AnEmptySuiteIsReported) {
  SuiteResults suite;
  EXPECT_THAT(PageOf(suite),
              AllOf(HasSubstr("field jobs: found none"), HasSubstr("There is no table"),
                    HasSubstr("No figure could be"), HasSubstr("No run can be shown")));
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
  EXPECT_THAT(page, HasSubstr("1 of 5 runs, 3 failed, 1 not run yet."));
  EXPECT_THAT(page, HasSubstr("killed by signal 9 (log: logs/x.log)"));
  EXPECT_THAT(page, HasSubstr("<li>waiting static, waiting, seed 0: not run"));
  EXPECT_THAT(page, HasSubstr("result.json: found"));
  EXPECT_THAT(page, HasSubstr("schema_version"));
  EXPECT_THAT(page, HasSubstr("jobs/job0/timing.json"));
  EXPECT_THAT(page, Not(HasSubstr(suite.folder().path().string())));
}

TEST(Page, AMetricThatSomeRunsLackIsReported) {
  SuiteResults suite;
  suite.Add(WithBodies(Result("a"), Json::array({BodyOf(1, {0.125})})));
  suite.Add(Result("b"));
  EXPECT_THAT(PageOf(suite), HasSubstr("object ATE, within 10 cm: no value in the run"));
}

TEST(Page, ShowsTheOriginOfAResult) {
  SuiteResults suite;
  Json result = Result("a");
  result["build"]["commit"] = "0123abc+changes";
  result["build"]["cpu_level"] = "avx2";
  result["build"]["libraries"] = {{"opencv", "4.6.0"}};
  suite.Add(result);
  suite.folder().Write("jobs/job0/timing.json", R"({"host": "node<7>", "cpu": "one"})");
  const PageContent content = Read(suite.Written());
  ASSERT_EQ(content.origins.size(), 2U);
  EXPECT_THAT(content.origins[0], AllOf(HasSubstr("commit 0123abc+changes"),
                                        HasSubstr("cpu_level avx2"), HasSubstr("opencv 4.6.0")));
  EXPECT_THAT(OwnHtml(content), HasSubstr("<li>machine: cpu one, host node&lt;7&gt;</li>"));
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

TEST(ResultTable, IsWellFormedAndHasValuesForSorting) {
  const std::string html = ResultTable(test::HostileTable());
  EXPECT_EQ(FirstFlaw(html), "");
  EXPECT_THAT(
      html,
      AllOf(
          HasSubstr("<th scope=\"row\">&lt;script&gt;alert(&quot;1&quot;)"),
          HasSubstr("killed &lt;i&gt;by&lt;/i&gt; signal 9"), HasSubstr(">object ATE [m]</th>"),
          HasSubstr("<td class=\"number\" data-value=\"0.05761\""),
          HasSubstr("<span class=\"value\">0.058</span><span class=\"small\">0.034..0.085</span>"),
          HasSubstr(">*</abbr>"), HasSubstr("id=\"table-differences\"")));
}

// ---- Runs frame by frame

SuiteRun RunOf(const std::string& sequence, const std::string& variant, std::uint64_t seed) {
  SuiteRun run;
  run.planned.keys = {{"sequence", sequence}, {"variant", variant}};
  run.planned.seed = seed;
  run.run = RunSummary{};
  return run;
}

TEST(ChooseScenes, TakesTheLowestSeedOfFullElseOfTheReference) {
  PageContent content;
  content.table = Table{};
  content.table->reference = "static";
  content.runs = {RunOf("a", "full", 2), RunOf("a", "2d", 1),     RunOf("a", "full", 1),
                  RunOf("b", "2d", 1),   RunOf("b", "static", 1), RunOf("c", "full", 1)};
  content.runs.back().run.reset();  // failed
  ChooseScenes(content);
  ASSERT_EQ(content.scenes.size(), 2U);
  EXPECT_EQ(content.scenes[0].run, 2U);
  EXPECT_EQ(content.scenes[1].run, 4U);
}

TEST(Frames, ShowImagesOrSayWhyThereAreNone) {
  PageContent content;
  content.runs = {RunOf("<a>", "full", 1), RunOf("b", "full", 1)};
  ChooseScenes(content);
  content.scenes[0].images = {{12, "foo", "what it shows"}};
  content.scenes[1].no_images = "no landmarks";
  const std::string html = OwnHtml(content);
  EXPECT_EQ(FirstFlaw(html), "");
  for (const char* part :
       {"<h3>&lt;a&gt;: full, seed 1</h3>",
        "<img data-frame=\"12\" alt=\"what it shows\" src=\"data:image/jpeg;base64,Zm9v\">",
        "<li>b: full, seed 1: no landmarks</li>"}) {
    EXPECT_THAT(html, HasSubstr(part));
  }
}

}  // namespace
}  // namespace cvo::reports
