// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests the parts of the page, without any files.
#include "reports/page/page_parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/figures/plot.h"
#include "reports/page/choose_scenes.h"
#include "reports/page/html.h"
#include "reports/page/quantity.h"
#include "reports/page/run_origin.h"
#include "reports/tables/comparisons.h"

namespace cvo::reports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::Pair;

TEST(PageText, EscapesNames) {
  EXPECT_EQ(Escaped("<b a='1' c=\"2\">&"), "&lt;b a=&#39;1&#39; c=&quot;2&quot;&gt;&amp;");
  EXPECT_EQ(Element("p", "a<b"), "<p>a&lt;b</p>");
  EXPECT_EQ(ScriptJson({{"a", "</script><!--"}}), R"({"a":"\u003c/script>\u003c!--"})");
  EXPECT_EQ(Json::parse(ScriptJson({{"a", "</script>"}}))["a"], "</script>");
}

TEST(Quantity, HasUnitsAndSigns) {
  const Column error{"object_ate", "object ATE", "m", {}};
  const Column share{"object_coverage", "object coverage", "1", {}};
  const Column count{"object_id_switches", "id switches", "1", {}};
  EXPECT_EQ(QuantityText(0.0625, error), "0.0625 m");
  EXPECT_EQ(QuantityText(0.5, share), "50 %");
  EXPECT_EQ(QuantityText(3.0, count), "3");
  EXPECT_EQ(ChangeText(0.25, error), "+0.25 m");
  EXPECT_EQ(ChangeText(-0.125, share), "-12.5 percentage points");
  EXPECT_EQ(ChangeText(2.0, count), "+2");
  EXPECT_EQ(RangeText({0.125, 0.25, ""}, error), "0.125 to 0.25 m");
}

TEST(Quantity, DirectionOfImprovementDependsOnTheMetric) {
  EXPECT_EQ(IsBetter("object_ate", -0.1), true);
  EXPECT_EQ(IsBetter("object_ate", 0.1), false);
  EXPECT_EQ(IsBetter("object_coverage", 0.1), true);
  EXPECT_EQ(IsBetter("of their own", 0.1), std::nullopt);
}

TEST(ChangedOptions, HaveValuesAndDefaults) {
  OptionDefaults defaults(R"({"crf":{"alpha":2,"eta":1},"orb":{"features":2000}})");
  const auto changed = defaults.ChangedIn(
      Json::parse(R"({"crf":{"alpha":4,"eta":1},"orb":{"features":2000},"new":1})"));
  ASSERT_EQ(changed.size(), 2U);
  EXPECT_EQ(changed[0].path, "crf.alpha");
  EXPECT_EQ(changed[0].default_value, "2");
  EXPECT_THAT(changed[0].values, ElementsAre("4"));
  EXPECT_EQ(changed[1].path, "new");
  EXPECT_EQ(changed[1].default_value, "");
  EXPECT_THAT(OptionDefaults("").ChangedIn({{"a", 1}}), IsEmpty());
}

PageRun RunOf(const std::string& sequence, const std::string& variant, std::uint64_t seed) {
  PageRun run;
  run.run.planned.keys = {{"sequence", sequence}, {"variant", variant}};
  run.run.planned.seed = seed;
  run.run.run = RunSummary{};
  return run;
}

TEST(ChooseScenes, TakesFirstSeedsAndImagesOfFull) {
  std::vector<PageRun> runs = {RunOf("a", "2d", 2), RunOf("a", "2d", 1), RunOf("a", "full", 1),
                               RunOf("b", "2d", 1), RunOf("b", "static", 1)};
  runs.push_back(RunOf("c", "full", 1));
  runs.back().run.run.reset();  // failed
  const SceneChoice choice = ChooseScenes(runs, "static", 10);
  EXPECT_THAT(choice.scenes,
              ElementsAre(Pair(2U, true), Pair(4U, true), Pair(1U, false), Pair(3U, false)));
  EXPECT_EQ(choice.left_out, 0U);
}

TEST(ChooseScenes, TakesNoMoreThanThePageHolds) {
  const std::vector<PageRun> runs = {RunOf("a", "2d", 1), RunOf("a", "full", 1)};
  const SceneChoice choice = ChooseScenes(runs, "", 1);
  EXPECT_THAT(choice.scenes, ElementsAre(Pair(1U, true)));
  EXPECT_EQ(choice.left_out, 1U);
}

TEST(ChooseScenes, TakesFailuresFirstWhereNotAllFit) {
  std::vector<PageRun> runs = {RunOf("a", "full", 1), RunOf("b", "full", 1), RunOf("c", "full", 1)};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    BodyRow body;
    body.mover = true;
    body.visible_frames = 2;
    body.errors = {{0, 1}, {0.01, i == 1 ? 0.5 : 0.02}};
    runs[i].run.run->bodies = RunBodies{{body}, {}};
  }
  EXPECT_THAT(ChooseScenes(runs, "", 1).scenes, ElementsAre(Pair(1U, true)));
  EXPECT_THAT(ChooseScenes(runs, "", 3).scenes,
              ElementsAre(Pair(0U, true), Pair(1U, true), Pair(2U, true)));
}

TEST(SceneJson, HasMillimetresPerFrame) {
  PageScene scene;
  CameraFrame first;
  first.frame = 10;
  first.timestamp_ns = 5'000'000'000;
  first.status = "first";
  first.world_from_camera = {0.0124, -0.0006, 1.0, 0, 0, 0, 1};
  first.truth = Pose{0.0124, -0.0006, 1.0025, 0, 0, 0, 1};
  CameraFrame second = first;
  second.frame = 12;
  second.timestamp_ns = 5'100'000'000;
  second.truth.reset();
  scene.detail.camera = {first, second};
  ClusterRow row;
  row.frame = 12;
  row.id = 3;
  row.predicted = true;
  row.world_from_object = {1, 2, 3, 0, 0, 0, 1};
  row.object_from_box = {0.5, 0, 0, 0, 1, 0, 0};
  row.size_m = {0.2, 0.4, 0.6};
  scene.detail.clusters = {row};
  BodyDetail body;
  body.name = "car";
  body.cluster = 3;
  body.truth = {{12, Pose{1, 2, 3.5, 0, 0, 0, 1}}, {99, Pose{}}};
  body.estimated = {{12, {1, 2, 3}, 0.5}};
  scene.detail.bodies = {body};
  scene.images = {{12, "foo", "what it shows"}};
  const Json json = SceneJson(scene);
  EXPECT_EQ(json["frames"], Json({10, 12}));
  EXPECT_EQ(json["times_ms"], Json({0, 100}));
  EXPECT_EQ(json["camera"]["estimated"], Json({12, -1, 1000, 12, -1, 1000}));
  EXPECT_EQ(json["camera"]["truth"], Json::parse("[12,-1,1003,null,null,null]"));
  EXPECT_EQ(json["camera"]["errors_um"], Json::parse("[2500,null]"));
  EXPECT_EQ(json["clusters"][0]["frames"], Json({1}));
  EXPECT_EQ(json["clusters"][0]["predicted"], Json({1}));
  EXPECT_EQ(json["clusters"][0]["centers"], Json({500, 0, 0}));
  EXPECT_EQ(json["clusters"][0]["turns"], Json::parse("[0.0,1.0,0.0,0.0]"));
  EXPECT_EQ(json["clusters"][0]["halves"], Json({100, 200, 300}));
  EXPECT_EQ(json["bodies"][0]["frames"], Json({1}));
  EXPECT_EQ(json["bodies"][0]["positions"], Json({1000, 2000, 3500}));
  EXPECT_EQ(json["bodies"][0]["errors"]["um"], Json({500000}));
  EXPECT_EQ(json["images"], Json::parse(R"([[1,"data:image/jpeg;base64,Zm9v","what it shows"]])"));
}

Table TwoRows(double difference, std::size_t pairs, bool distinguishable) {
  Table table;
  table.keys = {"variant"};
  table.columns = {{"object_ate", "object ATE", "m", {}}};
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

TEST(Findings, ADifferenceHasADirectionAndASize) {
  const std::string worse = FindingsHtml(TwoRows(0.25, 8, true), "full");
  EXPECT_THAT(worse, HasSubstr("<h3>2d: worse in 1 of 1 metric</h3>"));
  EXPECT_THAT(worse, HasSubstr("0.5 m instead of 0.25 m with full: +0.25 m (interval 0.125 to 0.5 "
                               "m; 8 pairs)"));
  EXPECT_THAT(FindingsHtml(TwoRows(-0.25, 8, true), "full"), HasSubstr("2d: better in 1 of 1"));
}

TEST(Findings, ColumnsWithEqualLabelsAreDistinguishedByUnit) {
  Table table = TwoRows(0.25, 8, false);
  table.columns.push_back({"object_rrpe", "object ATE", "rad", {}});
  EXPECT_THAT(FindingsHtml(table, "full"), HasSubstr("Not significant: object ATE (m)."));
}

TEST(PageData, CellVerdictsMatchTheSummary) {
  const auto verdict = [](double difference, std::size_t pairs, bool distinguishable) {
    PageContent content;
    content.table = TwoRows(difference, pairs, distinguishable);
    return PageDataJson(content);
  };
  EXPECT_THAT(verdict(0.25, 8, true), HasSubstr("worse"));
  EXPECT_THAT(verdict(0.25, 8, false), HasSubstr("not significant"));
  EXPECT_THAT(verdict(0.25, 5, false), HasSubstr("undecided (5 pairs, 6 needed)"));
}

TEST(Findings, NoiseAndFewPairsAreNoFindings) {
  const std::string noise = FindingsHtml(TwoRows(0.25, 8, false), "full");
  EXPECT_THAT(noise, HasSubstr("2d: no significant difference"));
  EXPECT_THAT(noise, HasSubstr("Not significant: object ATE."));
  const std::string few = FindingsHtml(TwoRows(0.25, 5, false), "full");
  EXPECT_THAT(few, HasSubstr("2d: undecided (5 pairs, 6 needed)"));
  EXPECT_THAT(few, HasSubstr("Undecided (5 pairs, 6 needed): object ATE."));
  Table mixed = TwoRows(0.25, 5, false);
  mixed.columns.push_back({"camera_ate", "camera ATE", "m", {}});
  for (Row& row : mixed.rows) row.cells.push_back(row.cells.front());
  for (Row& row : mixed.rows) {
    if (row.cells.back().difference) row.cells.back().difference->pairs = 1;
  }
  const std::string both = FindingsHtml(mixed, "full");
  EXPECT_THAT(both, HasSubstr("Undecided (1 pair, 6 needed): camera ATE."));
  EXPECT_THAT(both, HasSubstr("Undecided (5 pairs, 6 needed): object ATE."));
  EXPECT_THAT(FindingsHtml(TwoRows(0.0, 8, false), "full"),
              HasSubstr("The same in every metric: 2d."));
  EXPECT_THAT(noise, Not(HasSubstr("<li")));
}

}  // namespace
}  // namespace cvo::reports
