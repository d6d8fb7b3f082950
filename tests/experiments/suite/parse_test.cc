// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "experiments/suite/suite.h"
#include "tests/experiments/suite/examples.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"
#include "variants/registry.h"

namespace cvo {
namespace {

using test::Parse;
using test::SmallSuite;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

// The small suite with the value at a JSON pointer replaced.
Json With(const std::string& pointer, const Json& value) {
  Json json = SmallSuite();
  json[Json::json_pointer(pointer)] = value;
  return json;
}

std::string MessageOf(const Json& json) {
  return ErrorMessage([&] { Parse(json); });
}

TEST(Suite, ReadsAFile) {
  Json json = SmallSuite();
  json["sequences"].push_back({{"folder", "2011_09_26_drive_0013_sync"},
                               {"detections", "d.txt"},
                               {"detections_camera", 2},
                               {"min_score", 0.5},
                               {"classes", {"Car"}}});
  json["options"] = {{"window", {{"spatial", 4}}}};
  json["oracles"] = Json::array({Json::array(), {"boxes", "labels"}});
  json["table"]["rows"] = {"variant", "oracle"};
  const Suite suite = Parse(json);
  EXPECT_EQ(suite.sequences[0].name, "tiny");
  EXPECT_EQ(suite.sequences[1].name, "2011_09_26_drive_0013");
  EXPECT_EQ(suite.sequences[1].detections_camera, 2);
  EXPECT_EQ(suite.sequences[1].min_score, 0.5);
  EXPECT_THAT(suite.sequences[1].classes, ElementsAre("Car"));
  EXPECT_EQ(suite.options["window"]["spatial"], 4);
  EXPECT_THAT(suite.oracles, ElementsAre(ElementsAre(), ElementsAre("boxes", "labels")));
}

TEST(Suite, HasDefaultsForSeedsAndTable) {
  Json json = With("/variants", {"full", "static"});
  json["grid"] = {{"unary.eta", {0.5, 0.9}}};
  json.erase("seeds");
  json.erase("table");
  const Suite suite = Parse(json);
  EXPECT_THAT(suite.seeds, ElementsAre(1));
  EXPECT_THAT(suite.table.rows, ElementsAre("variant", "unary.eta"));
  EXPECT_EQ(suite.table.metrics.size(), 6U);
  EXPECT_EQ(suite.table.reference, "full");
}

TEST(Suite, SeedsAreANumberOrAList) {
  EXPECT_THAT(Parse(With("/seeds", 3)).seeds, ElementsAre(1, 2, 3));
  EXPECT_THAT(Parse(With("/seeds", {7, 0})).seeds, ElementsAre(7, 0));
  EXPECT_THAT(MessageOf(With("/seeds", 0)), HasSubstr("s.json, seeds"));
  EXPECT_THAT(MessageOf(With("/seeds", Json::array())), HasSubstr("s.json, seeds"));
  EXPECT_THAT(MessageOf(With("/seeds", {1, 1})), HasSubstr("s.json, seeds"));
  EXPECT_THAT(MessageOf(With("/seeds", {-1})), HasSubstr("s.json, seeds"));
}

Json RoomsEntry(const std::string& seeds) {
  return {{"family", "room"}, {"seeds", seeds}, {"detections", "good"}, {"set", {{"movers", 2}}}};
}

TEST(Suite, AFamilyIsASequenceForEachSeed) {
  const Suite suite = Parse(With("/sequences", Json::array({RoomsEntry("10:12")})));
  ASSERT_EQ(suite.sequences.size(), 2u);
  EXPECT_EQ(suite.sequences[0].name, "room_10");
  EXPECT_EQ(suite.sequences[1].scene, "room@11,movers=2");
  EXPECT_EQ(suite.sequences[1].detections, "good");
  EXPECT_EQ(SplitOf(suite), "development");
  EXPECT_EQ(Parse(suite.definition).sequences[1].scene, "room@11,movers=2");
}

TEST(Suite, SplitsNeverShareARow) {
  EXPECT_THAT(
      MessageOf(With("/sequences", Json::array({RoomsEntry("999:1001")}))),
      HasSubstr("sequences.1: found the test split (room_1000) beside the development split"));
  EXPECT_THAT(MessageOf(With("/sequences", Json::array({{{"scene", "tiny"}}, RoomsEntry("1000")}))),
              HasSubstr("found the test split"));
  Json json = With("/sequences", Json::array({{{"scene", "tiny"}}, RoomsEntry("1000")}));
  for (const char* key : {"sequence", "family"}) {  // either tells the splits apart
    json["table"]["rows"] = {key, "variant"};
    EXPECT_EQ(SplitOf(Parse(json)), "mixed");
  }
  EXPECT_EQ(FamilyOf(Parse(json).sequences[0]), "");
  EXPECT_EQ(FamilyOf(Parse(json).sequences[1]), "room");
}

TEST(Suite, NamesTheFaultOfAFamilyEntry) {
  for (const char* seeds : {"12:10", "-1:3", "0:4294967297", "a", ""}) {
    EXPECT_THAT(MessageOf(With("/sequences", Json::array({RoomsEntry(seeds)}))),
                HasSubstr("sequences.0.seeds"))
        << seeds;
  }
  Json entry = RoomsEntry("3");
  entry["set"] = {{"mover", 2}};
  EXPECT_THAT(MessageOf(With("/sequences", Json::array({entry}))), HasSubstr("no knob \"mover\""));
  entry = RoomsEntry("3");
  entry["family"] = "rooms";
  EXPECT_THAT(MessageOf(With("/sequences", Json::array({entry}))), HasSubstr("did you mean room?"));
}

TEST(Suite, AKnobIsAnAxisOfAGrid) {
  Json json = With("/sequences", Json::array({RoomsEntry("3")}));
  json["grid"] = {{"scene.knob.rate_hz", {10, 20}}};
  json["table"]["rows"] = {"variant", "scene.knob.rate_hz"};
  EXPECT_EQ(MessageOf(json), "");
  json["grid"] = {{"scene.knob.rate", {10, 20}}};
  json["table"]["rows"] = {"variant", "scene.knob.rate"};
  EXPECT_THAT(MessageOf(json), HasSubstr("no knob \"rate\""));
}

Perturbation PerturbationOfJob(const Suite& suite, const PlanJob& job) {
  return PerturbationOf(suite.sequences.at(job.entry), job.parameters, job.seed);
}

TEST(Suite, PerturbationsAreKeysOfASequenceAndAxesOfAGrid) {
  Json json = With("/sequences/0/perturb", {{"noise", 3}});
  json["grid"] = {{"perturb.blur_px", {0, 2}}};
  json["table"]["rows"] = {"variant", "perturb.blur_px"};
  const Suite suite = Parse(json);
  const std::vector<PlanJob> jobs = ExpandSuite(suite);
  EXPECT_EQ(PerturbationOfJob(suite, jobs.front()).noise, 3.0);
  EXPECT_EQ(PerturbationOfJob(suite, jobs.back()).blur_px, 2.0);
  EXPECT_EQ(PerturbationOfJob(suite, jobs.back()).seed, jobs.back().seed);
  json["grid_one_at_a_time"] = true;
  EXPECT_EQ(PerturbationOfJob(suite, ExpandSuite(Parse(json)).front()).blur_px, 0.0);
}

// A wrong value at a JSON pointer, and the key that the message must name.
struct Wrong {
  std::string pointer;
  Json value;
  std::string key;
};

TEST(Suite, AWrongValueIsNamedWithFileAndKey) {
  const std::vector<Wrong> cases = {
      {"/sede", 1, "sede"},
      {"/name", 5, "name"},
      {"/name", "a/b", "name"},
      {"/sequences/0/scene", "tinny", "did you mean tiny"},
      {"/sequences/0/scne", "tiny", "sequences.0.scne"},
      {"/sequences/0/folder", "f", "sequences.0"},
      {"/sequences/0/detections", "godo", "did you mean good"},
      {"/sequences/0/frames", "3:99", "sequences.0"},
      {"/sequences/0/classes", {"Carr"}, "sequences.0.classes.0"},
      {"/sequences/0/perturb", {{"blurr_px", 1}}, "blurr_px"},
      {"/sequences/0/perturb", {{"drop_rate", 2}}, "drop_rate"},
      {"/sequences/0/perturb", 3, "sequences.0.perturb"},
      {"/grid", {{"perturb.gama", {1}}}, "gama"},
      {"/grid", {{"perturb.gamma", {99}}}, "gamma"},
      {"/sequences", Json::array(), "sequences"},
      {"/variants", {"ful"}, "variants.0"},
      {"/variants", {"full", "full"}, "variants.1"},
      {"/variants", Json::array(), "variants"},
      {"/options", {{"window", {{"spatail", 4}}}}, "window.spatail"},
      {"/options", {{"window", {{"spatial", 4.5}}}}, "window.spatial"},
      {"/grid", {{"window.spatail", {4}}}, "window.spatail"},
      {"/grid", {{"window.spatial", {4, 1000}}}, "window.spatial"},
      {"/grid", {{"window.spatial", {4, "x"}}}, "window.spatial"},
      {"/grid", {{"window.spatial", {4, 4}}}, "grid.window.spatial"},
      {"/grid", {{"window.spatial", Json::array()}}, "grid.window.spatial"},
      {"/grid", {{"scene.detector.miss_rat", {0.1}}}, "grid"},
      {"/grid", {{"scene.detector.miss_rate", {2}}}, "grid"},
      {"/grid_one_at_a_time", 1, "grid_one_at_a_time"},
      {"/sequences/0/detections", {{"model", "m.onnx"}}, "sequences.0.detections"},
      {"/grid", {{"window.spatial", {4, 5}}}, "table.rows: found no \"window.spatial\""},
      {"/oracles", {Json::array(), {"boxes"}}, "table.rows: found no \"oracle\""},
      {"/sequences/0",
       {{"folder", "07"}, {"pair", "gray"}},
       "found \"gray\" (did you mean grey?), expected grey or"},
      {"/sequences/1", {{"scene", "tiny"}, {"detections", "good"}}, "sequences.1"},
      {"/oracles", {{"boxs"}}, "oracles.0.0"},
      {"/oracles", Json::array(), "oracles"},
      {"/systems", {{{"name", "full"}}}, "systems.0"},
      {"/systems", {{{"name", "orb"}}}, "no \"command\" or \"writes\""},
      {"/systems", {{{"name", "orb"}, {"command", {"orb"}}}}, "systems.0.writes"},
      {"/systems",
       {{{"name", "orb"}, {"calibration", "kiti"}, {"writes", {{"camera", "c"}}}}},
       "(did you mean kitti?)"},
      {"/systems",
       {{{"name", "orb"}, {"command", {"orb", 3}}, {"writes", {{"camera", "c"}}}}},
       "systems.0.command: found [\"orb\",3]"},
      {"/systems",
       {{{"name", "orb"}, {"command", {"orb", "{lfet}"}}, {"writes", {{"camera", "c"}}}}},
       "systems.0: found {lfet} (did you mean left?)"},
      {"/systems",
       {{{"name", "orb"}, {"command", {"orb", "{images}"}}, {"writes", {{"camera", "c"}}}}},
       "found {images}, expected one of: left, "},
      {"/systems", {{{"name", "orb"}, {"writes", {{"camera", "{sequense}.tum"}}}}}, "{sequense}"},
      {"/table/metrics", {"camera_aet"}, "(did you mean camera_ate?)"},
      {"/table/metrics", Json::array(), "table.metrics"},
      {"/table/rows", {"varaint"}, "table.rows.0"},
      {"/table/reference", "static", "table.reference"},
      {"/table/reference", "detections=good", "table.reference"}};
  for (const Wrong& wrong : cases) {
    EXPECT_THAT(MessageOf(With(wrong.pointer, wrong.value)),
                AllOf(StartsWith("s.json"), HasSubstr(wrong.key)))
        << wrong.pointer;
  }
}

TEST(Suite, TooManyRunsAreRefused) {
  EXPECT_THAT(MessageOf(With("/seeds", std::vector<int>(10'001, 1))),
              HasSubstr("s.json, seeds: found 10001, expected at most 10000"));
  Json json = SmallSuite();
  std::vector<int> values(1001);
  std::iota(values.begin(), values.end(), 100);
  json["grid"]["orb.features"] = values;
  EXPECT_THAT(MessageOf(json), HasSubstr("grid.orb.features: found 1001 values"));
  for (const char* path : {"orb.features", "orb.reserve", "window.spatial"}) {
    json["grid"][path] = {{"from", 1}, {"to", 1000}, {"steps", 1000}};
  }
  EXPECT_THAT(MessageOf(json), HasSubstr("s.json: found 1000000000 runs, expected at most 100000"));
}

TEST(Suite, FindsSceneFilesBesideTheSuite) {
  const test::TempFolder folder;
  folder.Write("scenes/mine.json", "");  // never read here
  Json json = SmallSuite();
  json["sequences"][0]["scene"] = "scenes/mine.json";
  const Suite suite = ReadCheckedSuite(json, "s.json", folder.path());
  EXPECT_EQ(suite.sequences[0].scene, (folder.path() / "scenes" / "mine.json").string());
  EXPECT_EQ(suite.sequences[0].name, "mine");
  EXPECT_EQ(ReadCheckedSuite(suite.definition, "s").sequences[0].scene, suite.sequences[0].scene);
}

TEST(ShippedSuites, IncludeEveryVariant) {
  std::vector<std::string> ladder = LoadSuite("ladder").variants;
  EXPECT_EQ(ladder.front(), "paper");
  EXPECT_EQ(ladder.back(), "full");
  EXPECT_EQ(ladder.size(), LoadSuite("leave_one_out").variants.size());
  std::set<std::string> names;
  for (const char* suite :
       {"ablation_all", "corrections", "backends", "ladder", "leave_one_out", "peers"}) {
    const std::vector<std::string> variants = LoadSuite(suite).variants;
    names.insert(variants.begin(), variants.end());
  }
  for (const VariantInfo& variant : Variants()) {
    EXPECT_THAT(names, testing::Contains(std::string(variant.name)));
  }
}

TEST(ShippedSuites, AreCompleteAndNamedAfterTheirFiles) {
  std::vector<std::string> names;
  for (const ShippedSuite& shipped : ShippedSuites()) {
    const Suite suite = LoadSuite(shipped.name);
    EXPECT_EQ(suite.name, shipped.name);
    EXPECT_FALSE(suite.about.empty()) << shipped.name;
    names.push_back(shipped.name);
  }
  EXPECT_THAT(names, testing::IsSupersetOf({"ci", "ablation", "sweep_alpha", "sweep_eta",
                                            "sweep_windows", "kitti_raw", "oracle_ladder"}));
  EXPECT_THAT(ErrorMessage([] { LoadSuite("ablatoin"); }), HasSubstr("did you mean ablation"));
}

// Options are never chosen on the scenes that results are reported on.
TEST(ShippedSuites, ReportOnTheTestSplitAndGateOnDevelopmentScenes) {
  for (const ShippedSuite& shipped : ShippedSuites()) {
    const std::string split = SplitOf(ReadCheckedSuite(ParseJson(shipped.text, "s"), "s"));
    const bool reports = shipped.name == "ablation" || shipped.name == "ablation_large" ||
                         shipped.name == "ablation_street" || shipped.name == "ladder" ||
                         shipped.name == "leave_one_out" || shipped.name == "self_calibration" ||
                         shipped.name == "families" || shipped.name == "peers" ||
                         shipped.name.starts_with("world_") || shipped.name.starts_with("camera_");
    const bool recorded = shipped.name.find("kitti") != std::string::npos ||
                          shipped.name == "multimotion" || shipped.name == "clusterslam" ||
                          shipped.name == "detector_real" || shipped.name == "pareto";
    // timing reports no errors; corrections_street shows equations on scenes and on a drive.
    if (shipped.name == "timing" || shipped.name == "corrections_street") continue;
    EXPECT_EQ(split, recorded ? "given" : reports ? "test" : "development") << shipped.name;
  }
}

TEST(SuiteOverrides, ChangeSeedsOptionsAndAxes) {
  Json json = With("/grid", {{"unary.eta", {0.5, 0.9}}});
  json["table"]["rows"] = {"unary.eta"};
  const Suite suite = Override(
      Parse(json),
      {.seeds = 2, .set = {"window.spatial=4", "unary.eta=0.7", "scene.sensor.read_noise=0"}});
  EXPECT_THAT(suite.seeds, ElementsAre(1, 2));
  EXPECT_EQ(suite.options["window"]["spatial"], 4);
  ASSERT_EQ(suite.grid.size(), 2U);
  EXPECT_THAT(suite.grid[0].values, ElementsAre(Json(0.7)));
  EXPECT_EQ(suite.grid[1].path, "scene.sensor.read_noise");
  for (const char* wrong : {"window.spatail=4", "window.spatial=x", "window.spatial",
                            "scene.sensor.red_noise=0", "unary.eta=7"}) {
    EXPECT_NE(ErrorMessage([&] { Override(Parse(json), {.set = {wrong}}); }), "") << wrong;
  }
}

}  // namespace
}  // namespace cvo
