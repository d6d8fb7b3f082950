// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "reports/figures/figure_style.h"
#include "tests/reports/figures/drawn_suite.h"

namespace cvo::reports {
namespace {

TEST(FigureNumbers, AreWrittenWithoutExponents) {
  EXPECT_EQ(NumberText(0.0123456), "0.0123");
  EXPECT_EQ(NumberText(12.0), "12");
  EXPECT_EQ(NumberText(-0.5), "-0.5");
  EXPECT_EQ(NumberText(123456.0), "123000");
  EXPECT_EQ(NumberText(0.00001), "0.00001");
  EXPECT_EQ(NumberText(0.0), "0");
}

TEST(FigureNumbers, SharesAreInPercentAndCountsHaveNoUnit) {
  const Column column = test::ColumnOf("object_success_10cm", "within 10 cm", "1");
  const Shown share = ShownAs(column, 0.5);
  EXPECT_EQ(share.unit, "%");
  EXPECT_EQ(share.scale, 100.0);
  EXPECT_EQ(share.Text(0.5), "50 %");
  const Column switches = test::ColumnOf("object_id_switches", "id switches", "1");
  const Shown count = ShownAs(switches, 3.0);
  EXPECT_EQ(count.unit, "");
  EXPECT_EQ(count.scale, 1.0);
  EXPECT_EQ(AxisTitle(switches, count), "id switches (count)");
}

TEST(FigureNumbers, LengthsAndAnglesHaveReadableUnits) {
  const Column ate = test::ColumnOf("object_ate", "object ATE", "m");
  EXPECT_EQ(ShownAs(ate, 0.002).Text(0.00031), "0.31 mm");
  EXPECT_EQ(ShownAs(ate, 0.2).Text(0.0312), "3.12 cm");
  EXPECT_EQ(ShownAs(ate, 2.0).Text(0.5), "0.5 m");
  EXPECT_EQ(AxisTitle(ate, ShownAs(ate, 0.2)), "object ATE (cm)");
  EXPECT_EQ(ShownAs(test::ColumnOf("camera_rrpe_1_frame", "R.RPE", "rad"), 0.1).Text(0.017453293),
            "1 deg");
}

TEST(FigureNumbers, EventsOfNoBodyAreNotDrawn) {
  SuiteData data = test::SweptSuite("a", {1, 2});
  Table& table = data.table;
  table.columns[0] = test::ColumnOf("object_id_switches", "id switches", "1");
  EXPECT_TRUE(IsDrawn(table, table.rows[0], 0));
  table.rows[0].cells[1].value = 0.0;
  EXPECT_FALSE(IsDrawn(table, table.rows[0], 0));
  EXPECT_TRUE(IsDrawn(table, table.rows[0], 1));
}

TEST(FigureTexts, AreListedAndMadeFileNames) {
  EXPECT_EQ(Slug("Room <1>, a/../b"), "room-1-a-b");
  EXPECT_EQ(Slug("<>"), "x");
}

TEST(FigureTexts, RelationTextSummarisesTheContract) {
  Column ate = test::ColumnOf("object_ate", "object ATE", "m");
  Column rpe = test::ColumnOf("object_trpe_all_pairs", "object T.RPE", "m");
  rpe.contract.delta = Delta::kAll;
  rpe.contract.alignment = Alignment::kNone;
  const Column share = test::ColumnOf("object_coverage", "object coverage", "1");
  EXPECT_EQ(RelationText({&ate, &rpe, &share}),
            "object ATE: aligned by SE(3) over positions; object T.RPE: delta all, not aligned");
  rpe.contract = ate.contract;
  EXPECT_EQ(RelationText({&ate, &rpe}),
            "object ATE, object T.RPE: aligned by SE(3) over positions");
}

TEST(Palette, RepeatedColoursAreDashed) {
  std::vector<std::string> names;
  for (int i = 0; i < 12; ++i) names.push_back("variant " + std::to_string(i));
  const Palette palette(names);
  EXPECT_EQ(palette.Line("variant 0").colour, palette.Line("variant 8").colour);
  EXPECT_NE(palette.Line("variant 0").dash, palette.Line("variant 8").dash);
  EXPECT_NE(palette.Points("variant 0").symbol, palette.Points("variant 8").symbol);
}

}  // namespace
}  // namespace cvo::reports
