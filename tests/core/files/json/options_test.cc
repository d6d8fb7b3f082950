// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/files/json/options_json.h"
#include "core/files/text/closest_names.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::options_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct WindowSettings {
  int spatial = 5;
  double huber = 2.5;
  bool robust = true;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("spatial", self.spatial, {"frames", 1, 100, "frames kept", "paper"});
    visit.Field("huber", self.huber, {"1", 0.1, 10.0, "where it turns linear", "paper"});
    visit.Field("robust", self.robust, {"1", 0, 1, "", ""});
  }
};

struct Settings {
  double gain = 1.0;
  WindowSettings window;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("gain", self.gain, {"1", -1e9, 1e9, "", ""});
    visit.Group("window", self.window);
  }
};

std::string SetProblem(const std::string& assignment) {
  Settings settings;
  return ErrorMessage([&] { SetOption(assignment, OptionLeaves(settings)); });
}

std::string MergeProblem(const std::string& json) {
  Settings settings;
  return ErrorMessage(
      [&] { MergeOptions(ParseJson(json, "c.json"), "c.json", OptionLeaves(settings)); });
}

TEST(SetOption, ParsesEachType) {
  Settings settings;
  const auto leaves = OptionLeaves(settings);
  SetOption("window.spatial=7", leaves);
  SetOption("window.huber=1e-1", leaves);
  SetOption("window.robust=false", leaves);
  SetOption("gain=-3", leaves);
  EXPECT_EQ(settings.window.spatial, 7);
  EXPECT_EQ(settings.window.huber, 0.1);
  EXPECT_FALSE(settings.window.robust);
  EXPECT_EQ(settings.gain, -3.0);
}

TEST(SetOption, RefusesPartiallyParsedValues) {
  for (const char* assignment :
       {"window.spatial=5x", "window.spatial=5.0", "window.spatial=", "window.spatial= 5",
        "window.spatial=99999999999", "window.huber=nan", "window.huber=inf", "window.huber=1,5",
        "window.robust=1", "window.robust=True"}) {
    EXPECT_THAT(SetProblem(assignment), AllOf(HasSubstr(assignment), HasSubstr("expected")))
        << assignment;
  }
  EXPECT_THAT(SetProblem("window.spatial"), HasSubstr("no '='"));
}

TEST(SetOption, ChecksTheRange) {
  EXPECT_THAT(SetProblem("window.spatial=0"),
              AllOf(HasSubstr("window.spatial"), HasSubstr("found 0"), HasSubstr("[1, 100]")));
}

TEST(SetOption, SuggestsNamesForAMisspeltPath) {
  EXPECT_THAT(SetProblem("window.spatail=5"), HasSubstr("did you mean window.spatial"));
  EXPECT_THAT(SetProblem("spatial=5"), HasSubstr("did you mean window.spatial"));
  EXPECT_THAT(SetProblem("quite.another=5"),
              AllOf(HasSubstr("unknown option quite.another"), Not(HasSubstr("did you mean"))));
  EXPECT_THAT(SetProblem("window=5"), HasSubstr("unknown option window"));
}

TEST(MergeOptions, OverridesPresentValues) {
  Settings settings;
  MergeOptions(ParseJson(R"({"window": {"huber": 3, "robust": false}})", "c.json"), "c.json",
               OptionLeaves(settings));
  EXPECT_EQ(settings.window.huber, 3.0);
  EXPECT_FALSE(settings.window.robust);
  EXPECT_EQ(settings.window.spatial, 5);
}

TEST(MergeOptions, NamesThePathOfAnUnknownKey) {
  EXPECT_THAT(MergeProblem(R"({"window": {"spatail": 5}})"),
              AllOf(HasSubstr("c.json"), HasSubstr("unknown option window.spatail"),
                    HasSubstr("did you mean window.spatial")));
  EXPECT_THAT(MergeProblem(R"({"windows": {"spatial": 5}})"), HasSubstr("unknown option windows"));
  EXPECT_THAT(MergeProblem(R"({"window.spatial": 5})"), HasSubstr("nested objects"));
  EXPECT_THAT(MergeProblem(R"([1])"), HasSubstr("expected an object"));
}

TEST(MergeOptions, NamesPathFoundAndExpectedOfAWrongType) {
  EXPECT_EQ(MergeProblem(R"({"window": {"spatial": 5.5}})"),
            "c.json, option window.spatial: found 5.5, expected an integer");
  EXPECT_EQ(MergeProblem(R"({"window": {"spatial": "5"}})"),
            "c.json, option window.spatial: found \"5\", expected an integer");
  EXPECT_EQ(MergeProblem(R"({"window": {"robust": 1}})"),
            "c.json, option window.robust: found 1, expected true or false");
  EXPECT_EQ(MergeProblem(R"({"gain": null})"),
            "c.json, option gain: found null, expected a finite number");
  EXPECT_EQ(MergeProblem(R"({"window": 5})"),
            "c.json, option window: found 5, expected an object of options");
  EXPECT_THAT(MergeProblem(R"({"window": {"spatial": 4294967301}})"),
              HasSubstr("expected an integer"));
  EXPECT_THAT(MergeProblem(R"({"window": {"spatial": 18446744073709551615}})"),
              HasSubstr("expected an integer"));
  EXPECT_THAT(MergeProblem(R"({"window": {"spatial": 101}})"), HasSubstr("[1, 100]"));
}

TEST(OptionsToJson, NestsAndReadsBack) {
  Settings settings;
  settings.gain = 0.1;
  settings.window.spatial = 9;
  const Json json = OptionsToJson(OptionLeaves(settings));
  EXPECT_EQ(json.dump(), R"({"gain":0.1,"window":{"spatial":9,"huber":2.5,"robust":true}})");
  Settings back;
  MergeOptions(json, "result", OptionLeaves(back));
  EXPECT_EQ(OptionsToJson(OptionLeaves(back)), json);
}

TEST(ResolveOptions, AssignmentsOverrideTheFile) {
  const test::TempFolder folder;
  const auto file = folder.Write("c.json", R"({"window": {"spatial": 6, "huber": 1.5}})");
  const auto settings = ResolveOptions<Settings>(file, {"window.spatial=7", "window.spatial=8"});
  EXPECT_EQ(settings.window.spatial, 8);
  EXPECT_EQ(settings.window.huber, 1.5);
  EXPECT_EQ(ResolveOptions<Settings>("", {}).window.spatial, 5);
}

TEST(ClosestNames, ReturnsAtMostThreeNearestFirst) {
  const std::vector<std::string> known = {"abcd1", "abcd2", "abcd3", "abcd", "zzzz"};
  EXPECT_THAT(ClosestNames("abcd", known), ElementsAre("abcd", "abcd1", "abcd2"));
  EXPECT_THAT(ClosestNames("qqqq", known), IsEmpty());
  EXPECT_EQ(DidYouMean("qqqq", known), "");
}

// The comparison with distant names stops early; names just within the limit must still be found.
TEST(ClosestNames, AllowsAQuarterOfTheLengthPlusOneEdits) {
  const std::string name = "abcdefghijkl";  // 4 edits
  for (const char* near : {"abcdefgh", "abcdefghijkl1234", "1234efghijkl", "abcdefgh1234",
                           "badcfehgijkl", "x.abcdefghi23", "long_group.abcdefghi23"}) {
    EXPECT_THAT(ClosestNames(name, {near}), ElementsAre(near));
  }
  for (const char* far : {"abcdefg", "abcdefghijkl12345", "12345fghijkl", "abcdefg12345",
                          "badcfehgjikl", "x.1bcdefghi23", "long_group.1bcdefghi23"}) {
    EXPECT_THAT(ClosestNames(name, {far}), IsEmpty()) << far;
  }
}

// Regression test: for a missing sequence, the names of other sequences were suggested.
TEST(ClosestNames, DifferentNumbersAreNotMisspellings) {
  const std::vector<std::string> known = {"drive_0001_sync", "drive_0013_sync", "drive_001_syn"};
  EXPECT_THAT(ClosestNames("drive_0047_sync", known), ElementsAre("drive_001_syn"));
  EXPECT_THAT(ClosestNames("drive_013_sync", known),
              ElementsAre("drive_0013_sync", "drive_001_syn"));
  EXPECT_THAT(ClosestNames("08", {"07", "06"}), IsEmpty());
  EXPECT_THAT(ClosestNames("7", {"07"}), ElementsAre("07"));
}

}  // namespace
}  // namespace cvo::options_test
