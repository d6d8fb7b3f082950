// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/family/generate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "core/files/sha256.h"
#include "tests/support/error_message.h"

namespace cvo::synth {
namespace {

using testing::HasSubstr;

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
  for (const std::uint32_t seed : {0u, 1u, 2u}) {
    const Json scene = GenerateScene(family, seed, {});
    EXPECT_EQ(ErrorMessage([&] { BuildWorld(SceneDescription::Parse(scene, "s"), 2); }), "")
        << GetParam() << " " << seed;
  }
}

TEST_P(Families, AreReproduciblePerSeed) {
  const Family family = LoadFamily(GetParam());
  const std::string once = DumpJson(GenerateScene(family, 5, {}));
  EXPECT_EQ(DumpJson(GenerateScene(family, 5, {})), once);
  EXPECT_NE(DumpJson(GenerateScene(family, 6, {})), once);
}

TEST_P(Families, HaveADescription) {
  const Family family = LoadFamily(GetParam());
  EXPECT_EQ(family.name, GetParam());
  EXPECT_FALSE(family.about.empty());
  for (const Knob& knob : family.knobs) EXPECT_FALSE(knob.about.empty()) << knob.name;
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
