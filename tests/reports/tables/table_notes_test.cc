// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests how tables keep apart rows that look alike: corrected calibrations and other CPU levels.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "reports/tables/make_table.h"
#include "reports/tables/table_texts.h"
#include "tests/core/record/result_files.h"
#include "tests/support/error_message.h"

namespace cvo::reports {
namespace {

using test::Json;
using test::Result;
using test::SuiteResults;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

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

TEST_F(TableNotesTest, RowsWithAndWithoutACorrectionDoNotCompeteForBest) {
  suite_.table["reference"] = "static";
  Json ours = Result();
  ours["metrics"][1]["value"] = 0.01;
  suite_.Add(Corrected(ours));
  suite_.Add(Result(), "system:ORB-SLAM2")["system"] = "ORB-SLAM2";
  const auto marks = [](const Table& table) {
    int best = 0;
    const TableTexts texts = MakeTexts(table);
    for (const TextLine& line : texts.blocks[0].lines) {
      for (const CellText& cell : line.cells) best += cell.best ? 1 : 0;
    }
    return best;
  };
  const Table table = Make();
  EXPECT_EQ(marks(table), 0);
  EXPECT_FALSE(table.rows[1].cells[1].difference);
  EXPECT_EQ(table.rows[0].corrections, "0.16 px");
  EXPECT_FALSE(table.columns[1].contract.right_shift_px) << "it is of a row";
  suite_.Add(Corrected(Result()), "full");
  EXPECT_EQ(marks(Make()), 1) << "ours among themselves";
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

TEST_F(TableNotesTest, SaysWhatSelfCalibrationFoundOnRecordings) {
  Json result = Result();
  result["calibration"] = {{"right_field_px", {0.291, 0.3, 0.0, 0.9, 0.0, 0.0}},
                           {"sigma_px", {0.021, 0.1, 0.1, 0.1, 0.1, 0.1}}};
  suite_.Add(result);
  suite_.Add(Result("2011_09_26_drive_0013", 72))["calibration"] = nullptr;
  EXPECT_THAT(Make().notes, ElementsAre(AllOf(HasSubstr("drive_0001: calibration error found"),
                                              HasSubstr("0.29 +- 0.02"))));
}

TEST_F(TableNotesTest, CpuLevelsAreNoted) {
  Json fast = Result();
  fast["build"]["cpu_level"] = "avx2";
  suite_.Add(fast);
  Json plain = Result("2011_09_26_drive_0013");
  plain["build"] = {{"identity", "xyz"}, {"cpu_level", "plain x86-64"}};
  suite_.Add(plain);
  const auto note = ElementsAre(HasSubstr("different levels (avx2, plain x86-64)"));
  EXPECT_THAT(Make().notes, note) << "and not that the builds are two";
  SuiteResults before, after;
  before.Add(fast);
  plain["sequence"] = fast["sequence"];
  after.Add(plain);
  EXPECT_THAT(CompareFolders(before.Written(), after.Written()).notes, note);
}

}  // namespace
}  // namespace cvo::reports
