// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/suite/cell_input.h"
#include "experiments/suite/parse_suite.h"
#include "experiments/suite/suite_grid.h"
#include "tests/experiments/suite/examples.h"
#include "tests/support/error_message.h"

namespace cvo {
namespace {

using test::Parse;
using test::SmallSuite;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

std::vector<Json> Values(const Json& json) { return ParseAxisValues(json, "axis"); }

TEST(Grid, RangesAreLinearOrLogarithmic) {
  EXPECT_THAT(Values({{"from", 1}, {"to", 7}, {"steps", 4}}), ElementsAre(1, 3, 5, 7));
  EXPECT_TRUE(Values({{"from", 1}, {"to", 7}, {"steps", 4}})[1].is_number_integer());
  EXPECT_THAT(Values({{"from", 0.0}, {"to", 1.0}, {"steps", 3}}), ElementsAre(0.0, 0.5, 1.0));
  EXPECT_THAT(Values({{"from", 0.01}, {"to", 1}, {"steps", 3}, {"scale", "log"}}),
              ElementsAre(0.01, 0.1, 1));
  // The geometric mean of 1 and 10 in six digits, as a person would write it.
  EXPECT_EQ(Values({{"from", 1}, {"to", 10}, {"steps", 3}, {"scale", "log"}})[1], Json(3.16228));
}

TEST(Grid, RefusesInvalidRanges) {
  for (const char* wrong : {R"({"from": 0, "to": 1, "steps": 3, "scale": "log"})",
                            R"({"from": 0, "to": 1})", R"({"from": 0, "to": 1, "steps": 1})",
                            R"({"from": 0, "to": 1, "steps": 3, "scael": "log"})",
                            R"({"from": 0, "to": 1, "steps": 3, "scale": "cubic"})",
                            R"({"from": 1, "to": 1, "steps": 2})", "3", "[]"}) {
    EXPECT_THAT(ErrorMessage([&] { Values(Json::parse(wrong)); }), testing::StartsWith("axis"))
        << wrong;
  }
}

Suite WithGrid(const Json& grid, bool one_at_a_time) {
  Json json = SmallSuite();
  json["grid"] = grid;
  json["grid_one_at_a_time"] = one_at_a_time;
  json["table"]["rows"] = Json::array();
  for (const auto& [path, values] : grid.items()) json["table"]["rows"].push_back(path);
  return Parse(json);
}

TEST(Grid, CombinesAllAxes) {
  const Suite suite = WithGrid({{"window.spatial", {3, 4}}, {"unary.eta", {0.5, 0.9}}}, false);
  EXPECT_THAT(GridPoints(suite, suite.sequences[0], "full"),
              ElementsAre(ElementsAre(Pair("window.spatial", 3), Pair("unary.eta", 0.5)),
                          ElementsAre(Pair("window.spatial", 3), Pair("unary.eta", 0.9)),
                          ElementsAre(Pair("window.spatial", 4), Pair("unary.eta", 0.5)),
                          ElementsAre(Pair("window.spatial", 4), Pair("unary.eta", 0.9))));
}

TEST(Grid, OneAtATimeHasTheDefaultOnce) {
  const Options defaults;
  const int spatial = defaults.window.spatial;
  const double eta = defaults.unary.eta;
  const Suite suite =
      WithGrid({{"window.spatial", {spatial, spatial + 1}}, {"unary.eta", {0.5, eta}}}, true);
  EXPECT_THAT(GridPoints(suite, suite.sequences[0], "full"),
              ElementsAre(ElementsAre(Pair("window.spatial", spatial), Pair("unary.eta", eta)),
                          ElementsAre(Pair("window.spatial", spatial + 1), Pair("unary.eta", eta)),
                          ElementsAre(Pair("window.spatial", spatial), Pair("unary.eta", 0.5))));
}

TEST(Grid, AxisDefaultsComeFromTheSuiteAndTheScene) {
  Suite suite = WithGrid({{"window.spatial", {3, 4}}}, true);
  suite.options = {{"window", {{"spatial", 4}}}};
  EXPECT_THAT(
      GridPoints(suite, suite.sequences[0], "full"),
      ElementsAre(ElementsAre(Pair("window.spatial", 4)), ElementsAre(Pair("window.spatial", 3))));
  suite = WithGrid({{"scene.detector.miss_rate", {0.5}}, {"scene.camera.height_m", {1.2}}}, true);
  const double good = 0.01;  // miss rate of that level, see synth/detector/detector_options.h
  EXPECT_THAT(
      GridPoints(suite, suite.sequences[0], "full").front(),
      ElementsAre(Pair("scene.detector.miss_rate", good), Pair("scene.camera.height_m", 1.1)));
}

TEST(ExpandSuite, OrdersCellsBySequenceSeedPointOracleVariant) {
  Json json = SmallSuite();
  json["sequences"].push_back({{"scene", "crowd"}});
  json["seeds"] = {4, 2};
  json["variants"] = {"full", "static"};
  json["oracles"] = Json::array({Json::array(), {"camera"}});
  json["table"]["rows"] = {"variant", "oracle"};
  json["systems"] =
      Json::array({{{"name", "other"}, {"files", {{{"sequence", "crowd"}, {"camera", "c.txt"}}}}}});
  const std::vector<Cell> cells = ExpandSuite(Parse(json));
  ASSERT_EQ(cells.size(), 17U);
  EXPECT_EQ(cells[0].variant, "full");
  EXPECT_EQ(cells[1].variant, "static");
  EXPECT_THAT(cells[2].oracle, ElementsAre("camera"));
  EXPECT_EQ(cells[3].seed, 4U);
  EXPECT_EQ(cells[4].seed, 2U);
  EXPECT_EQ(cells[8].sequence.name, "crowd");
  EXPECT_EQ(cells[16].system, "other");
  EXPECT_EQ(cells[16].variant, "");
}

TEST(CellInput, AChangedDetectorStartsFromTheLevelOfTheSequence) {
  Cell cell;
  cell.sequence = Parse(SmallSuite()).sequences[0];
  cell.sequence.detections = "poor";
  EXPECT_TRUE(SceneAssignments(cell.sequence, {}).empty());
  EXPECT_EQ(RequestOf(cell, "/s", "", "").detections_file, "/s/detections/poor.txt");
  cell.parameters = {{"scene.detector.miss_rate", 0.5}, {"window.spatial", 3}};
  EXPECT_THAT(SceneAssignments(cell.sequence, cell.parameters),
              ElementsAre("detector.level=poor", "detector.miss_rate=0.5"));
  EXPECT_EQ(RequestOf(cell, "/s", "", "").detections_file, "/s/detections/custom.txt");
}

TEST(CellInput, AGridPointOverridesTheSuiteOptions) {
  Suite suite = Parse(SmallSuite());
  suite.options = {{"window", {{"spatial", 4}, {"temporal", 9}}}};
  const Options options = OptionsOf(suite, "full", {{"window.spatial", 3}});
  EXPECT_EQ(options.window.spatial, 3);
  EXPECT_EQ(options.window.temporal, 9);
}

TEST(CellInput, AFolderIsReadAsTheSequenceSays) {
  Cell cell;
  cell.sequence.folder = "x";
  cell.sequence.frames = "2:7";
  cell.sequence.groundtruth = "interpolated";
  cell.sequence.detections = "boxes/0003.txt";
  cell.sequence.detections_camera = 2;
  cell.sequence.min_score = 0.25;
  cell.sequence.labels = "labels.txt";
  const SequenceRequest request = RequestOf(cell, "/found/x", "/data", "");
  EXPECT_EQ(request.folder, "/found/x");
  EXPECT_EQ(request.begin_frame, 2);
  EXPECT_EQ(request.end_frame, 7);
  EXPECT_EQ(request.groundtruth, "interpolated");
  EXPECT_EQ(request.detections_file, "/data/boxes/0003.txt");
  EXPECT_EQ(request.detections_camera, 2);
  EXPECT_EQ(request.min_score, 0.25);
  EXPECT_EQ(request.labels_file, "/data/labels.txt");
}

TEST(Suite, JobsOfTheFirstSeedKeepLandmarksIfRequested) {
  Json json = SmallSuite();
  json["seeds"] = {7, 8};
  for (const Cell& cell : ExpandSuite(Parse(json))) EXPECT_FALSE(cell.landmarks);
  json["landmarks"] = true;
  const Suite suite = Parse(json);
  for (const Cell& cell : ExpandSuite(suite)) EXPECT_EQ(cell.landmarks, cell.seed == 7);
  EXPECT_EQ(SuiteToJson(suite)["landmarks"], true);
}

}  // namespace
}  // namespace cvo
