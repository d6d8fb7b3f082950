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
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::Pair;

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
  EXPECT_THAT(page,
              HasSubstr("Compares 2 variants (static and full) on 1 sequence (room) with 1 seed."));
  EXPECT_THAT(page, HasSubstr("<p>2 of 2 runs.</p>"));
  EXPECT_THAT(page, HasSubstr("Undecided (1 pair, 6 needed): object ATE"));
  EXPECT_THAT(page, HasSubstr("<h3>Seeds</h3>\n<p>0</p>"));
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
  EXPECT_THAT(page, HasSubstr("1 of 5 runs, 3 failed, 1 not run yet."));
  EXPECT_THAT(page, HasSubstr("killed by signal 9 (log: logs/x.log)"));
  EXPECT_THAT(page, HasSubstr("<li>not run: "));
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
  ASSERT_EQ(content.runs.size(), 1U);
  EXPECT_THAT(content.runs[0].build,
              AllOf(Contains(Fact{"commit", "0123abc+changes"}),
                    Contains(Fact{"cpu level", "avx2"}), Contains(Fact{"opencv", "4.6.0"})));
  EXPECT_THAT(content.runs[0].machine, Contains(Fact{"host", "node<7>"}));
  EXPECT_THAT(OwnHtml(content), HasSubstr("<dt>host</dt><dd>node&lt;7&gt;</dd>"));
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
  const std::string page = OwnHtml(content);
  EXPECT_THAT(page,
              AllOf(HasSubstr("id=\"comparison\""), HasSubstr("id=\"comparison-table-values\""),
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

TEST(ResultTable, IsWellFormedAndHasValuesForSorting) {
  const std::string html = ResultTable(test::HostileTable(), "t");
  EXPECT_EQ(FirstFlaw(html), "");
  EXPECT_THAT(html, AllOf(HasSubstr("<th scope=\"row\">&lt;script&gt;alert(&quot;1&quot;)"),
                          HasSubstr("killed &lt;i&gt;by&lt;/i&gt; signal 9"),
                          HasSubstr("object ATE<span class=\"unit\"> [m]</span></th>"),
                          HasSubstr("<td class=\"number best\" data-value=\"0.05761\""),
                          HasSubstr("<span class=\"mark\">best</span> <span class=\"value\">0.058"
                                    "</span><span class=\"small\">0.034..0.085</span>"),
                          HasSubstr(">*</abbr>"), HasSubstr("id=\"t-differences\"")));
}

// ---- Runs frame by frame

PageRun RunOf(const std::string& sequence, const std::string& variant, std::uint64_t seed) {
  PageRun run;
  run.run.planned.keys = {{"sequence", sequence}, {"variant", variant}};
  run.run.planned.seed = seed;
  run.run.run = RunSummary{};
  return run;
}

// The runs chosen, and whether with images.
std::vector<std::pair<std::size_t, bool>> Chosen(std::size_t most, PageContent& content) {
  ChooseScenes(most, content);
  std::vector<std::pair<std::size_t, bool>> chosen;
  for (const PageScene& scene : content.scenes) chosen.emplace_back(scene.run, scene.wants_images);
  return chosen;
}

TEST(ChooseScenes, TakesFirstSeedsAndImagesOfFull) {
  PageContent content;
  content.table = Table{};
  content.table->reference = "static";
  content.runs = {RunOf("a", "2d", 2), RunOf("a", "2d", 1),     RunOf("a", "full", 1),
                  RunOf("b", "2d", 1), RunOf("b", "static", 1), RunOf("c", "full", 1)};
  content.runs.back().run.run.reset();  // failed
  EXPECT_THAT(Chosen(10, content),
              ElementsAre(Pair(2U, true), Pair(4U, true), Pair(1U, false), Pair(3U, false)));
  EXPECT_EQ(content.scenes_left_out, 0U);
}

TEST(ChooseScenes, TakesFailuresFirstWhereNotAllFit) {
  PageContent content;
  content.runs = {RunOf("a", "full", 1), RunOf("b", "full", 1), RunOf("c", "full", 1)};
  for (std::size_t i = 0; i < content.runs.size(); ++i) {
    BodyRow body;
    body.mover = true;
    body.visible_frames = 2;
    body.errors = {{0, 1}, {0.01, i == 1 ? 0.5 : 0.02}};
    content.runs[i].run.run->bodies = RunBodies{{body}, {}};
  }
  PageContent all = content;
  EXPECT_THAT(Chosen(1, content), ElementsAre(Pair(1U, true)));
  EXPECT_EQ(content.scenes_left_out, 2U);
  EXPECT_THAT(Chosen(3, all), ElementsAre(Pair(0U, true), Pair(1U, true), Pair(2U, true)));
}

TEST(Frames, HavePathsInMillimetresSeenFromAbove) {
  CameraFrame first;
  first.frame = 10;
  first.timestamp_ns = 5'000'000'000;
  first.status = "first";
  first.world_from_camera = {0.0124, -0.0006, 1.0, 0, 0, 0, 1};
  first.truth = Pose{0.0124, -0.0006, 1.0025, 0, 0, 0, 1};
  CameraFrame second = first;
  second.frame = 12;
  second.timestamp_ns = 5'100'000'000;
  second.status = "lost";
  second.truth.reset();
  ClusterRow row;
  row.frame = 12;
  row.id = 3;
  row.category = "<car>";
  row.predicted = true;
  row.world_from_object = {1, 2, 3, 0, 0, 0, 1};
  row.object_from_box = {0.5, 0, 0, 0, 1, 0, 0};
  BodyDetail body;
  body.name = "van";
  body.cluster = 3;
  body.truth = {{12, Pose{1, 2, 3.5, 0, 0, 0, 1}}};
  body.predicted = {{12, {1, 2, 3}, 0.5}};
  PageContent content;
  content.runs = {RunOf("a", "full", 1), RunOf("a", "2d", 1)};
  ChooseScenes(2, content);
  content.scenes[0].detail.camera = {first, second};
  content.scenes[0].detail.clusters = {row};
  content.scenes[0].detail.bodies = {body};
  content.scenes[0].images = {{12, "foo", "what it shows"}};
  content.scenes[1].detail.camera = {second};
  const std::string html = FramesSection(content);
  EXPECT_EQ(FirstFlaw(html), "");
  for (const char* part :
       {"data-frames=\"10 12\" data-times-ms=\"0 100\"", "<summary>a: 2 runs</summary>",
        "data-name=\"camera\" data-frames=\"10 12\" data-mark=\"lost\" data-marked=\"12\" "
        "data-errors-mm=\"2.5 -\" points=\"12,-1000 12,-1000\"",
        "data-name=\"true camera\" data-frames=\"10\" points=\"12,-1003\"",
        "data-name=\"true van\" data-frames=\"12\" points=\"1000,-3500\"",
        "data-mark=\"hidden, predicted\" data-marked=\"12\" data-errors-mm=\"500\" "
        "points=\"1500,-3000\"",
        "data-name=\"cluster 3 (&lt;car&gt;)\"", "<h3>full, seed 1</h3>", "<h3>2d, seed 1</h3>",
        "<img data-frame=\"12\" alt=\"what it shows\" src=\"data:image/jpeg;base64,Zm9v\">",
        "Images are in the page for one estimator per sequence only."}) {
    EXPECT_THAT(html, HasSubstr(part));
  }
}

// ---- Findings

Table TwoRows(double difference, std::size_t pairs, bool distinguishable,
              const std::string& metric = "object_ate", const std::string& unit = "m") {
  Table table;
  table.keys = {"variant"};
  table.columns = {{metric, "object ATE", unit, {}}};
  Row row;
  row.keys = {"2d"};
  Cell cell;
  cell.present = true;
  cell.difference = Difference{};
  cell.difference->value = 0.5;
  cell.difference->reference_value = 0.5 - difference;
  cell.difference->difference = difference;
  cell.difference->interval = Interval{0.125, 0.5, ""};
  cell.difference->pairs = pairs;
  cell.difference->distinguishable = distinguishable;
  row.cells = {cell};
  table.rows = {row};
  return table;
}

std::string FindingsOf(const Table& table) { return FindingsHtml(table, "full"); }

TEST(Findings, ADifferenceHasADirectionASizeAndAUnit) {
  const std::string worse = FindingsOf(TwoRows(0.25, 8, true));
  EXPECT_THAT(worse, HasSubstr("<h3>2d: worse in 1 of 1 metric</h3>"));
  EXPECT_THAT(worse, HasSubstr("0.5 m instead of 0.25 m with full: +0.25 m (interval 0.125 to 0.5 "
                               "m; 8 pairs)"));
  EXPECT_THAT(FindingsOf(TwoRows(-0.25, 8, true)), HasSubstr("2d: better in 1 of 1"));
  EXPECT_THAT(FindingsOf(TwoRows(-0.125, 8, true, "object_coverage", "1")),
              AllOf(HasSubstr("2d: worse in 1 of 1"),
                    HasSubstr("50 % instead of 62.5 % with full: -12.5 percentage points")));
  EXPECT_THAT(FindingsOf(TwoRows(0.25, 8, true, "object_id_switches", "1")),
              HasSubstr("0.5 instead of 0.25 with full: +0.25 ("));
  EXPECT_THAT(FindingsOf(TwoRows(0.25, 8, true, "of their own")),
              HasSubstr("2d: different in 1 of 1"));
}

TEST(Findings, ColumnsWithEqualLabelsAreDistinguishedByUnit) {
  Table table = TwoRows(0.25, 8, false);
  table.columns.push_back({"object_rrpe", "object ATE", "rad", {}});
  EXPECT_THAT(FindingsOf(table), HasSubstr("Not significant: object ATE (m)."));
}

TEST(Findings, NoiseAndFewPairsAreNoFindings) {
  const std::string noise = FindingsOf(TwoRows(0.25, 8, false));
  EXPECT_THAT(noise, HasSubstr("2d: no significant difference"));
  EXPECT_THAT(noise, HasSubstr("Not significant: object ATE."));
  EXPECT_THAT(noise, Not(HasSubstr("<li")));
  EXPECT_THAT(FindingsOf(TwoRows(0.25, 5, false)),
              AllOf(HasSubstr("2d: undecided (5 pairs, 6 needed)"),
                    HasSubstr("Undecided (5 pairs, 6 needed): object ATE.")));
  Table mixed = TwoRows(0.25, 5, false);
  mixed.columns.push_back({"camera_ate", "camera ATE", "m", {}});
  mixed.rows[0].cells.push_back(mixed.rows[0].cells.front());
  mixed.rows[0].cells.back().difference->pairs = 1;
  EXPECT_THAT(FindingsOf(mixed), AllOf(HasSubstr("Undecided (1 pair, 6 needed): camera ATE."),
                                       HasSubstr("Undecided (5 pairs, 6 needed): object ATE.")));
  EXPECT_THAT(FindingsOf(TwoRows(0.0, 8, false)), HasSubstr("The same in every metric: 2d."));
}

}  // namespace
}  // namespace cvo::reports
