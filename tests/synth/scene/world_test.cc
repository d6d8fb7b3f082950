// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <set>

#include "synth/scene/description.h"
#include "synth/scene/shipped_scenes.h"
#include "tests/support/error_message.h"
#include "tests/synth/scene/examples.h"

namespace cvo::synth::world_test {
namespace {

using test::Ball;
using test::EmptyScene;
using testing::HasSubstr;

std::string MessageFor(const Json& scene) {
  return ErrorMessage([&] { BuildWorld(SceneDescription::Parse(scene, "here"), 1); });
}

TEST(BuildWorld, TinyMatchesItsFile) {
  const World world = BuildWorld(SceneDescription::Load("tiny", {}), 1);
  EXPECT_EQ(world.name, "tiny");
  ASSERT_EQ(world.bodies.size(), 3u);
  EXPECT_EQ(world.bodies[1].name, "chair_1");
  EXPECT_EQ(world.bodies[1].category, "Chair");
  EXPECT_EQ(world.bodies[1].id, 2);
  EXPECT_EQ(world.bodies[0].size_m, Eigen::Vector3d::Constant(0.5));
  EXPECT_NEAR(world.light.direction.norm(), 1.0, 1e-12);
  // A ball's centre is its radius above the floor.
  EXPECT_NEAR(world.bodies[0].motion->At(0.1).world_from_body.translation().z(), 0.25, 1e-9);
  std::set<int> drawn;
  for (const Drawable& drawable : world.drawables) {
    drawn.insert(drawable.body);
    ASSERT_LT(drawable.texture, static_cast<int>(world.textures.size()));
    EXPECT_FALSE(world.meshes.at(drawable.mesh).indices.empty());
  }
  EXPECT_EQ(drawn, (std::set<int>{0, 1, 2, 3}));
  std::set<const unsigned char*> pictures;
  for (const cv::Mat& texture : world.textures) pictures.insert(texture.data);
  EXPECT_EQ(pictures.size(), world.textures.size());
}

TEST(BuildWorld, ContrastScalesTexturesAboutTheirMean) {
  const auto deviation = [](const std::string& contrast) {
    const World world =
        BuildWorld(SceneDescription::Load("tiny", {"texture_contrast=" + contrast}), 1);
    double sum = 0.0;
    for (const cv::Mat& texture : world.textures) {
      cv::Scalar mean, deviations;
      cv::meanStdDev(texture, mean, deviations);
      sum += deviations[0];
    }
    return sum / static_cast<double>(world.textures.size());
  };
  const double as_painted = deviation("1");
  EXPECT_LT(deviation("0"), 1e-9);
  EXPECT_NEAR(deviation("0.5"), 0.5 * as_painted, 0.05 * as_painted);
}

TEST(BuildWorld, BrightnessScalesAllLight) {
  const World world = BuildWorld(SceneDescription::Load("tiny", {"light.brightness=0.5"}), 1);
  const World usual = BuildWorld(SceneDescription::Load("tiny", {}), 1);
  EXPECT_NEAR(world.light.directional, 0.5 * usual.light.directional, 1e-12);
  EXPECT_NEAR(world.light.ambient, 0.5 * usual.light.ambient, 1e-12);
}

TEST(BuildWorld, ShippedScenesAreValid) {
  for (const ShippedScene& shipped : ShippedScenes()) {
    EXPECT_EQ(ErrorMessage([&] { BuildWorld(SceneDescription::Load(shipped.name, {}), 2); }), "");
  }
}

TEST(BuildWorld, IsTheSameForEveryNumberOfThreads) {
  const SceneDescription scene = SceneDescription::Load("tiny", {});
  const World one = BuildWorld(scene, 1);
  const World four = BuildWorld(scene, 4);
  ASSERT_EQ(one.meshes.size(), four.meshes.size());
  for (std::size_t i = 0; i < one.meshes.size(); ++i) {
    ASSERT_EQ(one.meshes[i].indices, four.meshes[i].indices);
    for (std::size_t k = 0; k < one.meshes[i].vertices.size(); ++k) {
      ASSERT_EQ(one.meshes[i].vertices[k].position, four.meshes[i].vertices[k].position);
      ASSERT_EQ(one.meshes[i].vertices[k].uv, four.meshes[i].vertices[k].uv);
    }
  }
  ASSERT_EQ(one.textures.size(), four.textures.size());
  for (std::size_t i = 0; i < one.textures.size(); ++i) {
    EXPECT_EQ(cv::norm(one.textures[i], four.textures[i]), 0.0);
  }
}

// Inserting an object does not change the look of the others.
TEST(BuildWorld, LooksDoNotDependOnOtherObjects) {
  Json json = EmptyScene();
  json["objects"].push_back(Ball("ball_1", R"({"still": {"at": [0, 0]}})"));
  const World alone = BuildWorld(SceneDescription::Parse(json, "here"), 1);
  json["objects"].insert(json["objects"].begin(), Ball("ball_0", R"({"still": {"at": [1, 1]}})"));
  const World both = BuildWorld(SceneDescription::Parse(json, "here"), 1);
  EXPECT_EQ(cv::norm(alone.textures.back(), both.textures.back()), 0.0);
  EXPECT_GT(cv::norm(both.textures[both.textures.size() - 2], both.textures.back()), 0.0);
}

TEST(BuildWorld, NamesTheObjectThatCannotBeMade) {
  Json json = EmptyScene();
  json["objects"].push_back(Ball("ball_1", R"({"still": {"at": [0, 0]}})"));
  json["objects"][0]["model"] = "bal";
  EXPECT_THAT(MessageFor(json), HasSubstr("here, objects.0, "));
}

TEST(BuildWorld, ChecksBodiesWallsAndCamera) {
  Json json = EmptyScene();
  json["objects"].push_back(Ball("ball_1", R"({"still": {"at": [0, 0.5]}})"));
  json["objects"].push_back(Ball("ball_2", R"({"route": {"points": [[2, 0.5], [-2, 0.5]],
                                                         "speed_mps": 3}})"));
  EXPECT_THAT(MessageFor(json), HasSubstr("here: found ball_1 and ball_2 overlap by "));
  json["objects"].erase(1);
  EXPECT_EQ(MessageFor(json), "");
  json["objects"][0]["path"]["still"]["at"] = {3.9, 0};
  EXPECT_THAT(MessageFor(json), HasSubstr("ball_1 and a wall overlap"));
  json["objects"][0]["path"]["still"]["at"] = {-2.7, 0, 1.2};
  EXPECT_THAT(MessageFor(json), HasSubstr("the camera and ball_1 overlap"));
  json["objects"][0]["path"]["still"]["at"] = {-3.7, 0};
  EXPECT_THAT(MessageFor(json), HasSubstr("ball_1 never in front of the camera"));
}

// The ball moves around the room along its walls.
TEST(BuildWorld, BodiesMustNotEnterFurniture) {
  Json json = EmptyScene();
  json["room"]["shelves"] = 4;
  json["objects"].push_back(Ball("ball_1", R"({"route": {
      "points": [[3.6, 0], [3.6, 3.6], [-3.6, 3.6], [-3.6, -3.6], [3.6, -3.6]],
      "corner_m": 0.5, "closed": true, "speed_mps": 30}})"));
  EXPECT_THAT(MessageFor(json), HasSubstr("here: found ball_1 and furniture at ("));
}

TEST(BuildWorld, NamesTheSceneWithTooMuchFurniture) {
  Json json = EmptyScene();
  json["room"]["shelves"] = 200;
  EXPECT_THAT(MessageFor(json), HasSubstr("here, room: "));
}

}  // namespace
}  // namespace cvo::synth::world_test
