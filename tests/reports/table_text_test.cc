// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/table_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "core/base/error.h"
#include "reports/tables/make_table.h"
#include "reports/tables/table_json.h"
#include "tests/reports/result_files.h"

namespace cvo::reports {
namespace {

using test::Json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// One run, one figure that compares, one that does not.
Table SmallTable() {
  Table table;
  table.title = "Camera";
  table.columns = {{"camera_coverage", "coverage", "1", {}},
                   {"camera_ate", "ATE", "m", {{"aggregation", "root mean square"}}}};
  Row row;
  row.sequence = {"drive_1", "kitti-raw", "grey", 0, 72, 72};
  row.variant = "static";
  row.seeds = {0};
  row.truth = "devkit";
  row.status = "ok";
  row.links = {"drive_1/result.json"};
  row.cells.resize(2);
  row.cells[0] = {true, 1.0, 72, {}, "", ""};
  row.cells[1] = {true, 0.0625, 72, {}, "nothing", ""};
  row.reference = {
      {0, "ORB-SLAM2", 0, 72, {std::nullopt, ReferenceCell{0.21, Match::kMatches, ""}}},
      {1, "ClusterVO", 0, 144, {std::nullopt, ReferenceCell{0.26, Match::kOtherFrames, "frames"}}}};
  table.rows = {row};
  table.sources = {{"m", "measured", "measured", "", "grey"},
                   {"p", "a paper", "published", "a caveat", ""}};
  return table;
}

TEST(TableText, AlignsColumnsAndBracketsWhatDoesNotCompare) {
  EXPECT_EQ(TableText(SmallTable(), false),
            "Camera\n"
            "\n"
            "sequence  frames  truth   system         coverage  ATE [m]\n"
            "drive_1   0:72    devkit  static            1.000    0.062\n"
            "          0:72            ORB-SLAM2 [a]               0.21\n"
            "          0:144           ClusterVO [b]             (0.26)\n"
            "\n"
            "(in brackets): not comparable with ours: other frames or images, or a metric that "
            "differs or that the source does not define\n"
            "[a] measured\n"
            "[b] a paper; a caveat\n"
            "coverage:\n"
            "ATE: root mean square\n");
}

TEST(TableText, DimsOnATerminalOnly) {
  EXPECT_THAT(TableText(SmallTable(), true), HasSubstr("\033[2m (0.26)\033[0m"));
  EXPECT_THAT(TableText(SmallTable(), false), Not(HasSubstr("\033")));
}

TEST(TableText, SaysWhatIsMissing) {
  Table table = SmallTable();
  table.rows[0].cells[1] = {false, 0.0, 0, {}, "", "not in the result"};
  table.rows[0].status = "lost";
  table.rows[0].message = "3 frames predicted";
  EXPECT_THAT(TableText(table, false),
              AllOf(HasSubstr("static (lost)"), HasSubstr("drive_1: 3 frames predicted\n"),
                    HasSubstr("drive_1: not in the result: ATE\n")));
}

TEST(TableText, ShowsTheIntervalOfSeeds) {
  Table table = SmallTable();
  table.rows[0].cells[1].interval = {0.05, 0.07, "least and largest of 3 seeds"};
  EXPECT_THAT(TableText(table, false),
              HasSubstr("drive_1, ATE: 0.050 to 0.070 (least and largest of 3 seeds)\n"));
}

TEST(TableMarkdown, IsATableAndAList) {
  EXPECT_THAT(TableMarkdown(SmallTable()),
              AllOf(HasSubstr("**Camera**\n\n| sequence | frames | truth | system | coverage | "
                              "ATE [m] |\n|---|---|---|---|---:|---:|\n"),
                    HasSubstr("| drive\\_1 | 0:72 | devkit | static | 1.000 | 0.062 |\n"),
                    HasSubstr("| *ClusterVO [b]* |  | *(0.26)* |\n"),
                    HasSubstr("\n- [b] a paper; a caveat\n")));
}

TEST(TableJson, HoldsValuesUnitsCountsLinksAndComparisons) {
  const std::string text = TableJson(SmallTable());
  const Json json = Json::parse(text);
  EXPECT_EQ(json["schema_version"], 1);
  EXPECT_EQ(json["kind"], "table");
  EXPECT_EQ(json["columns"][1]["contract"]["aggregation"], "root mean square");
  const Json& row = json["rows"][0];
  EXPECT_EQ(row["sequence"]["name"], "drive_1");
  EXPECT_EQ(row["variant"], "static");
  const Json& cell = row["cells"][1];
  EXPECT_EQ(cell["value"], 0.0625);
  EXPECT_EQ(cell["unit"], "m");
  EXPECT_EQ(cell["n"], 72);
  EXPECT_EQ(cell["links"][0], "drive_1/result.json");
  EXPECT_FALSE(cell.contains("interval"));
  EXPECT_EQ(row["reference"][1]["cells"][0]["comparison"], "other frames");
  EXPECT_EQ(row["reference"][1]["source"], "p");
  EXPECT_EQ(json["sources"][1]["caveat"], "a caveat");
  EXPECT_EQ(text, TableJson(SmallTable()));
}

TEST(TableJson, MissingCellsHaveAMessageAndNoValue) {
  Table table = SmallTable();
  table.rows[0].cells[1] = {false, 0.0, 0, {}, "", "not in the result"};
  const Json cell = Json::parse(TableJson(table))["rows"][0]["cells"][1];
  EXPECT_EQ(cell["status"], "missing");
  EXPECT_EQ(cell["message"], "not in the result");
  EXPECT_FALSE(cell.contains("value"));
}

TEST(TableJson, RefusesNumbersThatJsonCannotHold) {
  Table table = SmallTable();
  table.rows[0].cells[1].value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(TableJson(table), Error);
}

}  // namespace
}  // namespace cvo::reports
