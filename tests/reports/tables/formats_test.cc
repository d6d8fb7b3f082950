// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tables as text, Markdown, LaTeX and JSON.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <sstream>

#include "core/base/error.h"
#include "core/record/metric_catalogue.h"
#include "reports/tables/table_texts.h"
#include "tests/reports/results/result_files.h"
#include "tests/reports/tables/hostile_table.h"

namespace cvo::reports {
namespace {

using test::Json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

// One run, with reference figures of the same frames, of other frames and of other scenes.
Table SmallTable() {
  Table table;
  table.title = "Camera";
  table.keys = {"sequence", "variant"};
  table.columns = {{"camera_coverage", "coverage", "1", {}}, {"camera_ate", "ATE", "m", {}}};
  table.columns[1].contract.aggregation = Aggregation::kRmsOfPositions;
  table.jobs.planned = 1;
  table.jobs.done = 1;
  Row row;
  row.keys = {"drive_1", "static"};
  row.sequence = SequenceInfo{"drive_1", "kitti-raw", "grey", 0, 72, 72};
  row.truth.truth = TruthSource::kDevkit;
  row.jobs = table.jobs;
  row.runs = {{"drive_1", 0, "jobs/x/result.json"}};
  row.cells.resize(2);
  for (Cell& cell : row.cells) cell.n = {1, 1, 0, 1};
  row.cells[0].value = 1.0;
  row.cells[1].value = 0.0625;
  row.reference = {
      {"m", "ORB-SLAM2", 0, 72, {{"camera_ate", "m", 0.21}}},
      {"p", "ClusterVO", 0, 144, {{"camera_ate", "m", 0.26, Match::kOtherFrames, "frames"}}}};
  table.rows = {row};
  table.others = {
      {"p", "Rooms", 0, 0, {{"camera_ate", "m", 0.5, Match::kOtherScenes, "other scenes"}}}};
  table.sources = {{"m", "measured", "measured", "", "grey"},
                   {"p", "a paper", "published", "a caveat", ""}};
  return table;
}

TEST(TableText, HasOneLinePerRowAndBracketsIncomparableValues) {
  EXPECT_EQ(TableText(SmallTable()),
            "Camera\n"
            "\n"
            "                   ATE\n"
            "                   [m]  coverage\n"
            "drive_1 static  0.0625     1.000\n"
            "  ORB-SLAM2 [a]   0.21\n"
            "  ClusterVO [b]  (0.26)\n"
            "  Rooms [b]       (0.5)\n"
            "\n"
            "1 of 1 runs, 1 scene a row; (..): not comparable\n"
            "all columns, intervals, differences and notes: --all\n");
}

// Many long rows and columns: the most telling columns are left, and the rest is counted.
TEST(TableText, FitsOneScreen) {
  Table table = SmallTable();
  table.keys = {"scene.knob.gap_m", "variant"};
  table.rows[0].keys = {"default",
                        "a variant whose name is much longer than a screen is wide, and so"};
  for (const char* metric :
       {"camera_trpe_all_pairs", "moving_recall", "object_ate", "moving_precision",
        "object_success_10cm", "cluster_purity", "object_coverage", "object_id_switches"}) {
    table.columns.push_back({metric, MetricLabel(metric), "m", {}});
    table.rows[0].cells.push_back(table.rows[0].cells[1]);
  }
  table.notes = {"first", "second"};
  const Row row = table.rows[0];
  table.rows.push_back(row);
  table.rows.back().keys[0] = "absent";
  table.rows.back().jobs.planned = table.rows.back().jobs.no_data = 1;
  for (int gap = 1; gap < 50; ++gap) {
    table.rows.push_back(row);
    table.rows.back().keys[0] = StrCat(gap);
  }
  const std::string text = TableText(table);
  EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 39);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
  EXPECT_THAT(text, AllOf(HasSubstr("\ngap_m=29 ~"), HasSubstr(" wide, and so "),
                          HasSubstr("\nand 20 more rows\n"), HasSubstr(" prec./recall "),
                          HasSubstr("0.0625/0.0625 "), HasSubstr("\nfirst (and 1 more)\n"),
                          Not(HasSubstr("purity")), Not(HasSubstr("absent"))));
}

// Of a sweep of many options one at a time.
TEST(TableText, LongNamesLeaveOutWhatMostRowsHave) {
  Table table = SmallTable();
  table.keys = {"orb.features", "stereo.right_features", "window.temporal"};
  const Row row = table.rows[0];
  table.rows.clear();
  for (const std::vector<std::string>& keys :
       std::vector<std::vector<std::string>>{{"1500", "1.5", "15"},
                                             {"1000", "1.5", "15"},
                                             {"1500", "2", "15"},
                                             {"1500", "1.5", "9"}}) {
    table.rows.push_back(row);
    table.rows.back().keys = keys;
    table.rows.back().reference.clear();
  }
  EXPECT_THAT(TableText(table),
              AllOf(HasSubstr("\nfeatures=1500 right_features=1.5 temporal=15 "),
                    HasSubstr("\nfeatures=1000   "), HasSubstr("\nright_features=2   ")));
}

TEST(TableText, ReportsMissingRuns) {
  Table table = SmallTable();
  table.rows[0].cells[1] = {};
  table.rows[0].cells[1].message = "no value in the run";
  table.jobs.planned = 40;
  table.jobs.lost = 1;
  table.jobs.failed = 20;
  table.jobs.no_data = 2;
  table.problems = {{"static", "drive_1", 3, "lost", "3 frames predicted", ""},
                    {"full", "drive_9", 0, "no data", "no such folder", ""},
                    {"static", "drive_9", 0, "no data", "no such folder", ""}};
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    table.problems.push_back({"full", "drive_1", seed, "failed", "killed", "logs/x.log"});
  }
  EXPECT_THAT(TableText(table),
              HasSubstr("\nstatic, drive_1, seed 3: lost: 3 frames predicted (and 12 more)\n"));
  const std::string text = TableListing(table);
  EXPECT_THAT(text, AllOf(HasSubstr("1 of 40 runs, 1 of them lost, 20 failed, 2 without their "),
                          HasSubstr("static, drive_1, seed 3: lost: 3 frames predicted\n"),
                          HasSubstr("drive_9: no data: no such folder\nfull, drive_1, seed 0: "
                                    "failed: killed (log: logs/x.log)\n"),
                          HasSubstr("and 10 more: table.json has all\n"),
                          HasSubstr("drive_1 static; ATE: no value in the run\n")));
}

TEST(TableListing, ShowsAllValuesWithTheirIntervals) {
  Table table = SmallTable();
  table.rows[0].cells[1].interval = {0.005, 0.07};
  EXPECT_THAT(
      TableListing(table),
      AllOf(HasSubstr("\ndrive_1  static  0:72  devkit  1/1\n  coverage  1.000\n"
                      "  ATE [m]   0.062  0.005..0.070\n"),
            HasSubstr("\nClusterVO [b]  0:144\n  ATE [m]  (0.26)\n"),
            HasSubstr("n, coverage, ATE: 1 scene, 1 seed, 1 run\n"
                      "low..high: 95 %, bootstrap over scenes within their families"),
            HasSubstr("\n(in brackets): not comparable with ours: other scenes, frames or images"),
            HasSubstr("[a] measured\n[b] a paper; a caveat\n")));
}

TEST(TableMarkdown, IsATableAndAList) {
  EXPECT_THAT(
      TableMarkdown(SmallTable()),
      AllOf(HasSubstr("**Camera**\n\n| sequence | variant | frames | truth | runs | coverage | "
                      "ATE [m] |\n|---|---|---|---|---|---:|---:|\n"),
            HasSubstr("| drive\\_1 | static | 0:72 | devkit | 1/1 | 1.000 | 0.0625 |\n"),
            HasSubstr("| *ClusterVO [b]* | *0:144* |  |  |  | *(0.26)* |\n"),
            HasSubstr("\n- [b] a paper; a caveat\n"),
            HasSubstr("\n- ATE: root mean square of position errors\n")));
}

TEST(TableMarkdown, EscapesNames) {
  const std::string text = TableMarkdown(test::HostileTable());
  EXPECT_THAT(text,
              AllOf(HasSubstr("| \\<script\\>alert(\"1\")\\</script\\> | full |"),
                    HasSubstr("\\- about [a link]\\(javascript:alert(1)) \\| and \\`code\\`"),
                    HasSubstr("| =cmd\\|' /C calc'!A0 | x,\"y\" z \xEF\xBF\xBD[31m |"),
                    HasSubstr("| 0.058 (0.034..0.085) |"), HasSubstr("| 0.104\\* (0.061..0.160) |"),
                    HasSubstr("| +0.047\\* (0.011..0.087); +81.0% |"), HasSubstr("| *(0.04)* |"),
                    HasSubstr("| *Unknown [a]* |")));
}

TEST(TableText, EscapesNames) {
  EXPECT_THAT(TableText(test::HostileTable()), Not(HasSubstr("\x1b")));
  const std::string text = TableListing(test::HostileTable());
  EXPECT_THAT(text, AllOf(Not(HasSubstr("\x1b")), HasSubstr("their system"), HasSubstr("0.058"),
                          HasSubstr("0.104*"), HasSubstr("(0.04)"),
                          HasSubstr("killed <i>by</i> signal 9 (log: logs/x.log)\n")));
}

TEST(TableLatex, ShowsValuesIntervalsMarksAndNotes) {
  EXPECT_THAT(
      TableLatex(test::HostileTable()),
      AllOf(StartsWith("% Suite <b>&amp;</b> 50 %\n% needs \\usepackage{booktabs}\n"
                       "\\begin{tabular}{lllllrrrrr}\n\\toprule\nsequence & variant & "),
            HasSubstr(" & object ATE {[}m] & id switches \\\\\n\\midrule\n"),
            HasSubstr(" & 0.058 & "), HasSubstr("0.104\\rlap{$^{*}$}"), HasSubstr(" & (0.04) & "),
            HasSubstr("Same \\& co {[}a]"),
            HasSubstr("\\bottomrule\n\\end{tabular}\n% 6 of 9 runs"),
            HasSubstr("% camera ATE: root mean square"), Not(HasSubstr("\\documentclass"))));
}

// Every line is a comment, a command of ours, or a row with as many cells as the table has columns.
TEST(TableLatex, NamesAreNoCommands) {
  Table table = test::HostileTable();
  table.rows[1].keys = {"[1] \\end{document}", "*\\input{/etc/passwd}--"};
  const std::string latex = TableLatex(table);
  EXPECT_THAT(latex, AllOf(HasSubstr("{[}1] \\textbackslash{}end\\{document\\} & {*}"),
                           HasSubstr("\\textless{}script\\textgreater{}alert(")));
  std::istringstream lines(latex);
  std::string line;
  while (std::getline(lines, line)) {
    if (line[0] == '%' || line[0] == '\\') continue;
    std::size_t ends = 0;
    for (std::size_t i = 1; i < line.size(); ++i) ends += line[i] == '&' && line[i - 1] == ' ';
    EXPECT_EQ(ends, 9U) << line;
    EXPECT_THAT(line, testing::EndsWith(" \\\\"));
  }
}

TEST(TableJson, HoldsValuesUnitsCountsRunsAndComparisons) {
  const std::string text = TableJson(SmallTable());
  const Json json = Json::parse(text);
  EXPECT_EQ(json["schema_version"], 5);
  EXPECT_EQ(json["kind"], "table");
  EXPECT_EQ(json["columns"][1]["contract"]["aggregation"], "root mean square of position errors");
  const Json& row = json["rows"][0];
  EXPECT_EQ(row["keys"][1], "static");
  EXPECT_EQ(row["sequence"]["name"], "drive_1");
  EXPECT_EQ(row["jobs"]["planned"], 1);
  EXPECT_EQ(row["runs"][0]["result"], "jobs/x/result.json");
  const Json& cell = row["cells"][1];
  EXPECT_EQ(cell["value"], 0.0625);
  EXPECT_EQ(cell["n"]["scenes"], 1);
  EXPECT_FALSE(cell.contains("interval"));
  EXPECT_FALSE(cell.contains("difference"));
  EXPECT_EQ(row["reference"][1]["cells"][0]["match"], "other frames");
  EXPECT_EQ(json["others"][0]["cells"][0]["match"], "other scenes");
  EXPECT_EQ(json["sources"][1]["caveat"], "a caveat");
}

TEST(TableJson, MissingCellsHaveAMessageAndNoValue) {
  Table table = SmallTable();
  table.rows[0].cells[1] = {};
  table.rows[0].cells[1].message = "no value in the run";
  const Json cell = Json::parse(TableJson(table))["rows"][0]["cells"][1];
  EXPECT_EQ(cell["message"], "no value in the run");
  EXPECT_FALSE(cell.contains("value"));
}

TEST(TableJson, RefusesNonFiniteNumbers) {
  Table table = SmallTable();
  table.rows[0].cells[1].value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(TableJson(table), Error);
}

}  // namespace
}  // namespace cvo::reports
