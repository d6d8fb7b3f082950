// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "experiments/metrics/pose_errors.h"
#include "experiments/runner/identity.h"
#include "experiments/runner/run_files.h"
#include "tests/support/collected.h"

namespace cvo::result_test {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

using reports::IdentityOf;
using reports::Job;
using reports::JobIdentity;

const std::string kDifferentText = "another";

reports::BuildInfo SomeBuild() {
  reports::BuildInfo build = ThisBuild();
  build.cpu_level = "avx2";
  return build;
}

Job SomeJob() {
  return {"build",        "static", {{"window", {{"spatial", 5}}}}, "content", "detections",
          Json::object(), 0};
}

TEST(BuildIdentity, IsComplete) {
  const reports::BuildInfo build = ThisBuild();
  EXPECT_THAT(build.estimator_sources, MatchesRegex("[0-9a-f]{64}"));
  EXPECT_THAT(build.evaluation_sources, MatchesRegex("[0-9a-f]{64}"));
  EXPECT_NE(build.estimator_sources, build.evaluation_sources);
  for (const std::string& field : {build.version, build.compiler, build.build_type, build.flags,
                                   build.libraries.opencv, build.libraries.eigen, build.commit}) {
    EXPECT_FALSE(field.empty());
  }
}

TEST(BuildIdentity, IgnoresTheCommit) {
  reports::BuildInfo build = SomeBuild();
  const std::string hash = IdentityOf(build);
  build.commit = kDifferentText;
  EXPECT_EQ(IdentityOf(build), hash);
  build.flags += " -O0";
  EXPECT_NE(IdentityOf(build), hash);
}

TEST(JobIdentity, IsStable) {
  // A change here orphans every recorded result: raise the schema version with it.
  EXPECT_EQ(JobIdentity(SomeJob()),
            "008286c28f35a451d8bde869aa12d17c46b5377dde9bfde844ee073fe632d195");
}

TEST(JobIdentity, DependsOnEveryPart) {
  const std::string identity = JobIdentity(SomeJob());
  EXPECT_EQ(JobIdentity(SomeJob()), identity);
  for (const auto& change :
       std::vector<void (*)(Job&)>{[](Job& job) { job.build = kDifferentText; },
                                   [](Job& job) { job.variant = kDifferentText; },
                                   [](Job& job) { job.options["window"]["spatial"] = 6; },
                                   [](Job& job) { job.content = kDifferentText; },
                                   [](Job& job) { job.detections = kDifferentText; },
                                   [](Job& job) { job.given["oracle"] = kDifferentText; },
                                   [](Job& job) { job.seed = 1; }}) {
    Job job = SomeJob();
    change(job);
    EXPECT_NE(JobIdentity(job), identity);
  }
}

TEST(DetectionsHash, DependsOnWhatTheEstimatorIsGiven) {
  Sequence sequence;
  const std::string none = DetectionsHash(sequence);
  ObjectBox box;
  box.type = "Car";
  box.score = 0.5;
  sequence.detections = {box};
  const std::string one = DetectionsHash(sequence);
  EXPECT_NE(one, none);
  sequence.detections[0].track = 7;  // never shown to the estimator
  EXPECT_EQ(DetectionsHash(sequence), one);
  sequence.detections[0].left_px = 1.0;
  EXPECT_NE(DetectionsHash(sequence), one);
  sequence.detections[0].left_px = 0.0;
  sequence.detections_offset_m = 0.06;
  EXPECT_NE(DetectionsHash(sequence), one);
}

const VariantInfo kNone{"static", "", nullptr, nullptr};

// Frames 4 to 7 of a folder, with the statuses first, tracked, skipped and lost.
class Result : public testing::Test {
 protected:
  Result() {
    sequence_.name = "tiny";
    sequence_.type = "kitti-raw";
    sequence_.folder = "/secret/place/tiny";
    sequence_.first_frame = 4;
    sequence_.total_frames = 20;
    sequence_.images.resize(4);
    sequence_.camera = {100, 100, 50, 40, 0.5, 100, 80};
    const FrameStatus status[] = {FrameStatus::kFirst, FrameStatus::kTracked, FrameStatus::kSkipped,
                                  FrameStatus::kLost};
    for (int i = 0; i < 4; ++i) {
      FrameRecord frame;
      frame.frame = 4 + i;
      frame.timestamp_ns = 1'000'000'000LL + i;
      frame.report.status = status[i];
      run_.times_s["decode"].push_back(0.001F * static_cast<float>(i + 1));
      frames_.push_back(frame);
    }
    frames_[2].problems = {{"image_00/data/6.png", "found half a file, expected PNG"}};
    run_.content = "content";
    run_.wall_s = 2.0;
  }

  std::string File() {
    run_.frames = frames_;
    return ResultFile(run_);
  }

  Sequence sequence_;
  std::vector<FrameRecord> frames_;
  RunResult run_{RunRequest{.sequence = sequence_, .variant = kNone, .options = {}, .seed = 3}};
};

TEST_F(Result, ReportsTheStatusOfEachFrame) {
  const Json json = ParseJson(File(), "result");
  EXPECT_EQ(json["schema_version"], reports::RunSummary::kSchemaVersion);
  EXPECT_EQ(json["kind"], "run");
  EXPECT_EQ(json["status"], "ok");
  EXPECT_EQ(json["seed"], 3);
  EXPECT_EQ(json["sequence"]["frames"], 4);
  EXPECT_EQ(json["sequence"]["total_frames"], 20);
  EXPECT_EQ(json["frames"].size(), 4U);
  EXPECT_EQ(json["frames"][1]["frame"], 5);
  EXPECT_EQ(json["frames"][1]["status"], ToString(FrameStatus::kTracked));
  EXPECT_EQ(json["frame_counts"][ToString(FrameStatus::kSkipped)], 1);
  EXPECT_EQ(json["undecodable"][0]["frame"], 6);
  EXPECT_EQ(json["undecodable"][0]["reason"], "found half a file, expected PNG");
  EXPECT_EQ(json["trajectories"]["camera.kitti"]["predicted_rows"], Json({2, 3}));
  EXPECT_EQ(json["trajectories"]["camera.tum"]["omitted_frames"], Json::array({6}));
}

TEST_F(Result, CountsSolverEndings) {
  frames_[0].report.window_endings.converged = 1;
  frames_[1].report.window_endings.iteration_limit = 1;
  frames_[1].report.cluster_endings = {4, 2, 1};
  frames_[3].report.cluster_endings = {1, 0, 0};
  const Json endings = ParseJson(File(), "result")["solver_endings"];
  EXPECT_EQ(endings["camera_windows"],
            Json({{"converged", 1}, {"iteration_limit", 1}, {"no_usable_step", 0}}));
  EXPECT_EQ(endings["cluster_windows"],
            Json({{"converged", 5}, {"iteration_limit", 2}, {"no_usable_step", 1}}));
}

TEST_F(Result, KeepsBothPosesOfAFrame) {
  frames_[1].report.world_from_camera =
      RigidTransform(Eigen::Quaterniond::Identity(), Eigen::Vector3d(1, 2, 3));
  frames_[1].refined_world_from_camera =
      RigidTransform(Eigen::Quaterniond::Identity(), Eigen::Vector3d(4, 5, 6));
  const Json frame = ParseJson(File(), "result")["frames"][1];
  EXPECT_EQ(frame["causal"], Json({1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 1.0}));
  EXPECT_EQ(frame["refined"], Json({4.0, 5.0, 6.0, 0.0, 0.0, 0.0, 1.0}));
}

TEST_F(Result, HasTheCalibrationEstimateWithItsDeviations) {
  EXPECT_TRUE(ParseJson(File(), "result")["calibration"].is_null()) << "nothing was estimated";
  CalibrationReport& calibration = frames_[1].report.calibration;
  calibration.right_field_px << 0.1, 0.2, 0.3, 0.4, 0.5, 0.6;
  calibration.information = 100.0 * Matrix6d::Identity();
  const Json result = ParseJson(File(), "result");
  EXPECT_TRUE(result["frames"][0]["calibration"].is_null());
  EXPECT_EQ(result["frames"][1]["calibration"]["right_field_px"],
            Json({0.1, 0.2, 0.3, 0.4, 0.5, 0.6}));
  EXPECT_NEAR(result["frames"][1]["calibration"]["sigma_px"][5], 0.1, 1e-12);
  EXPECT_NEAR(result["calibration"]["covariance_px2"][2][2], 0.01, 1e-12);
}

TEST_F(Result, ContainsNoTimesHostOrPaths) {
  const std::string before = File();
  EXPECT_THAT(before, Not(HasSubstr("secret")));
  run_.wall_s = 7.0;
  run_.times_s["decode"][0] = 1.0F;
  sequence_.folder = "/elsewhere";
  EXPECT_EQ(File(), before);
}

TEST_F(Result, RefusesNanAndNamesTheField) {
  frames_[3].report.mean_error_px = std::nan("");
  try {
    File();
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("frames[3].mean_error_px: found nan"));
  }
}

TEST_F(Result, MetricsCarryTheirContract) {
  std::vector<Metric>& metrics = run_.scores.metrics;
  metrics = {MakeMetric({reports::MetricId::kCameraAte}, 0.5, 3)};
  metrics[0].contract.truth = reports::TruthSource::kDevkit;
  StatePoses(reports::PoseTime::kCausal, 0.0, metrics);
  const Json json = ParseJson(File(), "result")["metrics"][0];
  EXPECT_EQ(json["value"], 0.5);
  EXPECT_EQ(json["contract"]["truth"], "devkit");
  EXPECT_EQ(json["contract"]["poses"], "causal");
}

TEST_F(Result, TimingHasQuantilesAndContext) {
  run_.frames = frames_;
  run_.cpu_s = 3.0;
  run_.timing = ThisProcess();
  run_.timing.job = "job";
  run_.timing.threads = 2;
  const Json json = ParseJson(TimingFile(run_), "timing");
  EXPECT_EQ(json["frames_per_second"], 2.0);
  EXPECT_EQ(json["cpu_s"], 3.0);
  EXPECT_EQ(json["threads"], 2);
  EXPECT_EQ(json["job"], "job");
  EXPECT_GT(json["peak_memory_mb"], 1.0);
  const Json decode = json["stages"]["decode"];
  EXPECT_EQ(decode["median_ms"], 2.0);
  EXPECT_EQ(decode["mean_ms"], 2.5);
  EXPECT_EQ(decode["p95_ms"], 4.0);
  EXPECT_EQ(decode["total_ms"], 10.0);
  EXPECT_EQ(json["frames"].size(), 4U);
}

}  // namespace
}  // namespace cvo::result_test
