// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/runs/run_detail.h"

#include <gmock/gmock.h>

#include "tests/reports/results/run_folder.h"
#include "tests/support/error_message.h"

namespace cvo::reports {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

RunDetail Read(const test::RunFiles& files) {
  const test::TempFolder folder;
  files.Write(folder);
  return ReadRunDetail(folder.path());
}

TEST(RunDetail, PutsTheTruthBesideTheCameraOfEachFrame) {
  const RunDetail detail = Read({});
  EXPECT_THAT(detail.missing, IsEmpty());
  ASSERT_EQ(detail.camera.size(), 3U);
  EXPECT_EQ(detail.camera[1].frame, 11);
  EXPECT_EQ(detail.camera[1].timestamp_ns, 2);
  EXPECT_EQ(detail.camera[1].status, "tracked");
  EXPECT_THAT(detail.camera[1].world_from_camera, ElementsAre(0, 0, 1, 0, 0, 0, 1));
  ASSERT_TRUE(detail.camera[1].truth);
  EXPECT_THAT(*detail.camera[1].truth, ElementsAre(0.5, 0, 1, 0, 0, 0, 1));
  EXPECT_FALSE(detail.camera[2].truth);
}

TEST(RunDetail, AcceptsTruthOfBodiesOnly) {
  test::RunFiles files;
  files.truth["camera"] = test::Json::array();
  const RunDetail detail = Read(files);
  EXPECT_THAT(detail.missing, IsEmpty());
  EXPECT_FALSE(detail.camera[1].truth);
  EXPECT_EQ(detail.bodies.size(), 1U);
}

TEST(RunDetail, NumbersTheFramesOfBodiesAsInTheSequence) {
  const RunDetail detail = Read({});
  ASSERT_EQ(detail.bodies.size(), 1U);
  const BodyDetail& body = detail.bodies[0];
  EXPECT_EQ(body.name, "the car");
  EXPECT_EQ(body.cluster, 7);
  EXPECT_EQ(body.diagonal_m, 2.5);
  EXPECT_THAT(body.visible, ElementsAre(10, 11));
  ASSERT_EQ(body.truth.size(), 3U);
  EXPECT_EQ(body.truth[2].first, 12);
  ASSERT_EQ(body.estimated.size(), 2U);
  EXPECT_EQ(body.estimated[1].frame, 11);
  EXPECT_NEAR(body.estimated[1].error_m, 0.5, 1e-12);  // a 3-4-5 triangle
  ASSERT_EQ(body.predicted.size(), 1U);
  EXPECT_EQ(body.predicted[0].frame, 12);
  EXPECT_NEAR(body.predicted[0].error_m, 2.0, 1e-12);
}

TEST(RunDetail, PrefersTheRefinedStateOfAClusterToTheCausalOne) {
  const RunDetail detail = Read({});
  ASSERT_EQ(detail.clusters.size(), 2U);
  const ObjectRow& refined = detail.clusters[0];
  EXPECT_EQ(refined.id, 7);
  EXPECT_EQ(refined.category, "car");
  EXPECT_FALSE(refined.predicted());
  EXPECT_EQ(refined.observed_landmarks, 20);
  EXPECT_EQ(refined.WorldFromObject().translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(refined.object_from_box.translation(), Eigen::Vector3d(7, 7, 7));
  EXPECT_EQ(refined.object_from_box.rotation().y(), 1.0);
  EXPECT_EQ(refined.size_m, Eigen::Vector3d(4, 1.5, 2));
  const ObjectRow& then = detail.clusters[1];
  EXPECT_TRUE(then.predicted());
  EXPECT_EQ(then.WorldFromObject().translation(), Eigen::Vector3d(7, 8, 9));
  // What is read is written as it was.
  EXPECT_EQ(CsvHeader<ObjectRow>() + "\n" + CsvLine(refined) + CsvLine(then),
            test::RunFiles().objects);
}

TEST(RunDetail, ReadsTimesAndMachine) {
  const RunDetail detail = Read({});
  ASSERT_EQ(detail.timing.stages.size(), 1U);
  const StageSummary& stage = detail.timing.stages.at("detect");
  EXPECT_EQ(stage.median_ms, 2.0);
  EXPECT_EQ(stage.mean_ms, 2.5);
  EXPECT_EQ(stage.p95_ms, 4.0);
  EXPECT_EQ(detail.timing.frames_per_second, 12.5);
  EXPECT_EQ(detail.timing.host, "here");
  EXPECT_EQ(detail.timing.cpu, "one of 3 GHz");
  EXPECT_EQ(detail.timing.paths.sequence, "/data/room");
}

TEST(RunDetail, ListsMissingFiles) {
  const test::TempFolder folder;
  folder.Write("result.json", test::RunFiles().result.dump());
  const RunDetail detail = ReadRunDetail(folder.path());
  EXPECT_EQ(detail.camera.size(), 3U);
  EXPECT_THAT(detail.bodies, IsEmpty());
  EXPECT_THAT(detail.clusters, IsEmpty());
  EXPECT_THAT(detail.missing, ElementsAre("truth.json: no such file", "objects.csv: no such file",
                                          "timing.json: no such file"));
}

TEST(RunDetail, ListsDamagedFilesAndKeepsTheRest) {
  test::RunFiles files;
  files.truth["bodies"][0]["estimated"]["frames"] = {0, 3};
  files.timing["stages"]["detect"].erase("p95_ms");
  files.objects.resize(files.objects.size() - 5);
  const RunDetail detail = Read(files);
  EXPECT_THAT(detail.bodies, IsEmpty());
  EXPECT_FALSE(detail.camera[0].truth);
  EXPECT_THAT(detail.timing.stages, IsEmpty());
  EXPECT_EQ(detail.timing.frames_per_second, 0.0);
  EXPECT_THAT(detail.clusters, IsEmpty());
  EXPECT_THAT(
      detail.missing,
      ElementsAre(
          AllOf(HasSubstr("truth.json, bodies, estimated, frames"), HasSubstr("one of 3 frames")),
          AllOf(HasSubstr("objects.csv"), HasSubstr("whole lines")),
          AllOf(HasSubstr("timing.json, stages, detect, field p95_ms"), HasSubstr("nothing"))));
}

TEST(RunDetail, ListsFilesOfAnotherSchemaOrKind) {
  test::RunFiles files;
  files.truth["schema_version"] = 9;
  files.timing["kind"] = "run";
  EXPECT_THAT(Read(files).missing,
              ElementsAre(AllOf(HasSubstr("truth.json"), HasSubstr("schema_version 9")),
                          AllOf(HasSubstr("timing.json"), HasSubstr("kind \"run\""))));
}

TEST(RunDetail, ListsTruthOfOtherFramesThanTheResult) {
  test::RunFiles files;
  files.truth["camera"].erase(0);
  EXPECT_THAT(Read(files).missing,
              ElementsAre(AllOf(HasSubstr("2 poses"), HasSubstr("3, one per"))));
  files = {};
  files.truth["bodies"][0]["truth"]["visible"].erase(0);
  EXPECT_THAT(Read(files).missing, ElementsAre(AllOf(HasSubstr("field visible"),
                                                     HasSubstr("2 values"), HasSubstr("3, one"))));
}

TEST(RunDetail, NeedsTheResultItself) {
  const test::TempFolder folder;
  const auto message = [&] { return ErrorMessage([&] { ReadRunDetail(folder.path()); }); };
  EXPECT_THAT(message(), HasSubstr("result.json"));
  test::RunFiles files;
  folder.Write("result.json", files.result.dump().substr(0, 100));
  EXPECT_THAT(message(), HasSubstr("one complete JSON value"));
  files.result["schema_version"] = 1;
  folder.Write("result.json", files.result.dump());
  EXPECT_THAT(message(), AllOf(HasSubstr("schema_version 1"), HasSubstr("expected 3")));
  files = {};
  files.result["frames"][1]["refined"] = {1, 2};
  folder.Write("result.json", files.result.dump());
  EXPECT_THAT(message(), AllOf(HasSubstr("refined"), HasSubstr("7 numbers")));
}

TEST(Landmarks, ADamagedFileIsAnError) {
  const test::TempFolder folder;
  const auto message = [&](const std::string& rows) {
    folder.Write("landmarks.csv", CsvHeader<LandmarkRow>() + "\n" + rows);
    return ErrorMessage(
        [&] { ReadLandmarks(folder.path() / "landmarks.csv", LandmarkLabel::kCluster); });
  };
  EXPECT_THAT(message("1,1,1,7"), HasSubstr("whole lines"));
  EXPECT_THAT(message("1,1,1,7\n"), AllOf(HasSubstr("landmarks.csv:2"), HasSubstr("4 cells")));
  const std::string rest = ",,1,0,0,0,2\n";
  EXPECT_EQ(message("1,1,1,1,1,7" + rest), "");
  EXPECT_THAT(message("1,1,1,1,1,x" + rest), HasSubstr("\"x\" in column cluster"));
  EXPECT_THAT(message("1,1,1,,1,7" + rest), HasSubstr("\"\" in column v_px"));
}

}  // namespace
}  // namespace cvo::reports
