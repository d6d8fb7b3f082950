// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/files/json/json.h"
#include "experiments/record/truth_file.h"

namespace cvo {
namespace {

RigidTransform At(double x) { return {Eigen::Quaterniond::Identity(), Eigen::Vector3d(x, 0, 0)}; }

// The origin of the run's world is at x = 1 m in the world of the truth; body 2 is scored in frame
// 1 only.
TEST(TruthFile, PutsTheTruthIntoTheWorldOfTheRun) {
  ObjectTruth objects;
  objects.timestamps_ns = {0, 1};
  TruthBody body;
  body.id = 2;
  body.diagonal_m = 0.5;
  body.frames = {std::nullopt, BodyFrame{At(5), true}};
  objects.bodies = {body};
  BodyScore score;
  score.id = 2;
  score.name = "ball";
  score.cluster = 7;
  score.errors = {{1}, {0.25}};
  score.estimated_positions = {{5.25, 0, 0}};
  const std::vector<BodyScore> bodies = {score};
  const OptionalPoses camera = {At(1), std::nullopt};
  const Json file = ParseJson(TruthFile("id", {&camera, &objects, At(1), &bodies}), "truth.json");
  EXPECT_EQ(file["job"], "id");
  EXPECT_EQ(file["camera"][0], Json({0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}));
  EXPECT_TRUE(file["camera"][1].is_null());
  const Json& ball = file["bodies"][0];
  EXPECT_EQ(ball["cluster"], 7);
  EXPECT_EQ(ball["truth"]["frames"], Json({1}));
  EXPECT_EQ(ball["truth"]["poses"][0][0], 4.0);
  EXPECT_EQ(ball["truth"]["visible"], Json({true}));
  EXPECT_EQ(ball["estimated"]["positions_m"], Json::parse("[[4.25, 0.0, 0.0]]"));
  EXPECT_EQ(ball["predicted"]["frames"], Json::array());
}

TEST(TruthFile, ReportsMissingTruth) {
  const Json file = ParseJson(TruthFile("id", {}), "truth.json");
  EXPECT_TRUE(file["camera"].empty());
  EXPECT_TRUE(file["bodies"].empty());
}

}  // namespace
}  // namespace cvo
