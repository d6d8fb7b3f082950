// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "reports/tables/cells.h"
#include "reports/tables/make_table.h"
#include "reports/tables/table.h"
#include "reports/tables/table_texts.h"
#include "tests/reports/results/result_files.h"
#include "tests/support/error_message.h"

namespace cvo::reports {
namespace {

using test::BodyOf;
using test::Json;
using test::MetricOf;
using test::Result;
using test::SuiteResults;
using test::WithBodies;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr char kRootMeanSquare[] = "root mean square of position errors";

const Cell& CellOf(const Table& table, std::size_t row, const std::string& metric) {
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (table.columns[i].metric == metric) return table.rows.at(row).cells[i];
  }
  throw Error("no column " + metric);
}

std::string ErrorOf(const SuiteResults& a, const SuiteResults& b) {
  return ErrorMessage([&] { CompareFolders(a.Written(), b.Written()); });
}

// Eight bodies of one room with errors of slightly more than 5 cm + `more_m` in 4 frames.
Json Room(double more_m) {
  Json bodies = Json::array();
  for (int id = 1; id <= 8; ++id) {
    const double error_m = 0.05 + more_m + 0.001 * id;
    bodies.push_back(BodyOf(id, {error_m, error_m, error_m, error_m}));
  }
  return WithBodies(Result("room"), bodies);
}

TEST(PairedTable, BodiesAreComparedOnFramesThatBothEstimate) {
  SuiteResults suite;
  suite.table["rows"] = {"variant"};
  suite.table["reference"] = "full";
  // In frames that both estimate, full is off by 1 cm and 2d by 3 cm; full's last frame is bad.
  suite.Add(WithBodies(Result("a"), Json::array({BodyOf(1, {0.01, 0.01, 0.50})})), "full");
  suite.Add(WithBodies(Result("a"), Json::array({BodyOf(1, {0.03, 0.03, -1.0})})), "2d");
  const Table table = MakeTable(suite.Written(), {}, "");
  EXPECT_GT(CellOf(table, 0, "object_ate").value, CellOf(table, 1, "object_ate").value);
  const auto ate = CellOf(table, 1, "object_ate").difference;
  ASSERT_TRUE(ate);
  EXPECT_NEAR(ate->value, 0.03, 1e-12);
  EXPECT_NEAR(ate->reference_value, 0.01, 1e-12);
  EXPECT_FALSE(ate->interval) << "one body";
  // Success counts every visible frame: 2 of 3 in both variants.
  const auto success = CellOf(table, 1, "object_success_10cm").difference;
  EXPECT_EQ(success->difference, 0.0);
  EXPECT_NEAR(success->value, 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(CellOf(table, 1, "object_coverage").difference->difference, -1.0 / 3.0, 1e-12);
}

TEST(PairedTable, OnlyCommonScenesAndSeedsArePaired) {
  SuiteResults suite;
  suite.table["rows"] = {"variant"};
  suite.table["reference"] = "full";
  suite.Add(WithBodies(Result("a"), Json::array({BodyOf(1, {0.01}), BodyOf(2, {-1.0})})), "full",
            0);
  suite.Add(WithBodies(Result("a"), Json::array({BodyOf(1, {0.09}), BodyOf(2, {0.09})})), "full",
            1);
  suite.Add(WithBodies(Result("b"), Json::array({BodyOf(1, {0.09})})), "full", 0);
  suite.Add(WithBodies(Result("a"), Json::array({BodyOf(1, {0.02}), BodyOf(2, {0.07})})), "2d", 0);
  suite.Plan("a", "2d", 1);
  const Table table = MakeTable(suite.Written(), {}, "");
  const auto ate = CellOf(table, 1, "object_ate").difference;
  EXPECT_NEAR(ate->difference, 0.01, 1e-12);
  EXPECT_EQ(ate->pairs, 1U);
  EXPECT_THAT(table.notes, ElementsAre(HasSubstr("rows are based on different runs")));
  EXPECT_THAT(CellOf(table, 0, "object_ate").left_out, HasSubstr("1 of 5 bodies"));
}

TEST(PairedTable, MarksDistinguishableDifferences) {
  SuiteResults suite;
  suite.table["rows"] = {"variant"};
  suite.table["reference"] = "full";
  suite.Add(Room(0.0), "full");
  suite.Add(Room(0.02), "2d");
  const Table table = MakeTable(suite.Written(), {}, "");
  const Cell& ate = CellOf(table, 1, "object_ate");
  ASSERT_TRUE(ate.difference && ate.difference->interval);
  EXPECT_TRUE(ate.difference->distinguishable);
  EXPECT_FALSE(CellOf(table, 1, "object_coverage").difference->distinguishable);
  EXPECT_THAT(TableText(table), AllOf(HasSubstr("0.0745*"), HasSubstr("*: differs from full by")));
  EXPECT_THAT(TableListing(table), AllOf(HasSubstr("0.0745*"), HasSubstr("+0.0200*"),
                                         HasSubstr("difference from full (paired): value, 95 % "
                                                   "interval, and percent of full")));
  const Json json = Json::parse(TableJson(table));
  ASSERT_EQ(json["columns"][2]["metric"], "object_coverage");
  EXPECT_FALSE(json["rows"][1]["cells"][2]["difference"]["distinguishable"].get<bool>());
  EXPECT_EQ(TableJson(table), TableJson(MakeTable(suite.Written(), {}, "")));
}

TEST(PairedTable, MarksNoDifferenceThatTheTruthDoesNotDecide) {
  for (const double gap_m : {0.1, 0.001}) {
    SuiteResults suite;
    suite.table["rows"] = {"variant"};
    suite.table["reference"] = "full";
    for (const double ate_m : {0.05, 0.07}) {
      Json result = Result("drive");
      result["metrics"].push_back(MetricOf("camera_truth_gap", gap_m, "m", kRootMeanSquare));
      for (Json& metric : result["metrics"]) {
        if (metric["name"] == "camera_ate") metric["value"] = ate_m;
      }
      suite.Add(result, ate_m == 0.05 ? "full" : "2d");
    }
    const Table table = MakeTable(suite.Written(), {}, "");
    const auto ate = CellOf(table, 1, "camera_ate").difference;
    ASSERT_TRUE(ate);
    EXPECT_EQ(ate->percent.has_value(), gap_m < 0.02);
    EXPECT_EQ(TableListing(table).find("within the gap of the truths") != std::string::npos,
              gap_m > 0.02);
  }
}

// Ten rooms of a family with one body each; the second variant is worse in all of them.
void AddTenRooms(double worse_m, SuiteResults& suite, const std::string& images = "") {
  suite.table["rows"] = {"variant"};
  suite.table["reference"] = "full";
  for (int room = 0; room < 10; ++room) {
    const std::string name = "room_" + std::to_string(room);
    for (const char* variant : {"full", "2d"}) {
      const double error_m = 0.05 + (variant[0] == '2' ? worse_m * (1.0 + 0.1 * room) : 0.0);
      Json result = WithBodies(Result(name), Json::array({BodyOf(1, {error_m})}));
      result["sequence"]["images"] = images;
      Json& job = suite.Add(result, variant);
      job["family"] = "room";
      job["split"] = "test";
    }
  }
}

TEST(PairedTable, ResamplesScenesAndCorrectsForManyComparisons) {
  SuiteResults suite;
  AddTenRooms(0.02, suite);
  const Table table = MakeTable(suite.Written(), {}, "");
  const auto ate = CellOf(table, 1, "object_ate").difference;
  EXPECT_EQ(ate->pairs, 10U);
  ASSERT_TRUE(ate->p_value && ate->adjusted_p_value);
  EXPECT_GT(*ate->adjusted_p_value, *ate->p_value) << "other columns are compared too";
  EXPECT_TRUE(ate->distinguishable);
  EXPECT_EQ(table.rows[0].split, "test");
  const std::string text = TableListing(table);
  EXPECT_THAT(text, HasSubstr("comparisons of this table (Holm), is below 0.05"));
  EXPECT_THAT(text, HasSubstr("split test: no option was chosen on these scenes"));
  const Json json = Json::parse(TableJson(table));
  EXPECT_EQ(json["rows"][1]["split"], "test");
  EXPECT_EQ(TableJson(ReadRecord<Table>(json, "table")), TableJson(table));
}

TEST(PairedTable, OneSceneUnderSeveralNamesIsOneScene) {
  SuiteResults suite;
  AddTenRooms(0.02, suite, "the same images");
  const Table table = MakeTable(suite.Written(), {}, "");
  const Cell& ate = CellOf(table, 1, "object_ate");
  EXPECT_EQ(ate.n.scenes, 1U);
  EXPECT_EQ(ate.difference->pairs, 1U);
  EXPECT_FALSE(ate.difference->distinguishable);
}

TEST(PairedTable, RowsWithTheSameValuesAreNamed) {
  SuiteResults suite;
  AddTenRooms(0.0, suite);
  EXPECT_THAT(MakeTable(suite.Written(), {}, "").notes,
              testing::Contains(HasSubstr("full = 2d: the same values in every run")));
  SuiteResults other;
  AddTenRooms(1e-9, other);
  EXPECT_THAT(MakeTable(other.Written(), {}, "").notes,
              testing::Not(testing::Contains(HasSubstr("the same values"))));
}

TEST(PairedTable, SplitsAreNeverAveraged) {
  SuiteResults suite;
  suite.table["rows"] = {"variant"};
  suite.Add(Result("a"))["split"] = "development";
  suite.Add(Result("b"))["split"] = "test";
  EXPECT_THAT(ErrorMessage([&] { MakeTable(suite.Written(), {}, ""); }),
              HasSubstr("of the development split and of the test split"));
}

TEST(CorrectForMany, FewPairsAndNoiseAreNeverDistinguishable) {
  const auto distinguishable = [](double p_value, std::size_t pairs, double low) {
    Difference difference;
    difference.p_value = p_value;
    difference.pairs = pairs;
    difference.interval = Interval{low, 1.0};
    Difference other = difference;
    other.p_value = 0.5;
    CorrectForMany({&difference, &other});
    return difference.distinguishable;
  };
  EXPECT_TRUE(distinguishable(0.02, 6, 0.1));
  EXPECT_FALSE(distinguishable(0.03, 6, 0.1)) << "two comparisons";
  EXPECT_FALSE(distinguishable(0.02, 5, 0.1));
  EXPECT_FALSE(distinguishable(0.02, 6, -0.1));
}

TEST(PairedTable, AReferenceCanBeTheValueOfAnyKey) {
  SuiteResults suite;
  suite.table["rows"] = {"crf.alpha"};
  suite.table["reference"] = "crf.alpha=5";
  suite.Add(Room(0.01))["parameters"] = {{"crf.alpha", 1}};
  suite.Add(Room(0.0))["parameters"] = {{"crf.alpha", 5}};
  const Table table = MakeTable(suite.Written(), {}, "");
  EXPECT_NEAR(CellOf(table, 0, "object_ate").difference->difference, 0.01, 1e-12);
  EXPECT_FALSE(CellOf(table, 1, "object_ate").difference);
}

TEST(CompareFolders, ReportsChangesAndTheirSize) {
  SuiteResults before;
  SuiteResults after;
  before.Add(Room(0.02), "full");
  after.Add(Room(0.0), "full");
  const Table table = CompareFolders(before.Written(), after.Written());
  const auto ate = CellOf(table, 0, "object_ate").difference;
  EXPECT_NEAR(ate->difference, -0.02, 1e-12);
  EXPECT_NEAR(*ate->percent, -100.0 * 0.02 / 0.0745, 1e-9);
  EXPECT_EQ(MovedText(table), "1 of 5 values changed, 1 distinguishable from noise (*)\n");
}

TEST(CompareFolders, StatesOptionsAndBuildsThatDiffer) {
  SuiteResults before;
  SuiteResults after;
  before.Add(Room(0.02), "full");
  Json fewer = Room(0.02);
  fewer["options"]["orb"]["features"] = 800;
  after.Add(fewer, "full");
  EXPECT_EQ(CompareFolders(before.Written(), after.Written()).about,
            "The two folders differ: option orb.features 2000 -> 800.");
  EXPECT_EQ(CompareFolders(before.Written(), before.Written()).about,
            "The two folders have the same options, builds and variants.");
}

TEST(CompareFolders, OtherContractsAreRefusedNamingTheMetricAndBothFiles) {
  SuiteResults before;
  SuiteResults after;
  before.Add(Room(0.0), "full");
  Json other = Room(0.0);
  other["metrics"][2]["contract"]["alignment"] = "none";
  after.Add(other, "full");
  EXPECT_THAT(ErrorOf(before, after),
              AllOf(HasSubstr("metric object_ate"),
                    HasSubstr((before.folder().path() / "jobs/job0/result.json").string()),
                    HasSubstr((after.folder().path() / "jobs/job0/result.json").string()),
                    HasSubstr("alignment \"none\"")));
}

TEST(CompareFolders, OtherFramesAreNotPaired) {
  SuiteResults before;
  SuiteResults after;
  before.Add(Room(0.0), "full");
  Json part = Room(0.0);
  part["sequence"]["frames"] = 50;
  after.Add(part, "full");
  EXPECT_THAT(ErrorOf(before, after), HasSubstr("no row with a run that both have"));
}

TEST(CompareFolders, OtherRowsAndImagesAreReported) {
  SuiteResults before;
  SuiteResults after;
  before.Add(Room(0.0), "full");
  before.Add(Room(0.0), "2d");
  Json redrawn = Room(0.0);
  redrawn["sequence"]["content"] = "other images";
  after.Add(redrawn, "full");
  after.Add(redrawn, "2d3d");
  EXPECT_THAT(CompareFolders(before.Written(), after.Written()).notes,
              ElementsAre(HasSubstr("the same values"), HasSubstr("different images"),
                          "room 2d: no such row in the second folder",
                          "room 2d3d: no run in common with the first folder"));
  after.table["rows"] = {"variant"};
  EXPECT_THAT(ErrorOf(before, after), HasSubstr("rows by sequence, variant and by variant"));
}

// ---- Rows that look alike: corrected calibrations and other CPU levels

class TableNotesTest : public testing::Test {
 protected:
  Table Make() const { return MakeTable(suite_.Written(), {}, ""); }

  SuiteResults suite_;
};

Json Corrected(Json result) {
  result["sequence"]["camera"]["right_shift_px"] = 0.16;
  for (Json& metric : result["metrics"]) metric["contract"]["right_shift_px"] = 0.16;
  return result;
}

TEST_F(TableNotesTest, RowsWithAndWithoutACorrectionAreNotCompared) {
  suite_.table["reference"] = "static";
  suite_.Add(Corrected(Result()));
  suite_.Add(Result(), "system:ORB-SLAM2")["system"] = "ORB-SLAM2";
  const Table table = Make();
  EXPECT_FALSE(table.rows[1].cells[1].difference);
  EXPECT_EQ(table.rows[0].corrections, "0.16 px");
  EXPECT_FALSE(table.columns[1].contract.right_shift_px) << "it is of a row";
}

TEST_F(TableNotesTest, FoldersOfOtherCorrectionsAreNotCompared) {
  suite_.Add(Result());
  SuiteResults corrected;
  corrected.Add(Corrected(Result()));
  EXPECT_THAT(ErrorMessage([&] { CompareFolders(suite_.Written(), corrected.Written()); }),
              HasSubstr("right_shift_px"));
}

TEST_F(TableNotesTest, ReportsCorrectedCalibrations) {
  Json corrected = Result();
  corrected["sequence"]["camera"]["right_shift_px"] = 0.16;
  suite_.Add(corrected);
  suite_.Add(Result("2011_09_26_drive_0013", 72));
  EXPECT_THAT(Make().notes, ElementsAre(AllOf(HasSubstr("drive_0001"), HasSubstr("0.16 px"))));
}

TEST_F(TableNotesTest, SeveralBuildsAreNoted) {
  suite_.Add(Result());
  Json other = Result("2011_09_26_drive_0013");
  other["build"]["identity"] = "xyz";
  suite_.Add(other);
  EXPECT_THAT(Make().notes, ElementsAre(HasSubstr("2 builds of the program")));
}

}  // namespace
}  // namespace cvo::reports
