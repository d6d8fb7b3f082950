// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/family/family.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "core/files/sha256.h"
#include "tests/support/error_message.h"
#include "tests/synth/worlds.h"

namespace cvo::synth {
namespace {

using testing::HasSubstr;

std::vector<Knob> Knobs() {
  return {{"count", "", "", Json::parse(R"({"integer": [1, 3]})"), {1, 9}, false},
          {"speed", "", "", Json::parse(R"({"uniform": [0.1, 0.9]})"), {0.0, 2.5}, true},
          {"path", "", "", Json::parse(R"({"choose": ["a", "b"]})"), {"a", "b"}, false}};
}

Json Take(const std::string& value, const std::string& stream,
          const std::vector<std::string>& set = {}) {
  const std::vector<Knob> knobs = Knobs();
  return Draws("f", 7, knobs, set).Take(Json::parse(value), stream);
}

std::string CheckMessage(const std::string& value) {
  return ErrorMessage([&] { CheckDraws(Json::parse(value), "here", Knobs()); });
}

std::string SetMessage(const std::string& assignment) {
  const std::vector<Knob> knobs = Knobs();
  return ErrorMessage([&] { Draws("f", 7, knobs, {assignment}); });
}

TEST(Draws, StayWithinTheirRanges) {
  for (int i = 0; i < 200; ++i) {
    const Json taken = Take(
        R"({"a": {"uniform": [2, 3]}, "b": [{"integer": [-1, 1]}], "c": {"choose": ["x", 4]}})",
        std::to_string(i));
    EXPECT_GE(taken["a"].get<double>(), 2.0);
    EXPECT_LE(taken["a"].get<double>(), 3.0);
    EXPECT_LE(std::abs(taken["b"][0].get<int>()), 1);
    EXPECT_TRUE(taken["c"] == "x" || taken["c"] == 4);
  }
}

TEST(Draws, DrawSceneKnobsOnceAndBodyKnobsEachTime) {
  const Json scene = Take(R"([{"knob": "count"}, {"knob": "count"}])", "s");
  EXPECT_EQ(scene[0], scene[1]);
  const Json body = Take(R"([{"knob": "speed"}, {"knob": "speed"}])", "s");
  EXPECT_NE(body[0], body[1]);
}

TEST(Draws, AFixedKnobDoesNotChangeOtherDraws) {
  const std::string value = R"([{"knob": "count"}, {"knob": "speed"}, {"uniform": [0, 1]}])";
  const Json free = Take(value, "s");
  const Json fixed = Take(value, "s", {"speed=2.5"});
  EXPECT_EQ(fixed[1], 2.5);
  EXPECT_EQ(fixed[0], free[0]);
  EXPECT_EQ(fixed[2], free[2]);
}

TEST(Draws, NameTheKeyOfInvalidValues) {
  EXPECT_EQ(CheckMessage(R"({"a": [1, {"uniform": [2, 1]}]})"),
            "here.a.1.uniform: found the empty range [2,1], expected a range from low to high");
  EXPECT_THAT(CheckMessage(R"({"integer": [0.5, 1]})"), HasSubstr("expected two integers"));
  EXPECT_THAT(CheckMessage(R"({"choose": []})"), HasSubstr("here.choose: found []"));
  EXPECT_THAT(CheckMessage(R"({"choose": [{"knob": "sped"}]})"),
              HasSubstr("here.choose.0.knob: found no knob \"sped\""));
  EXPECT_THAT(CheckMessage(R"({"knob": "sped"})"), HasSubstr("(did you mean speed?)"));
}

TEST(Draws, RefuseInvalidKnobValues) {
  EXPECT_THAT(SetMessage("count=0"),
              HasSubstr("--set count=0: found \"0\", expected a value in [1,9]"));
  EXPECT_THAT(SetMessage("count=2.5"), HasSubstr("expected a value in [1,9]"));
  EXPECT_THAT(SetMessage("path=c"), HasSubstr("expected one of [\"a\",\"b\"]"));
  EXPECT_THAT(SetMessage("sped=1"), HasSubstr("found no knob \"sped\""));
  EXPECT_THAT(SetMessage("speed"), HasSubstr("expected KNOB=VALUE"));
  EXPECT_EQ(SetMessage("path=b"), "");
}

Json ShippedJson(const std::string& name) {
  for (const ShippedFamily& shipped : ShippedFamilies()) {
    if (shipped.name == name) return ParseJson(shipped.text, name);
  }
  return {};
}

std::string MessageOf(const Json& family, const std::vector<std::string>& set = {}) {
  return ErrorMessage([&] { GenerateScene(ParseFamily(family, "f"), 3, set); });
}

int Movers(const Json& scene) {
  return static_cast<int>(
      std::count_if(scene["objects"].begin(), scene["objects"].end(),
                    [](const Json& object) { return !object["path"].contains("still"); }));
}

class Families : public testing::TestWithParam<std::string> {};

// The checks of the scene itself find no collision, and all bodies in view.
TEST_P(Families, ScenesPassAllChecks) {
  const Family family = LoadFamily(GetParam());
  EXPECT_EQ(family.name, GetParam());
  EXPECT_FALSE(family.about.empty());
  for (const Knob& knob : family.knobs) EXPECT_FALSE(knob.about.empty()) << knob.name;
  for (const std::uint32_t seed : {0u, 1u, 2u}) {
    const Json scene = GenerateScene(family, seed, {});
    EXPECT_EQ(ErrorMessage([&] { BuildWorld(SceneDescription::Parse(scene, "s"), 2); }), "")
        << GetParam() << " " << seed;
  }
}

std::vector<std::string> Names() {
  std::vector<std::string> names;
  for (const ShippedFamily& shipped : ShippedFamilies()) names.push_back(shipped.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Shipped, Families, testing::ValuesIn(Names()),
                         [](const auto& tested) { return tested.param; });

// The same on every machine. A change here changes every result on families, including those on the
// test split.
TEST(GenerateScene, MatchesGoldenHashes) {
  const auto hash = [](const std::string& family) {
    return Sha256Hex(DumpJson(GenerateScene(LoadFamily(family), 0, {}))).substr(0, 16);
  };
  EXPECT_EQ(hash("room"), "b5d27f077a24945d");
  EXPECT_EQ(hash("street"), "619ab368c3982517");
  EXPECT_EQ(hash("bench"), "e4b5a317594e1f65");
  EXPECT_EQ(hash("crowd"), "4190d7cd0cfe24e9");
  EXPECT_EQ(hash("quiet"), "9fe719748526ec5d");
}

TEST(GenerateScene, KnobsHaveTheirMeaning) {
  const Family room = LoadFamily("room");
  EXPECT_EQ(Movers(GenerateScene(room, 11, {"movers=3"})), 3);
  const Json scene = GenerateScene(room, 11, {"rate_hz=10", "duration_s=4", "focal_px=500"});
  EXPECT_EQ(scene["frames"], 40);
  EXPECT_EQ(scene["rig"]["focal_px"], 500);
  EXPECT_THAT(scene["about"].get<std::string>(), HasSubstr("seed 11 (development split)"));
}

TEST(GenerateScene, ReportsBodiesWithoutAPlace) {
  Json family = ShippedJson("room");
  family["layout"]["bodies"][0]["body"] =
      Json::parse(R"({"model": "crate", "size_m": 3.0, "motion": "still"})");
  EXPECT_THAT(MessageOf(family, {"movers=5"}),
              HasSubstr("f, seed 3: found no place for body 1 of 5 of f, layout.bodies.0 in"));
}

TEST(GenerateScene, NamesTheWrongKey) {
  Json family = ShippedJson("room");
  family["layout"]["camera"]["path"] = "above";
  EXPECT_THAT(MessageOf(family), HasSubstr("layout.camera.path: found \"above\""));
  family = ShippedJson("room");
  family["layout"]["bodies"][0]["body"] =
      Json::parse(R"({"model": "crate", "size_m": 0.3, "motion": "fly"})");
  EXPECT_THAT(MessageOf(family), HasSubstr("motion: found \"fly\""));
  family = ShippedJson("room");
  family["knobs"]["movers"]["draw"]["integer"] = {3, 1};
  EXPECT_THAT(MessageOf(family),
              HasSubstr("f, knobs.movers.draw.integer: found the empty range [3,1]"));
  family = ShippedJson("room");
  family["scene"]["rom"] = 1;
  EXPECT_THAT(MessageOf(family), HasSubstr("rom: found an unknown key"));
}

TEST(ParseFamilySeed, TakesThirtyTwoBits) {
  EXPECT_EQ(ParseFamilySeed("4294967295"), 4294967295u);
  EXPECT_THAT(ErrorMessage([] { ParseFamilySeed("4294967296"); }),
              HasSubstr("an integer from 0 to 4294967295"));
  EXPECT_NE(ErrorMessage([] { ParseFamilySeed("-1"); }), "");
  EXPECT_NE(ErrorMessage([] { ParseFamilySeed("1.5"); }), "");
}

TEST(SplitOf, SeparatesDevelopmentFromTest) {
  EXPECT_EQ(SplitOf(999), Split::kDevelopment);
  EXPECT_EQ(SplitOf(1000), Split::kTest);
  EXPECT_EQ(SplitOf(1999), Split::kTest);
  EXPECT_EQ(SplitOf(2000), Split::kNone);
}

TEST(LoadScene, LoadsAFamilyBySeedAndKnobs) {
  const SceneDescription scene =
      LoadScene("room@17,movers=2", {"knob.rate_hz=10", "sensor.read_noise=0.25"});
  EXPECT_EQ(scene.name(), "room_17");
  EXPECT_EQ(scene.json()["rate_hz"], 10);
  EXPECT_EQ(scene.sensor()["read_noise"], 0.25);
  EXPECT_EQ(Movers(scene.json()), 2);
  EXPECT_EQ(ParseFamilyScene("room@17,movers=2").Name(), "room@17,movers=2");
  EXPECT_THAT(ErrorMessage([] { LoadScene("rom@17", {}); }), HasSubstr("did you mean room?"));
}

}  // namespace
}  // namespace cvo::synth
