// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Collections: suites that are run together and shown on one page.
#include "experiments/suite/collection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/suite/suite.h"
#include "tests/experiments/cli/process.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using test::Arguments;
using test::ExpectError;
using test::ProcessResult;
using test::With;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class CollectionTest : public test::CommandTest {
 protected:
  CollectionTest() { test::WriteTinySequence(Path("data/wall"), 4); }

  void WriteSuite(const std::string& name, const std::string& sequences,
                  const std::string& more = "") const {
    folder_.Write(name + ".json",
                  StrCat(R"({"name": ")", name, R"(", "sequences": [)", sequences,
                         R"(], "variants": ["static"], "seeds": 1, )", more, R"("table": )",
                         R"({"rows": ["sequence"], "metrics": ["camera_ate"]}})"));
  }
  ProcessResult RunAll(const std::string& sections, const Arguments& more = {}) const {
    const fs::path file = folder_.Write(
        "all.json",
        StrCat(R"({"name": "all", "about": "Of tests", "sections": [)", sections, "]}"));
    return Run(With({"experiment", "run", file.string(), "-o", out().string()}, more));
  }
  fs::path out() const { return folder_.path() / "out"; }
  std::string Page() const { return test::ReadFile(out() / "index.html"); }
};

TEST_F(CollectionTest, RunsItsSuitesAndShowsThemOnOnePage) {
  WriteSuite("here", R"({"folder": "wall"}, {"folder": "absent"})");
  WriteSuite("nowhere", R"({"folder": "elsewhere"})");
  const std::string sections =
      R"({"title": "Table 1: speed", "columns": ["system", "frames per second"],
          "rows": [["theirs", "7"]]},
         {"title": "Table 2: here", "suite": "here.json", "text": ["What <it> is."],
          "data": "example.org/here"},
         {"title": "Table 3: nowhere", "suite": "nowhere.json", "data": "example.org/nowhere",
          "figures": [{"suite": "here.json", "sequence": "wall", "variants": "static",
                       "frames": [1, 9]}]})";
  const ProcessResult run = RunAll(sections, {"--frames", "0:3"});
  ASSERT_EQ(run.exit_code, 0) << run.err << run.out;
  const std::string page = Page();
  for (const char* text :
       {"<title>all</title>", "<td>theirs</td><td>7</td>", "What &lt;it&gt; is.", "0:3",
        "Get it: example.org/here", "absent: no absent below",
        "Table 3: nowhere</a>: not on this disk", "Get it: example.org/nowhere",
        "src=\"figures/here-wall-1/", "here/report/index.html",
        "No picture of wall, static, frame 9: --frame 9: found no such frame in the run"}) {
    EXPECT_THAT(page, HasSubstr(text));
  }
  EXPECT_TRUE(fs::exists(out() / "here" / "report" / "index.html"));
  // A second call runs no job again and writes the same page.
  const ProcessResult again = RunAll(sections, {"--frames", "0:3"});
  EXPECT_THAT(again.err, Not(HasSubstr("100 %  1/1 jobs")));
  EXPECT_EQ(Page(), page);
}

TEST_F(CollectionTest, ATimedSuiteShowsItsTimes) {
  WriteSuite("timed", R"({"folder": "wall"})", R"("timed_threads": 1, )");
  const std::string sections = R"({"title": "Speed", "suite": "timed.json", "times": true})";
  const ProcessResult run = RunAll(sections, {"-j", "2"});
  ASSERT_EQ(run.exit_code, 0) << run.err << run.out;
  EXPECT_THAT(run.err, HasSubstr("timed: one job at a time, because the suite measures times"));
  EXPECT_THAT(Page(), AllOf(HasSubstr("<th>frames/s</th>"), HasSubstr("<td>static</td><td>1</td>"),
                            HasSubstr("1 thread.")));
  EXPECT_FALSE(fs::exists(folder_.path() / "cache" / "frontend"));  // not shared between jobs
  const ProcessResult times =
      test::RunProgram({"experiment", "table", (out() / "timed").string(), "--times"}, {});
  EXPECT_THAT(times.out,
              AllOf(HasSubstr("clusters per frame"), HasSubstr("features [ms]"),
                    HasSubstr("wall    none        static   1     0.0"), HasSubstr("machine: ")));
  ExpectError(test::RunProgram({"experiment", "table", folder_.path().string(), "--times"}, {}),
              "plan.json");
}

TEST_F(CollectionTest, ADryRunListsTheRunsAndMissingDataOfEachSection) {
  WriteSuite("here", R"({"folder": "wall"}, {"folder": "absent"})");
  const ProcessResult plan = RunAll(
      R"({"title": "Table 1", "columns": ["a"], "rows": []},
         {"title": "Table 2", "suite": "here.json", "data": "example.org/here"},
         {"title": "Table 3", "suite": "here.json", "data": "example.org/more"})",
      {"--dry-run"});
  ASSERT_EQ(plan.exit_code, 0) << plan.err;
  EXPECT_THAT(plan.out,
              AllOf(HasSubstr("Table 2\nhere (given split): 2 jobs: 0 done, 1 not run yet, 1 with"),
                    HasSubstr("missing input: absent: no absent below"),
                    HasSubstr("data: example.org/here\n\nTable 3\ndata: example.org/more")));
  EXPECT_FALSE(fs::exists(out()));
}

TEST_F(CollectionTest, ReportsErrorsInTheFile) {
  ExpectError(RunAll(""), "all.json, sections: found none");
  ExpectError(RunAll(R"({"title": "t", "colums": []})"), "sections.0.colums");
  ExpectError(RunAll(R"({"title": "t", "columns": ["a", "b"], "rows": [["1"]]})"),
              "sections.0.rows: found 1 cells, expected 2, one per column");
  ExpectError(RunAll(R"({"title": "t", "suite": "ablatoin"})"), "did you mean ablation");
}

TEST(Collections, SuitesAndFiguresOfShippedCollectionsExist) {
  for (const ShippedSuite& shipped : ShippedCollections()) {
    const std::string name(shipped.name);
    const std::optional<Collection> collection = FindCollection(name);
    ASSERT_TRUE(collection.has_value());
    EXPECT_EQ(collection->name, name);
    for (const CollectionSection& section : collection->sections) {
      if (!section.suite.empty()) {
        EXPECT_EQ(LoadSuite(section.suite).name, section.suite);
      }
      for (const CollectionFigure& figure : section.figures) {
        const Suite suite = LoadSuite(figure.suite);
        EXPECT_TRUE(std::any_of(
            suite.sequences.begin(), suite.sequences.end(),
            [&](const SuiteSequence& sequence) { return sequence.name == figure.sequence; }))
            << figure.sequence;
      }
    }
    EXPECT_THAT(ErrorMessage([&] { LoadSuite(name); }), HasSubstr("a collection of suites"));
  }
}

}  // namespace
}  // namespace cvo
