// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "core/files/json/json.h"
#include "experiments/metrics/trajectory.h"
#include "experiments/suite/job_status.h"
#include "experiments/suite/suite.h"
#include "synth/family/family.h"
#include "synth/scene/description.h"
#include "tests/experiments/suite/examples.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::expand_test {
namespace {

using test::Parse;
using test::SmallSuite;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::vector<Json> Values(const Json& json) { return ParseAxisValues(json, "axis"); }

TEST(Grid, RangesAreLinearOrLogarithmic) {
  EXPECT_THAT(Values({{"from", 1}, {"to", 7}, {"steps", 4}}), ElementsAre(1, 3, 5, 7));
  EXPECT_TRUE(Values({{"from", 1}, {"to", 7}, {"steps", 4}})[1].is_number_integer());
  EXPECT_THAT(Values({{"from", 0.0}, {"to", 1.0}, {"steps", 3}}), ElementsAre(0.0, 0.5, 1.0));
  EXPECT_THAT(Values({{"from", 0.01}, {"to", 1}, {"steps", 3}, {"scale", "log"}}),
              ElementsAre(0.01, 0.1, 1));
  // The geometric mean of 1 and 10 in six digits, as a person would write it.
  EXPECT_EQ(Values({{"from", 1}, {"to", 10}, {"steps", 3}, {"scale", "log"}})[1], Json(3.16228));
  for (const char* wrong : {R"({"from": 0, "to": 1, "steps": 3, "scale": "log"})",
                            R"({"from": 0, "to": 1})", R"({"from": 0, "to": 1, "steps": 1})",
                            R"({"from": 0, "to": 1, "steps": 3, "scael": "log"})",
                            R"({"from": 1, "to": 1, "steps": 2})", "3", "[]"}) {
    EXPECT_THAT(ErrorMessage([&] { Values(Json::parse(wrong)); }), StartsWith("axis")) << wrong;
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

TEST(Grid, OneAtATimeHasTheDefaultOnce) {
  const Options defaults;
  const int spatial = defaults.window.spatial;
  const double eta = defaults.unary.eta;
  const Suite suite =
      WithGrid({{"window.spatial", {spatial, spatial + 1}}, {"unary.eta", {0.5, eta}}}, true);
  EXPECT_THAT(GridPoints(suite, suite.sequences[0], "full"),
              ElementsAre(Json({{"window.spatial", spatial}, {"unary.eta", eta}}),
                          Json({{"window.spatial", spatial + 1}, {"unary.eta", eta}}),
                          Json({{"window.spatial", spatial}, {"unary.eta", 0.5}})));
}

TEST(Grid, AxisDefaultsComeFromTheSuiteAndTheScene) {
  Suite suite = WithGrid({{"window.spatial", {3, 4}}}, true);
  suite.options = {{"window", {{"spatial", 4}}}};
  EXPECT_THAT(GridPoints(suite, suite.sequences[0], "full"),
              ElementsAre(Json({{"window.spatial", 4}}), Json({{"window.spatial", 3}})));
  suite = WithGrid({{"scene.detector.miss_rate", {0.5}}, {"scene.camera.height_m", {1.2}}}, true);
  const double good = 0.01;  // miss rate of that level, see synth/detector/detector_options.h
  EXPECT_EQ(GridPoints(suite, suite.sequences[0], "full").front(),
            Json({{"scene.detector.miss_rate", good}, {"scene.camera.height_m", 1.1}}));
}

TEST(ExpandSuite, OrdersJobsBySequenceSeedPointOracleVariant) {
  Json json = SmallSuite();
  json["sequences"].push_back({{"scene", "crowd"}});
  json["seeds"] = {4, 2};
  json["variants"] = {"full", "static"};
  json["oracles"] = Json::array({Json::array(), {"camera"}});
  json["table"]["rows"] = {"variant", "oracle"};
  json["systems"] = Json::array({{{"name", "left"}, {"writes", {{"camera", "{sequence}.txt"}}}},
                                 {{"name", "other"},
                                  {"command", {"slam", "{left}"}},
                                  {"writes", {{"camera", "c.txt"}}},
                                  {"seeds", 3}}});
  const Suite suite = Parse(json);
  const std::vector<PlanJob> jobs = ExpandSuite(suite);
  ASSERT_EQ(jobs.size(), 24U);
  EXPECT_EQ(jobs[0].variant, "full");
  EXPECT_EQ(jobs[1].variant, "static");
  EXPECT_THAT(jobs[2].oracle, ElementsAre("camera"));
  EXPECT_EQ(jobs[3].seed, 4U);
  EXPECT_EQ(jobs[4].seed, 2U);
  EXPECT_EQ(jobs[8].system, "left");  // its files have no seed
  EXPECT_EQ(jobs[8].variant, "");
  EXPECT_EQ(SystemFilesOf(suite, jobs[8], "/data", "").camera, "/data/tiny.txt");
  EXPECT_EQ(jobs[9].system, "other");
  EXPECT_EQ(jobs[11].seed, 3U);
  EXPECT_EQ(jobs[12].sequence, "crowd");
}

TEST(JobInput, AChangedDetectorStartsFromTheLevelOfTheSequence) {
  Suite suite = Parse(SmallSuite());
  suite.sequences[0].detections = "poor";
  EXPECT_TRUE(SceneAssignments(suite.sequences[0], {}).empty());
  PlanJob job;
  job.folder = "/s";
  EXPECT_EQ(RequestOf(suite, job, "").detections_file, "/s/detections/poor.txt");
  job.parameters = {{"scene.detector.miss_rate", 0.5}, {"window.spatial", 3}};
  EXPECT_THAT(SceneAssignments(suite.sequences[0], job.parameters),
              ElementsAre("detector.level=poor", "detector.miss_rate=0.5"));
  EXPECT_EQ(RequestOf(suite, job, "").detections_file, "/s/detections/custom.txt");
}

TEST(JobInput, AFolderIsReadAsTheSequenceSays) {
  Suite suite;
  SuiteSequence& sequence = suite.sequences.emplace_back();
  sequence.folder = "x";
  sequence.frames = "2:7";
  sequence.detections = "boxes/0003.txt";
  sequence.detections_camera = 2;
  sequence.min_score = 0.25;
  sequence.labels_file = "labels.txt";
  PlanJob job;
  job.folder = "/found/x";
  const SequenceRequest request = RequestOf(suite, job, "/data");
  EXPECT_EQ(request.folder, "/found/x");
  EXPECT_EQ(request.begin_frame, 2);
  EXPECT_EQ(request.end_frame, 7);
  EXPECT_EQ(request.detections_file, "/data/boxes/0003.txt");
  EXPECT_EQ(request.detections_camera, 2);
  EXPECT_EQ(request.min_score, 0.25);
  EXPECT_EQ(request.labels_file, "/data/labels.txt");
}

TEST(Suite, JobsOfTheFirstSeedKeepLandmarksIfRequested) {
  Json json = SmallSuite();
  json["seeds"] = {7, 8};
  for (const PlanJob& job : ExpandSuite(Parse(json))) EXPECT_FALSE(job.landmarks);
  json["landmarks"] = true;
  const Suite suite = Parse(json);
  for (const PlanJob& job : ExpandSuite(suite)) EXPECT_EQ(job.landmarks, job.seed == 7);
}

// The plan of a suite on one scene with a system's shipped trajectory; `folder` gets the scene.json
// that rendering would write.
Plan PlanOfShipped(std::string_view system, std::string_view scene, std::string_view frames,
                   const test::TempFolder& folder, int seed = 1) {
  Json description = synth::LoadScene(std::string(scene), {}).json();
  description["seed"] = seed;
  folder.Write("scene.json", DumpJson(description));
  Plan plan;
  SuiteSequence& sequence = plan.suite.sequences.emplace_back();
  sequence.scene = sequence.name = scene;
  if (frames != "all") sequence.frames = frames;
  plan.suite.systems.emplace_back().name = system;
  plan.suite.seeds = {1};
  plan.jobs = ExpandSuite(plan.suite);
  plan.jobs.at(0).folder = folder.path().string();
  return plan;
}

// When a scene is edited, its trajectories must be removed or computed again.
TEST(ShippedTrajectories, AreOfTheUnchangedScenes) {
  const test::TempFolder folder;
  std::set<std::string> systems;
  for (const ShippedTrajectory& shipped : ShippedTrajectories()) {
    const Plan plan = PlanOfShipped(shipped.system, shipped.scene, shipped.frames, folder);
    const SystemFiles files = SystemFilesOf(plan.suite, plan.jobs[0], "", folder.path());
    systems.insert(files.name);
    const int all = synth::LoadScene(std::string(shipped.scene), {}).parts().frames;
    const std::string& frames = plan.suite.sequences[0].frames;
    EXPECT_EQ(static_cast<int>(ReadTrajectory(files.camera).poses.size()),
              frames.empty() ? all : ResolveFrameRange(ParseFrameRange(frames), all).end)
        << shipped.system << " on " << shipped.scene;
    if (files.objects.empty()) continue;
    systems.insert(files.name + "'s bodies");
    for (const auto& body : std::filesystem::directory_iterator(files.objects)) {
      EXPECT_GT(ReadTrajectory(body.path()).poses.size(), 1U) << body.path();
    }
  }
  EXPECT_THAT(systems, ElementsAre("ORB-SLAM2", "VDO-SLAM", "VDO-SLAM's bodies", "libviso2"));
}

TEST(ShippedTrajectories, OfOtherImagesAreStaleAndNoFailedJobs) {
  const test::TempFolder folder;
  const auto message = [&](const Plan& plan) {
    return ErrorMessage([&] { SystemFilesOf(plan.suite, plan.jobs[0], "", folder.path()); });
  };
  EXPECT_THAT(message(PlanOfShipped("ORB-SLAM2", "indoor_1", "all", folder, 2)),
              StartsWith("stale: ORB-SLAM2 on indoor_1 ran on a scene.json of SHA-256 82b2"));
  EXPECT_THAT(message(PlanOfShipped("ORB-SLAM2", "indoor_1", "0:5", folder)),
              HasSubstr("frames all, not 0:5"));
  Plan plan = PlanOfShipped("ORB-SLAM2", "indoor_1", "all", folder);
  plan.suite.sequences[0].perturb = {{"blur_px", 1}};
  plan.jobs[0].missing = message(plan);
  EXPECT_THAT(plan.jobs[0].missing, StartsWith(kStale));
  EXPECT_EQ(StatusOfAll({"/none"}, plan).at(0).state, JobStatus::State::kNoSequence);
}

}  // namespace
}  // namespace cvo::expand_test
