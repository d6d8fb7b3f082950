// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/table_texts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/reports/tables/hostile_table.h"

namespace cvo::reports {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::SizeIs;

Measured With(double value, double low, double high) { return {value, Interval{low, high}}; }

TEST(Digits, FollowTheInterval) {
  // Half widths of 0.0255 and 0.0495 need three decimals. 0.00013 would need five; the value is
  // limited to four digits.
  EXPECT_THAT(ColumnDecimals({With(0.0576, 0.034, 0.085), With(0.104, 0.061, 0.16)}, "m"),
              ElementsAre(3, 3));
  EXPECT_THAT(ColumnDecimals({With(0.9991, 0.9988, 0.99906)}, "1"), ElementsAre(4));
  EXPECT_THAT(ColumnDecimals({With(0.0009, 0.0, 2.0)}, "m"), ElementsAre(5)) << "two digits";
  EXPECT_THAT(ColumnDecimals({With(0.0, -0.02, 0.02)}, "m"), ElementsAre(3));
  EXPECT_THAT(ColumnDecimals({With(1234.5, 1200.0, 1300.0)}, "ms"), ElementsAre(0));
}

TEST(Digits, AreSharedByTheColumnWithinLimits) {
  EXPECT_THAT(ColumnDecimals({With(0.06251, 0.062, 0.063), With(9.5123, 8.0, 11.0)}, "m"),
              ElementsAre(5, 3));
}

TEST(Digits, FollowTheUnitWithoutAnInterval) {
  EXPECT_THAT(ColumnDecimals({{0.0625, {}}, {0.0009, {}}, {0.0, {}}}, "m"), ElementsAre(4, 5, 4));
  EXPECT_THAT(ColumnDecimals({{0.5, {}}}, "1"), ElementsAre(3));
  EXPECT_THAT(ColumnDecimals({{1.5, {}}}, "%"), ElementsAre(2));
  EXPECT_THAT(ColumnDecimals({{58.0, {}}, {0.0, {}}}, "deg/100 m"), ElementsAre(2, 3));
  EXPECT_THAT(ColumnDecimals({With(0.02, 0.02, 0.02 + 1e-17)}, "m"), ElementsAre(4));
  EXPECT_THAT(ColumnDecimals({}, "m"), SizeIs(0));
}

TEST(Digits, AreFewForCounts) {
  EXPECT_THAT(ColumnDecimals({{3.0, {}}, {1.25, {}}}, kCountUnit), ElementsAre(0, 2));
  EXPECT_THAT(ColumnDecimals({With(1.5, 0.0, 4.0), With(0.0, 0.0, 0.0)}, kCountUnit),
              ElementsAre(1, 1));
}

TEST(Digits, OfDifferencesFollowThoseOfTheValues) {
  Table table = test::HostileTable();
  Difference& difference = *table.rows[1].cells[3].difference;
  difference.difference = -3e-8;
  difference.interval = Interval{-1e-7, 2e-8};
  difference.percent = -0.001;
  const CellText cell = MakeTexts(table).blocks[1].lines[0].cells[3];
  EXPECT_EQ(cell.value, "+0.0000");
  EXPECT_EQ(cell.interval, "0.0000..0.0000");
  EXPECT_EQ(cell.percent, "+0.0%");
}

TEST(Digits, ZeroHasNoSign) {
  EXPECT_EQ(Fixed(-0.0004, 3), "0.000");
  EXPECT_EQ(Fixed(-0.0006, 3), "-0.001");
  EXPECT_EQ(Fixed(1e300, 2), "1e+300");
}

TEST(TableTexts, HaveOneLinePerRowAndPerReferenceRow) {
  const Table table = test::HostileTable();
  const TableTexts texts = MakeTexts(table);
  EXPECT_THAT(texts.text_header, ElementsAre("sequence", "variant", "frames", "truth", "runs"));
  ASSERT_THAT(texts.blocks, SizeIs(2));
  ASSERT_THAT(texts.blocks[0].lines, SizeIs(4 + 5 + 1));
  const TextLine& full = texts.blocks[0].lines[0];
  EXPECT_EQ(full.row, &table.rows[0]);
  EXPECT_FALSE(full.theirs);
  EXPECT_THAT(full.texts, ElementsAre(test::kScript, "full", "0:72", "devkit", "2/2"));
  EXPECT_EQ(full.cells[3].value, "0.058");
  EXPECT_EQ(full.cells[3].interval, "0.034..0.085");
  EXPECT_EQ(full.cells[3].n, "1 scene, 2 seeds, 2 runs");
  const TextLine& rooms = texts.blocks[0].lines[9];
  EXPECT_FALSE(rooms.row);
  EXPECT_EQ(rooms.theirs, &table.others[0]);
  EXPECT_TRUE(rooms.grey);
  EXPECT_EQ(texts.columns[3], "object ATE [m]");
}

TEST(TableTexts, ExplainIncomparableAndMissingFigures) {
  const std::vector<TextLine> lines = MakeTexts(test::HostileTable()).blocks[0].lines;
  EXPECT_EQ(lines[1].cells[4].value, "-");
  EXPECT_EQ(lines[1].cells[4].note, "no value in any run, <i>not</i> 100 % & more");
  EXPECT_TRUE(lines[2].cells[1].grey);
  EXPECT_EQ(lines[2].cells[1].note, "defined differently: delta \"1 frame\"");
  EXPECT_EQ(lines[3].cells[1].note, "inferred, not stated: poses");
  EXPECT_FALSE(lines[3].cells[1].grey);
  EXPECT_EQ(lines[4].cells[1].note, "frames 0:144, ours 0:72");
  EXPECT_EQ(lines[5].cells[1].note, "colour images, ours grey");
  EXPECT_EQ(lines[6].cells[1].note, "contract not stated: alignment");
  EXPECT_EQ(lines[7].cells[1].note, "alignment differs");
  EXPECT_TRUE(lines[7].cells[1].grey && lines[7].grey);
  EXPECT_EQ(lines[9].cells[3].note, "other scenes");
  EXPECT_EQ(lines[9].cells[1].value, "") << "a source without the metric has nothing to say";
}

TEST(TableTexts, DifferencesHaveSeparateLines) {
  const Table table = test::HostileTable();
  const TextBlock block = MakeTexts(table).blocks[1];
  ASSERT_THAT(block.lines, SizeIs(1));
  EXPECT_EQ(block.lines[0].row, &table.rows[1]);
  const CellText& cell = block.lines[0].cells[3];
  EXPECT_EQ(cell.value, "+0.047");
  EXPECT_EQ(cell.interval, "0.011..0.087");
  EXPECT_EQ(cell.percent, "+81.0%");
  EXPECT_EQ(cell.n, "11 pairs");
  EXPECT_TRUE(cell.distinguishable);
  EXPECT_EQ(block.lines[0].cells[0], CellText{});
}

TEST(Footnotes, DistinguishColumnsWithEqualLabelsByUnit) {
  Table table = test::HostileTable();
  table.columns[0].label = table.columns[1].label;
  EXPECT_THAT(MakeTexts(table).footnotes,
              Contains("camera ATE [m]: root mean square of position errors"));
}

}  // namespace
}  // namespace cvo::reports
