// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/make_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/reports/result_files.h"

namespace cvo::reports {
namespace {

using test::Json;
using test::Result;
using test::WriteResult;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class MakeTableTest : public testing::Test {
 protected:
  void Add(const std::string& name, const Json& result) {
    entries_.push_back({"", WriteResult(folder_, name, result), ""});
  }
  void AddText(const std::string& name, const std::string& text) {
    entries_.push_back({name, folder_.Write(name + "/result.json", text), ""});
  }
  Table Make() const { return MakeTable({"title", CameraMetrics(), folder_.path(), entries_}, {}); }
  std::string MakeError() const {
    try {
      Make();
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  test::TempFolder folder_;
  std::vector<TableEntry> entries_;
};

TEST_F(MakeTableTest, SaysWhereTheCalibrationWasCorrected) {
  Json corrected = Result();
  corrected["sequence"]["camera"]["right_shift_px"] = 0.16;
  Add("a", corrected);
  Add("b", Result("2011_09_26_drive_0013", 72));
  EXPECT_THAT(Make().notes, ElementsAre(AllOf(HasSubstr("drive_0001"), HasSubstr("0.16 px"))));
}

TEST_F(MakeTableTest, OneRun) {
  Add("a", Result());
  const Table table = Make();
  ASSERT_THAT(table.columns, SizeIs(2));
  EXPECT_EQ(table.columns[0].metric, "camera_coverage");
  EXPECT_EQ(table.columns[1].label, "ATE");
  EXPECT_EQ(table.columns[1].contract.count("truth"), 0u);
  EXPECT_EQ(table.columns[1].contract.at("poses"), "refined");
  ASSERT_THAT(table.rows, SizeIs(1));
  const Row& row = table.rows[0];
  EXPECT_EQ(row.sequence.name, "2011_09_26_drive_0001");
  EXPECT_EQ(row.truth, "devkit");
  EXPECT_EQ(row.status, "ok");
  EXPECT_THAT(row.links, ElementsAre("a/result.json"));
  EXPECT_TRUE(row.cells[1].present);
  EXPECT_EQ(row.cells[1].value, 0.0625);
  EXPECT_EQ(row.cells[1].n, 108);
  EXPECT_EQ(row.cells[1].left_out, "1 frame");
  EXPECT_FALSE(row.cells[1].interval.has_value());
  EXPECT_THAT(table.notes, IsEmpty());
  EXPECT_TRUE(IsComplete(table));
}

TEST_F(MakeTableTest, NoEntriesIsAnError) { EXPECT_THAT(MakeError(), HasSubstr("none was given")); }

TEST_F(MakeTableTest, SeedsShareARow) {
  for (const int seed : {2, 0, 1}) {
    Json result = Result();
    result["seed"] = seed;
    result["metrics"][1]["value"] = 0.1 * (seed + 1);
    Add("seed" + std::to_string(seed), result);
  }
  const Table table = Make();
  ASSERT_THAT(table.rows, SizeIs(1));
  EXPECT_THAT(table.rows[0].seeds, ElementsAre(0, 1, 2));
  EXPECT_THAT(table.rows[0].links,
              ElementsAre("seed0/result.json", "seed1/result.json", "seed2/result.json"));
  const Cell& cell = table.rows[0].cells[1];
  EXPECT_NEAR(cell.value, 0.2, 1e-15);
  EXPECT_EQ(cell.n, 324);
  ASSERT_TRUE(cell.interval.has_value());
  EXPECT_EQ(cell.interval->low, 0.1);
  EXPECT_NEAR(cell.interval->high, 0.3, 1e-15);
}

TEST_F(MakeTableTest, VariantsAndFrameRangesHaveTheirOwnRows) {
  Add("a", Result());
  Json other = Result();
  other["variant"] = "full";
  Add("b", other);
  Add("c", Result("2011_09_26_drive_0001", 50));
  EXPECT_THAT(Make().rows, SizeIs(3));
}

TEST_F(MakeTableTest, TheSameRunTwiceIsAnErrorThatNamesBoth) {
  Add("a", Result());
  Add("b", Result());
  EXPECT_THAT(MakeError(), AllOf(HasSubstr("a/result.json"), HasSubstr("b/result.json")));
}

TEST_F(MakeTableTest, OtherContractsAreRefusedNamingBothAndTheField) {
  Add("a", Result());
  Json other = Result("2011_09_26_drive_0013");
  other["metrics"][1]["contract"]["alignment"] = "Sim(3)";
  Add("b", other);
  EXPECT_THAT(MakeError(),
              AllOf(HasSubstr("metric camera_ate"), HasSubstr("a/result.json with alignment \"SE"),
                    HasSubstr("b/result.json with alignment \"Sim(3)\"")));
}

TEST_F(MakeTableTest, AContractWithoutAFieldIsAnotherContract) {
  Add("a", Result());
  Json other = Result("2011_09_26_drive_0013");
  other["metrics"][1]["contract"].erase("poses");
  Add("b", other);
  EXPECT_THAT(MakeError(), HasSubstr("b/result.json with poses \"\""));
}

TEST_F(MakeTableTest, UnitsMustAgree) {
  Add("a", Result());
  Json other = Result("2011_09_26_drive_0013");
  other["metrics"][1]["unit"] = "cm";
  Add("b", other);
  EXPECT_THAT(MakeError(), HasSubstr("unit \"cm\""));
}

TEST_F(MakeTableTest, TheTruthMayDifferBetweenDatasetsOnly) {
  Add("a", Result());
  Json odometry = Result("odometry_06", 51);
  odometry["sequence"]["type"] = "kitti-odometry";
  for (Json& metric : odometry["metrics"]) metric["contract"]["truth"] = "official";
  Add("b", odometry);
  EXPECT_EQ(Make().rows[1].truth, "official");
  Json interpolated = Result("2011_09_26_drive_0013");
  for (Json& metric : interpolated["metrics"]) metric["contract"]["truth"] = "interpolated";
  Add("c", interpolated);
  EXPECT_THAT(MakeError(), AllOf(HasSubstr("a/result.json with truth \"devkit\""),
                                 HasSubstr("c/result.json with truth \"interpolated\"")));
}

TEST_F(MakeTableTest, WhatIsLeftOutMayDiffer) {
  Add("a", Result());
  Json other = Result("2011_09_26_drive_0013");
  other["metrics"][1]["contract"]["left_out"] = "7 frames";
  Add("b", other);
  EXPECT_EQ(Make().rows[1].cells[1].left_out, "7 frames");
}

TEST_F(MakeTableTest, OtherOptionsAndBuildsAreNoted) {
  Add("a", Result());
  Json other = Result("2011_09_26_drive_0013");
  other["options"]["orb"]["features"] = 1000;
  other["build"]["identity"] = "xyz";
  Add("b", other);
  EXPECT_THAT(Make().notes, ElementsAre(HasSubstr("b/result.json: other options than in"),
                                        HasSubstr("b/result.json: another build")));
}

TEST_F(MakeTableTest, MissingMetricsAreSaidPlainly) {
  Add("a", Result());
  Json coverage_only = Result("2011_09_26_drive_0013");
  coverage_only["metrics"].erase(1);
  Add("b", coverage_only);
  Json none = Result("2011_09_26_drive_0014");
  none.erase("metrics");
  Add("c", none);
  const Table table = Make();
  EXPECT_TRUE(table.rows[1].cells[0].present);
  EXPECT_FALSE(table.rows[1].cells[1].present);
  EXPECT_EQ(table.rows[1].cells[1].message, "not in the result");
  EXPECT_FALSE(table.rows[2].cells[0].present);
}

TEST_F(MakeTableTest, ALostRunKeepsItsFiguresAndItsMessage) {
  Json lost = Result();
  lost["status"] = "lost";
  lost["message"] = "3 frames predicted";
  Add("a", lost);
  const Table table = Make();
  EXPECT_EQ(table.rows[0].status, "lost");
  EXPECT_EQ(table.rows[0].message, "3 frames predicted");
  EXPECT_TRUE(table.rows[0].cells[1].present);
  EXPECT_TRUE(IsComplete(table));
}

TEST_F(MakeTableTest, RunsThatGaveNothingHaveARow) {
  Add("a", Result());
  entries_.push_back({"2011_09_26_drive_0013", "", "image_01 is missing"});
  const Table table = Make();
  EXPECT_EQ(table.rows[1].sequence.name, "2011_09_26_drive_0013");
  EXPECT_EQ(table.rows[1].status, "failed");
  EXPECT_EQ(table.rows[1].message, "image_01 is missing");
  EXPECT_THAT(table.rows[1].cells, SizeIs(2));
  EXPECT_FALSE(IsComplete(table));
}

TEST_F(MakeTableTest, UnreadableResultsHaveARowThatSaysWhy) {
  Add("good", Result());
  AddText("half", Result().dump().substr(0, 300));
  AddText("empty", "");
  Json newer = Result();
  newer["schema_version"] = 3;
  AddText("newer", newer.dump());
  AddText("other", R"({"schema_version": 2, "kind": "timing"})");
  Json nameless = Result();
  nameless["sequence"].erase("name");
  AddText("nameless", nameless.dump());
  Json textual = Result();
  textual["metrics"][0]["value"] = "1.0";
  AddText("textual", textual.dump());
  entries_.push_back({"gone", folder_.path() / "gone/result.json", ""});
  const Table table = Make();
  ASSERT_THAT(table.rows, SizeIs(8));
  const auto message = [&table](std::size_t row) {
    EXPECT_EQ(table.rows[row].status, "unreadable");
    return table.rows[row].message;
  };
  EXPECT_THAT(message(1), HasSubstr("half/result.json: found text that ends after 300 bytes"));
  EXPECT_THAT(message(2), HasSubstr("found an empty file"));
  EXPECT_THAT(message(3), HasSubstr("found schema_version 3, expected 2"));
  EXPECT_THAT(message(4), HasSubstr("kind \"timing\""));
  EXPECT_THAT(message(5), HasSubstr("sequence, field name: found nothing"));
  EXPECT_THAT(message(6), HasSubstr("metrics, field value: found a JSON string"));
  EXPECT_THAT(message(7), HasSubstr("no file that can be read"));
  EXPECT_EQ(table.rows[0].status, "ok");
  EXPECT_FALSE(IsComplete(table));
}

}  // namespace
}  // namespace cvo::reports
