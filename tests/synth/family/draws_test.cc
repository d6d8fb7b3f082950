// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/family/draws.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_message.h"

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

TEST(Draws, AreFixedPerStream) {
  const std::string value = R"({"uniform": [0, 1]})";
  EXPECT_EQ(Take(value, "s"), Take(value, "s"));
  EXPECT_NE(Take(value, "s"), Take(value, "t"));
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

}  // namespace
}  // namespace cvo::synth
