// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/score_files.h"

#include <gtest/gtest.h>

#include "core/files/json/json.h"
#include "tests/experiments/runner/system_drive.h"

namespace cvo::score_files_test {
namespace {

using test::kDriveFrames;
using test::ReportedBox;
using test::Rows;
using test::SystemDrive;
using test::ValueOf;

ReportedBox Moved(ReportedBox said, const Eigen::Vector3d& by) {
  said.world_from_object = RigidTransform(Eigen::Matrix3d::Identity(), by) * said.world_from_object;
  return said;
}

TEST(ScoreSystem, AnyObjectFrameAndAnyWorldIsAccepted) {
  const SystemDrive drive;
  const RigidTransform off[] = {{ExpSo3({0.0, 0.3, 0.0}), {0.5, -0.2, 0.1}},
                                {ExpSo3({0.0, -1.0, 0.0}), {-0.3, 0.0, 0.4}}};
  const SystemOutcome outcome = drive.Score(Rows([&](ReportedBox said, int) {
    said.world_from_object = said.world_from_object * off[said.track];
    return said;
  }));
  ASSERT_EQ(outcome.bodies.size(), 2U);
  EXPECT_EQ(ValueOf(outcome, "camera_coverage"), 1.0);
  EXPECT_LT(ValueOf(outcome, "camera_ate"), 1e-9);
  EXPECT_EQ(ValueOf(outcome, "object_coverage"), 1.0);
  for (const char* name : {"object_ate", "object_trpe_all_pairs", "object_rrpe_all_pairs",
                           "object_motion_t", "object_motion_r"}) {
    EXPECT_LT(ValueOf(outcome, name), 1e-6) << name;
  }
  EXPECT_EQ(ValueOf(outcome, "object_unmatched_clusters"), 0.0);
}

// The boxes are off by 0.3 m to alternating sides: the mean offset is no error, the rest is.
TEST(ScoreSystem, ErrorsAreThoseOfTheBoxes) {
  const SystemDrive drive;
  const SystemOutcome outcome = drive.Score(Rows([](ReportedBox said, int frame) {
    if (said.track == 0) {
      said = Moved(said, {frame % 2 == 0 ? 0.3 : -0.3, 0, 0});
    }
    return said;
  }));
  EXPECT_NEAR(*outcome.bodies[0].ate_m, 0.3, 1e-9);
  EXPECT_NEAR(*outcome.bodies[1].ate_m, 0.0, 1e-9);
  EXPECT_NEAR(ValueOf(outcome, "object_ate"), 0.15, 1e-9);
  EXPECT_NEAR(ValueOf(outcome, "object_trpe_1_frame"), 0.3, 1e-9);
  EXPECT_EQ(ValueOf(outcome, "object_success_20cm"), 0.5);
}

TEST(ScoreSystem, VelocityIsThatOfTheBoxes) {
  const SystemDrive drive;
  EXPECT_LT(ValueOf(drive.Score(Rows()), "object_velocity"), 1e-9);
  // The boxes move 0.1 m per frame of 0.1 s too fast.
  const SystemOutcome outcome = drive.Score(Rows([](ReportedBox said, int frame) {
    said = Moved(said, {0.0, 0.0, 0.1 * frame});
    return said;
  }));
  EXPECT_NEAR(*outcome.bodies[0].velocity_m_s, 1.0, 1e-6);
  // A run scores the velocities that it estimated, which is another contract.
  EXPECT_EQ(FindMetric(outcome.metrics, "object_velocity")->contract.pairing,
            reports::Pairing::kVelocitiesOfPositions);
}

// The correction that our readers know for a calibration does not tell which one the system was
// given.
TEST(ScoreSystem, CorrectionIsTheSystemsOwn) {
  SystemDrive drive;
  drive.sequence().camera.right_shift_px = 0.16;
  const auto correction = [&](double right_shift_px) {
    SystemRequest request = drive.Request(FormatTumTrajectory(SystemDrive::Camera()), Rows());
    request.right_shift_px = right_shift_px;
    const Json result = ParseJson(ScoreSystem(request).result, "result");
    EXPECT_EQ(result["sequence"]["camera"]["right_shift_px"], right_shift_px);
    return result["metrics"][0]["contract"]["right_shift_px"].get<double>();
  };
  EXPECT_EQ(correction(0.0), 0.0);
  EXPECT_EQ(correction(0.2), 0.2);
}

TEST(ScoreSystem, BodiesAreMatchedByPositionNotById) {
  const SystemDrive drive;
  const SystemOutcome outcome = drive.Score(Rows([](ReportedBox said, int) {
    said.track = 1 - said.track;
    return said;
  }));
  EXPECT_EQ(outcome.bodies[0].cluster, 1);
  EXPECT_EQ(outcome.bodies[1].cluster, 0);
  EXPECT_LT(ValueOf(outcome, "object_ate"), 1e-9);
  EXPECT_EQ(ValueOf(outcome, "object_id_switches"), 0.0);
}

TEST(ScoreSystem, SwappedIdsAreSwitchesAndErrors) {
  const SystemDrive drive;
  const SystemOutcome outcome = drive.Score(Rows([](ReportedBox said, int frame) {
    if (frame >= 5) said.track = 1 - said.track;
    return said;
  }));
  EXPECT_EQ(outcome.bodies[0].cluster, 0);
  EXPECT_EQ(outcome.bodies[1].cluster, 1);
  EXPECT_EQ(ValueOf(outcome, "object_id_switches"), 2.0);
  EXPECT_EQ(ValueOf(outcome, "object_fragments"), 0.0);
  EXPECT_GT(ValueOf(outcome, "object_ate"), 1.0);
}

TEST(ScoreSystem, MissingFramesLowerCoverage) {
  const SystemDrive drive;
  const SystemOutcome outcome = drive.Score(Rows([](ReportedBox said, int frame) {
    const bool missing = said.track == 1 || frame % 4 >= 2;
    return missing ? std::nullopt : std::optional(said);
  }));
  EXPECT_EQ(outcome.bodies[0].estimated_frames, kDriveFrames / 2);
  EXPECT_EQ(outcome.bodies[1].estimated_frames, 0);
  EXPECT_EQ(outcome.bodies[1].cluster, -1);
  EXPECT_EQ(ValueOf(outcome, "object_coverage"), 0.25);
  EXPECT_EQ(ValueOf(outcome, "object_success_20cm"), 0.25);
  EXPECT_EQ(ValueOf(outcome, "object_unmatched"), 1.0);
  EXPECT_EQ(ValueOf(outcome, "object_fragments"), 1.0);
}

TEST(ScoreSystem, DistantClustersAreNotMatched) {
  const SystemDrive drive;
  const SystemOutcome outcome = drive.Score(Rows([](ReportedBox said, int) {
    // The diagonal of the box is 4.64 m.
    const double off_m = said.track == 0 ? 4.7 : 4.6;
    said = Moved(said, {0.0, -off_m, 0.0});
    return said;
  }));
  EXPECT_EQ(outcome.bodies[0].cluster, -1);
  EXPECT_EQ(outcome.bodies[1].cluster, 1);
  EXPECT_EQ(ValueOf(outcome, "object_unmatched_clusters"), 1.0);
}

TEST(ScoreSystem, ABoxIsPlacedByItsOwnFramesCamera) {
  const SystemDrive drive;
  const SystemOutcome outcome = drive.Score(
      Rows(), FormatTumTrajectory(SystemDrive::Camera([](int frame) { return frame != 3; })));
  EXPECT_EQ(outcome.frames_without_camera, 1);
  EXPECT_EQ(outcome.object_frames, 2 * kDriveFrames);
  EXPECT_EQ(outcome.object_frames_left_out, 2);
  EXPECT_EQ(ValueOf(outcome, "camera_coverage"), 7.0 / 8.0);
  EXPECT_EQ(ValueOf(outcome, "object_coverage"), 7.0 / 8.0);
  EXPECT_LT(ValueOf(outcome, "object_ate"), 1e-9);
}

TEST(ScoreSystem, WithoutObjectsCoverageIsZero) {
  const SystemDrive drive;
  const SystemOutcome outcome =
      drive.Score("0 -1 DontCare -1 -1 0 0 0 1 1 -1 -1 -1 -1000 -1000 -1000 -10\n");
  EXPECT_EQ(ValueOf(outcome, "object_coverage"), 0.0);
  EXPECT_EQ(ValueOf(outcome, "object_unmatched"), 2.0);
  EXPECT_EQ(FindMetric(outcome.metrics, "object_ate"), nullptr);
  const SystemOutcome camera = drive.Score("none");
  EXPECT_EQ(FindMetric(camera.metrics, "object_coverage"), nullptr);
  EXPECT_LT(ValueOf(camera, "camera_ate"), 1e-9);
}

TEST(ScoreSystem, AFolderOfTrajectoriesScoresLikeItsBoxes) {
  const SystemDrive drive;
  SystemRequest request = drive.Request(FormatTumTrajectory(SystemDrive::Camera()), "none");
  for (const int track : {0, 1}) {
    Trajectory object;
    for (int frame = 0; frame < kDriveFrames; ++frame) {
      object.push_back(
          {100'000'000 * frame, SystemDrive::World() * test::CarInWorld(track, frame)});
    }
    drive.folder().Write(StrCat("objects/", 3 + track, ".tum"), FormatTumTrajectory(object));
  }
  request.files.objects = drive.folder().path() / "objects";
  const SystemOutcome folder = ScoreSystem(request);
  const SystemOutcome rows = drive.Score(Rows());
  ASSERT_EQ(folder.metrics.size(), rows.metrics.size());
  for (std::size_t i = 0; i < rows.metrics.size(); ++i) {
    EXPECT_EQ(folder.metrics[i].name, rows.metrics[i].name);
    EXPECT_NEAR(folder.metrics[i].value, rows.metrics[i].value, 1e-6) << rows.metrics[i].name;
  }
  EXPECT_EQ(folder.bodies[1].cluster, 4);
}

TEST(ScoreSystem, TheResultHasTheFormatOfARun) {
  const SystemDrive drive;
  const SystemRequest request = drive.Request(FormatTumTrajectory(SystemDrive::Camera()), Rows());
  const SystemOutcome outcome = ScoreSystem(request, drive.folder().path());
  EXPECT_EQ(test::ReadFile(drive.folder().path() / "result.json"), outcome.result);
  const Json json = ParseJson(outcome.result, "result");
  EXPECT_EQ(json["kind"], "run");
  EXPECT_EQ(json["status"], "ok");
  EXPECT_EQ(json["variant"], "system:other");
  EXPECT_EQ(json["system"]["name"], "other");
  EXPECT_EQ(json["job"], outcome.job);
  EXPECT_EQ(outcome.job, IdentifySystem(request));
  EXPECT_EQ(json["frames"].size(), static_cast<std::size_t>(kDriveFrames));
  ASSERT_EQ(json["bodies"]["refined"].size(), 2U);
  EXPECT_EQ(json["bodies"]["refined"][0]["errors"]["frames"].size(),
            static_cast<std::size_t>(kDriveFrames));
  for (const Json& metric : json["metrics"]) EXPECT_EQ(metric["contract"]["poses"], "refined");
}

TEST(IdentifySystem, DependsOnWhatDecidesTheResult) {
  const SystemDrive drive;
  const std::string camera = FormatTumTrajectory(SystemDrive::Camera());
  const std::string job = IdentifySystem(drive.Request(camera, Rows()));
  const auto changed = [&](const std::function<void(SystemRequest&)>& change) {
    SystemRequest request = drive.Request(camera, Rows());
    change(request);
    return IdentifySystem(request) != job;
  };
  EXPECT_FALSE(changed([](SystemRequest&) {}));
  EXPECT_FALSE(changed(
      [&](SystemRequest& r) { r.files.camera = drive.folder().Write("elsewhere.txt", camera); }));
  EXPECT_TRUE(changed([](SystemRequest& r) { r.content = "another"; }));
  EXPECT_TRUE(changed([](SystemRequest& r) { r.files.name = "another"; }));
  EXPECT_TRUE(changed([](SystemRequest& r) { r.files.objects = ""; }));
  EXPECT_TRUE(changed([](SystemRequest& r) { r.seed = 1; }));
  EXPECT_NE(IdentifySystem(drive.Request(camera + "# a comment\n", Rows())), job);
  EXPECT_NE(IdentifySystem(drive.Request(camera, Rows() + Rows())), job);
}

}  // namespace
}  // namespace cvo::score_files_test
