// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/scene/description.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "core/files/text_file.h"
#include "synth/scene/shipped_scenes.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"
#include "tests/synth/scene/examples.h"

namespace cvo::synth::description_test {
namespace {

using test::Ball;
using test::EmptyScene;
using testing::HasSubstr;
using testing::Not;

constexpr char kStill[] = R"({"still": {"at": [1, 0]}})";

Json OneBall() {
  Json scene = EmptyScene();
  scene["objects"].push_back(Ball("ball_1", kStill));
  return scene;
}

std::string MessageFor(const Json& scene) {
  return ErrorMessage([&] { SceneDescription::Parse(scene, "here"); });
}

// Returns the error message about the scene with one ball after a change.
std::string MessageAfter(const std::function<void(Json&)>& change) {
  Json scene = OneBall();
  change(scene);
  return MessageFor(scene);
}

TEST(SceneDescription, ReadsEveryField) {
  const SceneDescription scene = SceneDescription::Parse(OneBall(), "here");
  EXPECT_EQ(scene.name(), "empty");
  EXPECT_EQ(scene.seed(), 0u);
  const SceneParts& parts = scene.parts();
  EXPECT_EQ(parts.rig.cx, 319.5);
  EXPECT_EQ(parts.rig.fy, 450.0);
  EXPECT_EQ(std::get<RoomDescription>(parts.surroundings).size_m.x(), 8.0);
  ASSERT_EQ(parts.objects.size(), 1u);
  EXPECT_EQ(parts.objects[0].category, "Ball");
  EXPECT_EQ(parts.objects[0].model.size_m, Eigen::Vector3d::Constant(0.5));
}

TEST(SceneDescription, NamesUnknownKeysWithTheirPath) {
  EXPECT_EQ(MessageAfter([](Json& s) { s["objects"][0]["matrial"] = "wood"; }).substr(0, 46),
            "here, objects.0.matrial: found an unknown key,");
  EXPECT_THAT(MessageAfter([](Json& s) { s["objects"][0]["matrial"] = "wood"; }),
              HasSubstr("(did you mean material?)"));
  EXPECT_THAT(MessageAfter([](Json& s) { s["camera"]["look_along"]["roll_deg"] = 1; }),
              HasSubstr("here, camera.look_along.roll_deg: found an unknown key"));
  EXPECT_THAT(MessageAfter([](Json& s) { s["rate"] = 10; }), HasSubstr("here, rate: "));
  EXPECT_THAT(MessageAfter([](Json& s) { s["room"]["windows"] = 1; }),
              HasSubstr("room.windows: found an unknown key"));
  EXPECT_THAT(MessageAfter([](Json& s) { s["objects"][0]["file"] = "a.obj"; }),
              HasSubstr("objects.0.file: found an unknown key"));
}

TEST(SceneDescription, NamesMissingKeysAndLikelyMisspellings) {
  EXPECT_EQ(MessageAfter([](Json& s) { s.erase("frames"); }),
            "here, frames: found no such key, expected a value");
  EXPECT_THAT(MessageAfter([](Json& s) {
                s["camera"]["route"]["speed_mp"] = 1;
                s["camera"]["route"].erase("speed_mps");
              }),
              testing::AllOf(HasSubstr("camera.route.speed_mp: found an unknown key"),
                             HasSubstr("did you mean speed_mps?")));
  EXPECT_THAT(MessageAfter([](Json& s) {
                s["objects"][0]["path"] = {{"rout", {}}};
              }),
              HasSubstr("objects.0.path.rout: found an unknown key"));
}

TEST(SceneDescription, ChecksTypesAndRanges) {
  EXPECT_EQ(MessageAfter([](Json& s) { s["camera"]["route"]["speed_mps"] = -1; }),
            "here, camera.route.speed_mps: found -1, expected a value in [0, 50]");
  EXPECT_THAT(MessageAfter([](Json& s) {
                s["camera"]["route"]["speed_mps"] = Json::parse("[[0, 1], [1, 60]]");
              }),
              HasSubstr("camera.route.speed_mps.1.1: found 60, expected a value in [0, 50]"));
  EXPECT_THAT(MessageAfter([](Json& s) {
                s["camera"]["route"]["speed_mps"] = Json::parse("[[1, 1], [1, 2]]");
              }),
              HasSubstr("speed_mps.1.0: found 1, expected a time after 1"));
  EXPECT_THAT(MessageAfter([](Json& s) { s["camera"]["route"]["points"][1][0] = "x"; }),
              HasSubstr("camera.route.points.1.0: found \"x\", expected a number"));
  EXPECT_THAT(MessageAfter([](Json& s) {
                s["camera"]["route"]["points"][1] = {1, 2, 3};
              }),
              HasSubstr("points.1: found [1,2,3], expected a list of 2 numbers"));
  EXPECT_THAT(MessageAfter([](Json& s) { s["seed"] = -1; }), HasSubstr("here, seed: found -1"));
  EXPECT_THAT(MessageAfter([](Json& s) { s["name"] = "a/b"; }), HasSubstr("here, name: "));
  EXPECT_THAT(MessageFor(Json::array()), HasSubstr("here: found [], expected an object"));
}

TEST(SceneDescription, RefusesInvalidCameras) {
  EXPECT_THAT(MessageAfter([](Json& s) { s["rig"]["width_px"] = 0; }),
              HasSubstr("rig.width_px: found 0"));
  EXPECT_THAT(MessageAfter([](Json& s) { s["frames"] = 0; }), HasSubstr("here, frames: found 0"));
  EXPECT_THAT(MessageAfter([](Json& s) { s["rate_hz"] = 0; }), HasSubstr("rate_hz: found 0"));
  EXPECT_THAT(MessageAfter([](Json& s) { s["rig"]["error"]["shift_px"] = 200; }),
              HasSubstr("rig.error.shift_px: found 200"));
  EXPECT_THAT(MessageAfter([](Json& s) { s["rig"]["baseline_m"] = 0; }),
              HasSubstr("rig.baseline_m: found 0"));
}

TEST(SceneDescription, RequiresExactlyOneOfAChoice) {
  EXPECT_THAT(MessageAfter([](Json& s) {
                s["street"] = {{"roads", Json::array()}};
              }),
              HasSubstr("here: found room and street, expected exactly one of room, street"));
  EXPECT_THAT(MessageAfter([](Json& s) { s["camera"].erase("look_along"); }),
              HasSubstr("here, camera: found none of look_at, look_along"));
}

TEST(SceneDescription, NamesMustDiffer) {
  EXPECT_THAT(MessageAfter([](Json& s) { s["objects"].push_back(Ball("ball_1", kStill)); }),
              HasSubstr("here, objects.1.name: found ball_1 for the second time"));
}

TEST(SceneDescription, LimitsBodiesToSixteenBits) {
  EXPECT_THAT(MessageAfter([](Json& s) {
                s["objects"][0]["copies"] = {{"count", 65536}, {"spacing_m", 1}};
              }),
              HasSubstr("here, objects: found 65536 bodies, expected at most 65535"));
}

TEST(SceneDescription, CopiesAreSpacedApart) {
  Json json = OneBall();
  json["objects"][0]["copies"] = {{"count", 3}, {"spacing_m", 0.5}};
  const std::string route = R"({"route": {"points": [[0, 0], [9, 0]], "speed_mps": 1}})";
  json["objects"].push_back(Ball("car", route));
  json["objects"][1]["copies"] = {{"count", 2}, {"spacing_m", 3}};
  const SceneDescription scene = SceneDescription::Parse(json, "here");
  const std::vector<ObjectDescription>& objects = scene.parts().objects;
  ASSERT_EQ(objects.size(), 5u);
  EXPECT_EQ(objects[2].name, "ball_1_3");
  EXPECT_EQ(std::get<StillDescription>(objects[2].path).at, Eigen::Vector2d(2, 0));
  EXPECT_EQ(objects[4].name, "car_2");
  EXPECT_EQ(std::get<RouteDescription>(objects[4].path).start_m, 3.0);
}

TEST(SceneDescription, MissingMeshIsNamed) {
  EXPECT_THAT(MessageAfter([](Json& s) {
                s["objects"][0]["model"] = "mesh";
                s["objects"][0]["file"] = "nowhere/dragon.obj";
              }),
              HasSubstr("here, objects.0.file: found no file nowhere/dragon.obj"));
}

TEST(LoadScene, MeshPathsAreRelativeToTheSceneFile) {
  const test::TempFolder folder;
  Json json = OneBall();
  json["objects"][0]["model"] = "mesh";
  json["objects"][0]["file"] = "thing.obj";
  WriteFileBytes(folder.path() / "scene.json", DumpJson(json));
  WriteFileBytes(folder.path() / "thing.obj", "v 0 0 0\n");
  const std::string file = (folder.path() / "scene.json").string();
  const SceneDescription scene = SceneDescription::Load(file, {});
  EXPECT_EQ(scene.parts().objects[0].model.file, folder.path() / "thing.obj");
  const std::string key = RenderKeyText(scene);
  EXPECT_THAT(key, Not(HasSubstr("thing.obj")));
  WriteFileBytes(folder.path() / "thing.obj", "v 0 0 1\n");
  const std::string changed = RenderKeyText(scene);
  EXPECT_NE(key, changed);
  WriteFileBytes(folder.path() / "thing.mtl", "newmtl wood\n");
  EXPECT_NE(RenderKeyText(scene), changed);
}

TEST(LoadScene, ShippedScenesHaveTheirNames) {
  for (const ShippedScene& shipped : ShippedScenes()) {
    EXPECT_EQ(SceneDescription::Load(shipped.name, {}).name(), shipped.name);
    EXPECT_FALSE(SceneDescription::Load(shipped.name, {}).about().empty());
  }
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

}  // namespace
}  // namespace cvo::synth::description_test
