// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "core/record/metric_catalogue.h"
#include "core/record/run_summary.h"
#include "experiments/runner/identity.h"
#include "experiments/runner/run_job.h"
#include "experiments/suite/build_plan.h"
#include "experiments/suite/suite.h"
#include "synth/family/family.h"
#include "synth/write/dataset.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/experiments/suite/examples.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::plan_test {
namespace {

namespace fs = std::filesystem;
using test::FolderSuite;
using test::Parse;
using test::SmallSuite;
using testing::HasSubstr;
using testing::IsEmpty;

// Tests the step from a suite to jobs: finding inputs, identities and the contents of plan.json.

constexpr int kFrames = 4;

class SuitePlan : public testing::Test {
 protected:
  fs::path data() const { return folder_.path() / "data"; }
  fs::path cache() const { return folder_.path() / "cache"; }
  BuiltPlan Build(const Suite& suite) const {
    PlanRequest request;
    request.data = data();
    request.cache = cache();
    return BuildPlan(suite, request);
  }
  // True in a build without OSMesa.
  static bool CannotRender() {
    return ErrorMessage([] { synth::FindRendererVersion(); }) != "";
  }

  test::TempFolder folder_;
};

TEST_F(SuitePlan, TheJobOfAFolderHasTheIdentityThatARunRecords) {
  test::WriteTinySequence(data() / "here" / "07", kFrames);
  Json json = FolderSuite("07");
  json["seeds"] = {3};
  const Suite suite = Parse(json);
  const PlanJob job = Build(suite).plan.jobs.at(0);
  ASSERT_EQ(job.missing, "");
  EXPECT_EQ(job.frames, kFrames);
  const Sequence sequence = OpenSequence(RequestOf(suite, job, data()));
  fs::create_directory(folder_.path() / "out");
  const auto run = RunJob({.sequence = sequence,
                           .variant = FindVariant("static"),
                           .options = OptionsOf(suite, job.variant, job.parameters),
                           .seed = 3},
                          folder_.path() / "out");
  ASSERT_TRUE(run.has_value());
  EXPECT_EQ(job.job, run->job);
  EXPECT_EQ(job.content, run->content);
  std::set<std::string> known;
  for (const std::string& name : reports::AllMetricNames()) known.insert(name);
  for (const Metric& metric : run->scores.metrics) EXPECT_EQ(known.count(metric.name), 1U);
}

TEST_F(SuitePlan, AChangedImageGivesAnotherJob) {
  test::WriteTinySequence(data() / "07", kFrames);
  const Suite suite = Parse(FolderSuite("07"));
  const PlanJob before = Build(suite).plan.jobs.at(0);
  EXPECT_EQ(Build(suite).plan.jobs.at(0).job, before.job);
  fs::copy_file(data() / "07" / "image_0" / "000001.png", data() / "07" / "image_0" / "000002.png",
                fs::copy_options::overwrite_existing);
  const PlanJob after = Build(suite).plan.jobs.at(0);
  EXPECT_NE(after.job, before.job);
  EXPECT_NE(after.content, before.content);
  EXPECT_NE(after.input, before.input);
}

TEST_F(SuitePlan, JobsShareAnInputUnlessTheFrontEndDiffers) {
  test::WriteTinySequence(data() / "07", kFrames);
  Json json = FolderSuite("07");
  json["seeds"] = 2;
  json["variants"] = {"static", "full"};
  json["grid"] = {{"window.spatial", {4, 5}}, {"orb.features", {500, 600}}};
  json["table"]["rows"] = {"variant", "window.spatial", "orb.features"};
  std::set<std::string> inputs;
  std::set<std::string> jobs;
  for (const PlanJob& job : Build(Parse(json)).plan.jobs) {
    inputs.insert(job.input);
    jobs.insert(job.job);
  }
  EXPECT_EQ(inputs.size(), 2U);
  EXPECT_EQ(jobs.size(), 16U);
}

TEST_F(SuitePlan, MissingInputIsReportedNotThrown) {
  test::WriteTinySequence(data() / "a" / "07", kFrames);
  test::WriteTinySequence(data() / "b" / "07", kFrames);
  test::WriteTinySequence(data() / "bad", kFrames);
  fs::remove(data() / "bad" / "calib.txt");
  const auto missing = [&](const Json& json) { return Build(Parse(json)).plan.jobs.at(0).missing; };
  EXPECT_THAT(missing(FolderSuite("2011_09_26_drive_0009_sync")),
              HasSubstr("no 2011_09_26_drive_0009_sync below"));
  EXPECT_THAT(missing(FolderSuite("07")), HasSubstr("both "));
  EXPECT_EQ(missing(FolderSuite("a/O7")), StrCat("no a/O7 below ", data().string()));
  EXPECT_EQ(missing(FolderSuite("a/07")), "");
  EXPECT_THAT(missing(FolderSuite("bad")), HasSubstr("calib.txt"));
  Json json = FolderSuite("a/07");
  json["sequences"][0]["detections"] = "nowhere.txt";
  EXPECT_EQ(missing(json), StrCat("no file nowhere.txt below ", data().string()));
  json["sequences"][0]["detections"] = "labels";
  EXPECT_THAT(missing(json), testing::Not(HasSubstr("no file")));
  PlanRequest without_data;
  without_data.cache = cache();
  const BuiltPlan none = BuildPlan(Parse(FolderSuite("a/07")), without_data);
  EXPECT_THAT(none.plan.jobs.at(0).missing, HasSubstr("--data"));
  EXPECT_EQ(none.plan.jobs.at(0).job, "");
}

TEST_F(SuitePlan, FindsAFolderByTheEndOfItsPath) {
  test::WriteTinySequence(data() / "deep" / "er" / "06", kFrames);
  const auto found = [&](const std::string& folder) {
    return Build(Parse(FolderSuite(folder))).plan.jobs.at(0);
  };
  EXPECT_EQ(found("06").folder, data() / "deep" / "er" / "06");
  EXPECT_EQ(found("er/06").folder, data() / "deep" / "er" / "06");
  EXPECT_EQ(found("deep/06").folder, "");
  EXPECT_EQ(found("6").folder, "");
  // Labels without images, such as those of a drive stored in another layout, are not runnable.
  folder_.Write("data/training/image_02/none.txt", "");
  folder_.Write("data/training/calib/0003.txt", "");
  EXPECT_EQ(found("training/0003").missing,
            StrCat("no images of both cameras of training/0003 below ", data().string()));
}

TEST_F(SuitePlan, JobsOfSystemsDependOnTheirFiles) {
  test::WriteTinySequence(data() / "07", kFrames);
  folder_.Write("data/other.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  Json json = FolderSuite("07");
  json["systems"] = Json::array({{{"name", "other"}, {"writes", {{"camera", "other.txt"}}}}});
  const Suite suite = Parse(json);
  const PlanJob job = Build(suite).plan.jobs.at(1);
  EXPECT_EQ(job.system, "other");
  EXPECT_NE(job.job, "");
  folder_.Write("data/other.txt", "1 0 0 1 0 1 0 0 0 0 1 0\n");
  EXPECT_NE(Build(suite).plan.jobs.at(1).job, job.job);
  fs::remove(data() / "other.txt");
  EXPECT_THAT(Build(suite).plan.jobs.at(1).missing, HasSubstr("other.txt"));
}

TEST_F(SuitePlan, ReadsBackWhatItWroteAndNothingElse) {
  test::WriteTinySequence(data() / "07", kFrames);
  Json json = FolderSuite("07");
  json["grid"] = {{"window.spatial", {4, 5}}};
  json["oracles"] = Json::array({{"camera"}});
  json["table"]["rows"] = {"window.spatial"};
  const std::string text = PlanText(Build(Parse(json)).plan);
  const auto message = [](const Json& changed) {
    return ErrorMessage([&] { ParsePlan(changed, "p.json"); });
  };
  const Json written = ParseJson(text, "plan.json");
  EXPECT_EQ(PlanText(ParsePlan(written, "plan.json")), text);
  EXPECT_EQ(written["suite"]["name"], "small");
  EXPECT_EQ(written["table"]["rows"], Json({"window.spatial"}));
  EXPECT_EQ(written["jobs"][1]["parameters"], Json({{"window.spatial", 5}}));
  for (const char* key : {"sequence", "detections", "variant", "system", "seed", "oracle", "folder",
                          "missing", "input", "job"}) {
    EXPECT_TRUE(written["jobs"][0].contains(key)) << key;
  }
  EXPECT_EQ(message(written), "");
  for (const char* key : {"kind", "schema_version", "definition", "jobs", "build"}) {
    Json damaged = written;
    damaged.erase(key);
    EXPECT_THAT(message(damaged), testing::StartsWith("p.json")) << key;
  }
  Json other = written;
  other["jobs"][0]["entry"] = 7;
  EXPECT_THAT(message(other), testing::StartsWith("p.json"));
}

TEST_F(SuitePlan, RequestsScenesThatAreNotRendered) {
  if (CannotRender()) GTEST_SKIP() << "this build has no OSMesa";
  Json json = SmallSuite();
  json["seeds"] = 2;
  json["variants"] = {"full", "static"};
  json["sequences"][0]["frames"] = "1:4";
  const BuiltPlan built = Build(Parse(json));
  for (const PlanJob& job : built.plan.jobs) {
    EXPECT_EQ(job.missing, kNotRendered);
    EXPECT_EQ(job.job, "");
    EXPECT_EQ(job.frames, 3);
  }
  ASSERT_EQ(built.preparations.size(), 2U);
  EXPECT_TRUE(built.preparations[0].draws);
  EXPECT_FALSE(built.preparations[1].draws);
  EXPECT_NE(built.preparations[0].output, built.preparations[1].output);
  EXPECT_EQ(built.preparations[0].output.filename(), "tiny");
  EXPECT_THAT(
      built.preparations[0].arguments,
      testing::ElementsAre("synth", "render", "tiny", "-o", built.preparations[0].output.string(),
                           "--seed", "1", "--frames", "1:4"));
}

TEST_F(SuitePlan, TheJobOfARenderedSceneHasTheIdentityOfItsBytes) {
  if (CannotRender()) GTEST_SKIP() << "this build has no OSMesa";
  ASSERT_EQ(::setenv("CLUSTERVO_CACHE", cache().c_str(), 1), 0);
  Json json = SmallSuite();
  json["sequences"][0]["frames"] = "0:2";
  const Suite suite = Parse(json);
  const Preparation render = Build(suite).preparations.at(0);
  synth::RenderRequest request;
  request.frames.end = 2;
  request.seed = 1;
  synth::WriteDataset(synth::LoadScene("tiny", {}), request, render.output);
  const BuiltPlan built = Build(suite);
  EXPECT_THAT(built.preparations, IsEmpty());
  const PlanJob& job = built.plan.jobs.at(0);
  ASSERT_EQ(job.missing, "");
  const Sequence sequence = OpenSequence(RequestOf(suite, job, ""));
  EXPECT_EQ(sequence.name, "tiny");
  EXPECT_FALSE(sequence.detections.empty());
  EXPECT_EQ(job.content, ContentHash(sequence, HashImages(sequence)));
  EXPECT_EQ(job.job, IdentifyJob({.sequence = sequence,
                                  .variant = FindVariant("full"),
                                  .options = OptionsOf(suite, "full", {}),
                                  .seed = 1}));
  // A scene with a missing or truncated file is rendered again.
  EXPECT_EQ(FindSceneDamage(render.output), std::nullopt);
  fs::resize_file(render.output / "image_0" / "000001.png", 10);
  EXPECT_EQ(FindSceneDamage(render.output, {0, 1}), std::nullopt);
  EXPECT_THAT(FindSceneDamage(render.output).value_or(""),
              HasSubstr("image_0/000001.png has 10 bytes instead of "));
  EXPECT_EQ(Build(suite).plan.jobs.at(0).missing, kNotRendered);
}

TEST_F(SuitePlan, TheFolderOfASceneDependsOnItsContent) {
  if (CannotRender()) GTEST_SKIP() << "this build has no OSMesa";
  const auto scene = [&](const Json& changes) {
    Json json = SmallSuite();
    json.merge_patch(changes);
    return Build(Parse(json)).preparations.at(0);
  };
  const auto with = [](const char* path, const Json& value) {
    return Json{{"grid", {{path, {value}}}}};
  };
  const Preparation one = scene(Json::object());
  EXPECT_EQ(scene(Json::object()).output, one.output);
  EXPECT_EQ(scene(with("window.spatial", 3)).output, one.output);
  for (const Json& changes : {Json{{"seeds", {2}}}, with("scene.detector.miss_rate", 0.5)}) {
    EXPECT_NE(scene(changes).output, one.output) << changes;
    EXPECT_EQ(scene(changes).drawing, one.drawing) << changes;
  }
  EXPECT_NE(scene(with("scene.camera.height_m", 1.15)).drawing, one.drawing);
  Json frames = SmallSuite();
  frames["sequences"][0]["frames"] = "0:2";
  EXPECT_NE(Build(Parse(frames)).preparations.at(0).drawing, one.drawing);
}

}  // namespace
}  // namespace cvo::plan_test
