// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <set>

#include "synth/scene/description.h"
#include "tests/support/error_message.h"
#include "tests/synth/worlds.h"

namespace cvo::synth {
namespace {

using testing::HasSubstr;

constexpr char kStill[] = R"({"still": {"at": [1, 0]}})";

Json OneBall() {
  Json scene = EmptyScene();
  scene["objects"].push_back(BallObject("ball_1", kStill));
  return scene;
}

std::string MessageFor(const Json& scene) {
  return ErrorMessage([&] { SceneDescription::Parse(scene, "here"); });
}

// A value put into the scene with one ball ("-": the key is erased), and what the error says.
struct Fault {
  const char* key;
  const char* value;
  const char* message;
};

std::string MessageAfter(const Fault& fault) {
  Json scene = OneBall();
  const Json::json_pointer key(fault.key);
  if (std::string(fault.value) == "-") {
    scene[key.parent_pointer()].erase(key.back());
  } else {
    scene[key] = Json::parse(fault.value);
  }
  return MessageFor(scene);
}

class Faults : public testing::TestWithParam<Fault> {};

TEST_P(Faults, AreNamedWithTheirKey) {
  EXPECT_THAT(MessageAfter(GetParam()), HasSubstr(GetParam().message)) << GetParam().key;
}

constexpr Fault kUnknownKeys[] = {
    {"/objects/0/matrial", R"("wood")", "here, objects.0.matrial: found an unknown key,"},
    {"/objects/0/matrial", R"("wood")", "(did you mean material?)"},
    {"/objects/0/file", R"("a.obj")", "objects.0.file: found an unknown key"},
    {"/objects/0/path", R"({"rout": {}})", "objects.0.path.rout: found an unknown key"},
    {"/camera/look_along/roll_deg", "1", "here, camera.look_along.roll_deg: found an unknown key"},
    {"/rate", "10", "here, rate: "},
    {"/room/windows", "1", "room.windows: found an unknown key"},
    {"/camera/route", R"({"points": [[0, 0], [1, 0]], "speed_mp": 1})",
     "camera.route.speed_mp: found an unknown key"},
    {"/frames", "-", "here, frames: found no such key, expected a value"}};
constexpr Fault kValues[] = {
    {"/camera/route/speed_mps", "-1",
     "here, camera.route.speed_mps: found -1, expected a value in [0, 50]"},
    {"/camera/route/speed_mps", "[[0, 1], [1, 60]]",
     "camera.route.speed_mps.1.1: found 60, expected a value in [0, 50]"},
    {"/camera/route/speed_mps", "[[1, 1], [1, 2]]",
     "speed_mps.1.0: found 1, expected a time after 1"},
    {"/camera/route/points/1/0", R"("x")",
     "camera.route.points.1.0: found \"x\", expected a number"},
    {"/camera/route/points/1", "[1, 2, 3]",
     "points.1: found [1,2,3], expected a list of 2 numbers"},
    {"/seed", "-1", "here, seed: found -1"},
    {"/name", R"("a/b")", "here, name: "},
    {"", "[]", "here: found [], expected an object"},
    {"/rig/width_px", "0", "rig.width_px: found 0"},
    {"/rig/baseline_m", "0", "rig.baseline_m: found 0"},
    {"/rig/error", R"({"shift_px": 200})", "rig.error.shift_px: found 200"},
    {"/frames", "0", "here, frames: found 0"},
    {"/rate_hz", "0", "rate_hz: found 0"},
    {"/room/crates", "-1", "room.crates: found -1"},
    {"/objects/0/size_m", "0", "objects.0.size_m: found 0"}};
constexpr Fault kContradictions[] = {
    {"/street", R"({"roads": []})",
     "here: found room and street, expected exactly one of room, street"},
    {"/camera/look_along", "-", "here, camera: found none of look_at, look_along"},
    {"/objects/1",
     R"({"name": "ball_1", "model": "ball", "size_m": 0.5, "path": {"still": {"at": [1, 0]}}})",
     "here, objects.1.name: found ball_1 for the second time"},
    {"/objects/0/copies", R"({"count": 1001, "spacing_m": 1})", "copies.count: found 1001"}};

INSTANTIATE_TEST_SUITE_P(UnknownKeys, Faults, testing::ValuesIn(kUnknownKeys));
INSTANTIATE_TEST_SUITE_P(Values, Faults, testing::ValuesIn(kValues));
INSTANTIATE_TEST_SUITE_P(Contradictions, Faults, testing::ValuesIn(kContradictions));

TEST(SceneDescription, CopiesAreSpacedApart) {
  Json json = OneBall();
  json["objects"][0]["copies"] = {{"count", 3}, {"spacing_m", 0.5}};
  const std::string route = R"({"route": {"points": [[0, 0], [9, 0]], "speed_mps": 1}})";
  json["objects"].push_back(BallObject("car", route));
  json["objects"][1]["copies"] = {{"count", 2}, {"spacing_m", 3}};
  const SceneDescription scene = SceneDescription::Parse(json, "here");
  const std::vector<ObjectDescription>& objects = scene.parts().objects;
  ASSERT_EQ(objects.size(), 5u);
  EXPECT_EQ(objects[2].name, "ball_1_3");
  EXPECT_EQ(std::get<StillDescription>(objects[2].path).at, Eigen::Vector2d(2, 0));
  EXPECT_EQ(objects[4].name, "car_2");
  EXPECT_EQ(std::get<RouteDescription>(objects[4].path).start_m, 3.0);
}

TEST(LoadScene, UnknownNamesAreReported) {
  const std::string message = ErrorMessage([] { SceneDescription::Load("tinny", {}); });
  EXPECT_THAT(message, HasSubstr("scene \"tinny\": found neither a shipped scene nor a file"));
  EXPECT_THAT(message, HasSubstr("static_room"));
  EXPECT_THAT(message, HasSubstr("(did you mean tiny?)"));
}

TEST(LoadScene, AssignmentsAreCheckedLikeTheFile) {
  const SceneDescription scene = SceneDescription::Load(
      "tiny", {"seed=18446744073709551615", "objects.0.size_m=[0.4, 0.4, 0.4]", "about=two words",
               "light.ambient=0.25", "sensor.motion_blur.exposure_s=0.01"});
  EXPECT_EQ(scene.seed(), 18446744073709551615u);
  EXPECT_EQ(scene.parts().objects[0].model.size_m.x(), 0.4);
  EXPECT_EQ(scene.about(), "two words");
  EXPECT_EQ(scene.parts().light.ambient, 0.25);
  EXPECT_EQ(scene.sensor()["motion_blur"]["exposure_s"], 0.01);
  EXPECT_EQ(scene.json()["seed"], 18446744073709551615u);
}

TEST(LoadScene, RefusesInvalidAssignments) {
  const auto message = [](const std::string& assignment) {
    return ErrorMessage([&] { SceneDescription::Load("tiny", {assignment}); });
  };
  EXPECT_THAT(message("seed"), HasSubstr("--set seed: found no PATH=VALUE"));
  EXPECT_THAT(message("objects.9.size_m=1"), HasSubstr("found '9', expected an index below 3"));
  EXPECT_THAT(message("seed.x=1"), HasSubstr("'x' within a value that has no parts"));
  EXPECT_THAT(message("light.ambiance=1"), HasSubstr("light.ambiance: found an unknown key"));
  EXPECT_THAT(message("frames=many"), HasSubstr("frames: found \"many\", expected an integer"));
}

TEST(RenderKey, DependsOnWhatIsDrawn) {
  const auto key = [](const std::vector<std::string>& assignments) {
    return RenderKeyText(SceneDescription::Load("tiny", assignments));
  };
  const std::string plain = key({});
  for (const char* other : {"seed=9", "about=x", "name=y", "sensor.read_noise=1",
                            "detector.level=poor", "rate_hz=30.0"}) {
    EXPECT_EQ(key({other}), plain) << other;
  }
  for (const char* drawn :
       {"look_seed=9", "frames=5", "objects.0.size_m=0.45", "sensor.motion_blur.exposure_s=0.01",
        "light.ambient=0.5", "objects.0.name=other"}) {
    EXPECT_NE(key({drawn}), plain) << drawn;
  }
}

std::string BuildMessage(const Json& scene) {
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
  json["objects"].push_back(BallObject("ball_1", R"({"still": {"at": [0, 0]}})"));
  const World alone = BuildWorld(SceneDescription::Parse(json, "here"), 1);
  json["objects"].insert(json["objects"].begin(),
                         BallObject("ball_0", R"({"still": {"at": [1, 1]}})"));
  const World both = BuildWorld(SceneDescription::Parse(json, "here"), 1);
  EXPECT_EQ(cv::norm(alone.textures.back(), both.textures.back()), 0.0);
  EXPECT_GT(cv::norm(both.textures[both.textures.size() - 2], both.textures.back()), 0.0);
}

TEST(BuildWorld, ChecksBodiesWallsAndCamera) {
  Json json = EmptyScene();
  json["objects"].push_back(BallObject("ball_1", R"({"still": {"at": [0, 0.5]}})"));
  json["objects"].push_back(BallObject("ball_2", R"({"route": {"points": [[2, 0.5], [-2, 0.5]],
                                                         "speed_mps": 3}})"));
  EXPECT_THAT(BuildMessage(json), HasSubstr("here: found ball_1 and ball_2 overlap by "));
  json["objects"].erase(1);
  EXPECT_EQ(BuildMessage(json), "");
  json["objects"][0]["path"]["still"]["at"] = {3.9, 0};
  EXPECT_THAT(BuildMessage(json), HasSubstr("ball_1 and a wall overlap"));
  json["objects"][0]["path"]["still"]["at"] = {-2.7, 0, 1.2};
  EXPECT_THAT(BuildMessage(json), HasSubstr("the camera and ball_1 overlap"));
  json["objects"][0]["path"]["still"]["at"] = {-3.7, 0};
  EXPECT_THAT(BuildMessage(json), HasSubstr("ball_1 never in front of the camera"));
}

// The ball moves around the room along its walls.
TEST(BuildWorld, BodiesMustNotEnterFurniture) {
  Json json = EmptyScene();
  json["room"]["shelves"] = 4;
  json["objects"].push_back(BallObject("ball_1", R"({"route": {
      "points": [[3.6, 0], [3.6, 3.6], [-3.6, 3.6], [-3.6, -3.6], [3.6, -3.6]],
      "corner_m": 0.5, "closed": true, "speed_mps": 30}})"));
  EXPECT_THAT(BuildMessage(json), HasSubstr("here: found ball_1 and furniture at ("));
}

}  // namespace
}  // namespace cvo::synth
