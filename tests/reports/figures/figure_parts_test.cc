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
  const Shown share = ShownAs("object_success_10cm", "1");
  EXPECT_EQ(share.unit, "%");
  EXPECT_EQ(share.scale, 100.0);
  EXPECT_TRUE(share.higher_is_better);
  const Shown count = ShownAs("object_id_switches", "1");
  EXPECT_EQ(count.unit, "");
  EXPECT_EQ(count.scale, 1.0);
  EXPECT_EQ(AxisTitle(test::ColumnOf("object_ate", "object ATE", "m")), "object ATE (m)");
  EXPECT_EQ(AxisTitle(test::ColumnOf("object_id_switches", "id switches", "1")),
            "id switches (count)");
}

TEST(FigureNumbers, ACellIsWrittenWithItsInterval) {
  const Column column = test::ColumnOf("object_coverage", "object coverage", "1");
  EXPECT_EQ(CellValueText(test::CellOf(0.5, 0.25, 0.75), column), "50 % (25 to 75)");
  EXPECT_EQ(CellValueText({}, column), "no value");
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
