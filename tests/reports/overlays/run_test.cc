// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests what is read from the folder of a run in order to draw it.
#include <gmock/gmock.h>

#include "reports/overlays/overlay_run.h"
#include "tests/reports/results/run_folder.h"
#include "tests/support/error_message.h"

namespace cvo::reports {
namespace {

using test::Json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A run of frames 10 to 14, 0.1 s apart, with a static camera. Cluster 7 moves 0.2 m per frame to
// the right, 2 m in front of the camera.
struct OverlayFiles {
  test::RunFiles files;
  std::string landmarks = CsvHeader<LandmarkRow>() +
                          "\n"
                          "10,1,20.5,30,10,0,7,1,0,0,0,0\n"
                          "10,2,40,50,30,7,,1,0,0,0,3\n"
                          "10,3,60,70,50,,0,1,0,0,0,\n"
                          "11,2,41,50,31,7,7,1,0,0,0,3\n";
  OverlayFiles() {
    files.result["job"] = "a";
    files.result["status"] = "ok";
    files.result["variant"] = "full";
    files.result["seed"] = 3;
    files.result["given"] = {{"classes", {"Car", "Van"}}};
    files.result["sequence"] = {{"name", "room"},
                                {"type", "kitti-odometry"},
                                {"pair", "grey"},
                                {"first_frame", 10},
                                {"frames", 5},
                                {"total_frames", 20},
                                {"detections_hash", "abc"},
                                {"camera",
                                 {{"width_px", 320},
                                  {"height_px", 240},
                                  {"fx_px", 200.0},
                                  {"fy_px", 200.0},
                                  {"cx_px", 160.0},
                                  {"cy_px", 120.0}}}};
    files.result["frames"] = Json::array();
    files.truth["camera"] = Json::array();
    files.objects = files.objects.substr(0, files.objects.find('\n') + 1);
    for (int i = 0; i < 5; ++i) {
      files.result["frames"].push_back({{"frame", 10 + i},
                                        {"timestamp_ns", 1'000'000'000 + 100'000'000 * i},
                                        {"status", "tracked"},
                                        {"refined", test::PoseAt(0.0, 0.0, 0.0)}});
      files.truth["camera"].push_back(nullptr);
      const bool predicted = i > 2;
      files.objects +=
          StrCat(10 + i, ",0,7,big car,", predicted ? "predicted" : "tracked", ",", 0.2 * i,
                 ",0,2,0,0,0,1,9,0,0,,,,,,,,,,,,0.1,0,0,0.5,0.4,0.3,"
                 "0.1,0,0,0,0,0,1,1,0.8,0.6,,,,,20,",
                 predicted || i == 1 ? "" : "0", ",0.9\n");
    }
  }
  OverlayRun Read(LandmarkLabel label = LandmarkLabel::kCluster) const {
    const test::TempFolder folder;
    Write(folder);
    return ReadOverlayRun(folder.path(), label);
  }
  void Write(const test::TempFolder& folder) const {
    files.Write(folder);
    if (!landmarks.empty()) folder.Write("landmarks.csv", landmarks);
  }
};

TEST(OverlayRun, ReadsWhatIsDrawn) {
  const OverlayRun run = OverlayFiles().Read();
  EXPECT_THAT(run.missing, IsEmpty());
  EXPECT_EQ(run.variant, "full");
  EXPECT_EQ(run.seed, 3U);
  EXPECT_EQ(run.sequence.camera.width_px, 320);
  EXPECT_THAT(run.classes, ElementsAre("Car", "Van"));
  const OverlayFrame frame = FrameOf(run, 10);
  EXPECT_EQ(frame.run, "full, seed 3");
  ASSERT_EQ(frame.landmarks.size(), 3U);
  EXPECT_FLOAT_EQ(frame.landmarks[0].u_px, 20.5F);
  EXPECT_EQ(frame.landmarks[0].label, kStaticLabel);
  EXPECT_EQ(frame.landmarks[1].label, 7);
  EXPECT_EQ(frame.landmarks[2].label, kOutlierLabel);
  EXPECT_THAT(FrameOf(run, 13).landmarks, IsEmpty());
}

TEST(OverlayRun, LabelsAsInferredInTheFrame) {
  const OverlayFrame frame = FrameOf(OverlayFiles().Read(LandmarkLabel::kInferred), 10);
  EXPECT_EQ(frame.landmarks[0].label, 7);
  EXPECT_EQ(frame.landmarks[1].label, kOutlierLabel);
  EXPECT_EQ(frame.landmarks[2].label, kStaticLabel);
}

TEST(OverlayRun, ClusterIsInCameraCoordinatesWithItsTail) {
  const OverlayFrame frame = FrameOf(OverlayFiles().Read(), 12);
  EXPECT_NEAR(frame.time_s, 0.2, 1e-12);
  ASSERT_EQ(frame.clusters.size(), 1U);
  const ClusterShape& cluster = frame.clusters[0];
  EXPECT_EQ(cluster.category, "big car");
  EXPECT_FALSE(cluster.predicted);
  EXPECT_NEAR(cluster.center()[0], 0.5, 1e-12);  // origin at 0.4, centre of the box 0.1 further
  EXPECT_NEAR(cluster.corners[7][0], 1.0, 1e-12);
  EXPECT_NEAR(cluster.corners[7][1], 0.4, 1e-12);
  EXPECT_NEAR(cluster.corners[0][2], 1.7, 1e-12);
  ASSERT_EQ(cluster.tail.size(), 3U);
  EXPECT_NEAR(cluster.tail[0][0], 0.1, 1e-12);
}

TEST(OverlayRun, AccountsForTheRotationOfTheCamera) {
  OverlayFiles files;
  const double half = std::sqrt(0.5);  // rotated by 90 degrees about y: it looks along x
  files.files.result["frames"][0]["refined"] = {-2.0, 0.0, 2.0, 0.0, half, 0.0, half};
  const ClusterShape cluster = FrameOf(files.Read(), 10).clusters[0];
  EXPECT_NEAR(cluster.center()[0], 0.0, 1e-12);
  EXPECT_NEAR(cluster.center()[2], 2.1, 1e-12);
}

TEST(OverlayRun, ReportsMissingFiles) {
  OverlayFiles files;
  files.landmarks.clear();
  const OverlayRun run = files.Read();
  EXPECT_THAT(run.missing, ElementsAre(AllOf(HasSubstr("without landmarks"),
                                             HasSubstr("landmarks.csv: no such file"))));
  EXPECT_EQ(FrameOf(run, 10).clusters.size(), 1U);
}

TEST(OverlayRun, RefusesOtherFolders) {
  const test::TempFolder empty;
  const auto read = [](const test::TempFolder& folder) {
    return ErrorMessage([&] { ReadOverlayRun(folder.path(), LandmarkLabel::kCluster); });
  };
  EXPECT_THAT(read(empty), HasSubstr("result.json"));
  OverlayFiles files;
  files.files.result["schema_version"] = 9;
  const test::TempFolder other;
  files.Write(other);
  EXPECT_THAT(read(other), HasSubstr("schema_version 9, expected 3"));
  files = {};
  files.files.result["sequence"]["camera"]["fx_px"] = -1.0;
  const test::TempFolder camera;
  files.Write(camera);
  EXPECT_THAT(read(camera), HasSubstr("camera"));
}

TEST(OverlayRun, RefusesAMissingFrame) {
  const OverlayRun run = OverlayFiles().Read();
  EXPECT_THAT(ErrorMessage([&] { FrameOf(run, 99); }),
              AllOf(HasSubstr("frame 99"), HasSubstr("expected 10 to 14")));
}

OverlayRun RunWithLabels(const std::vector<LabelledLandmark>& dots) {
  OverlayRun run;
  run.landmarks[0] = dots;
  BodyDetail still;
  still.id = 5;
  BodyDetail mover;
  mover.id = 6;
  mover.mover = true;
  run.detail.bodies = {still, mover};
  return run;
}

TEST(MarkWrongLabels, ComparesWithTheMajorityBodyOfTheCluster) {
  OverlayRun run = RunWithLabels({{1, 1, 2, 6},  // cluster 2 is mostly on body 6
                                  {2, 1, 2, 6},
                                  {3, 1, 2, 5},  // wrong: on another body
                                  {4, 1, 2, 0},  // wrong: on the background
                                  {5, 1, 0, 6},  // wrong: body 6 moves
                                  {6, 1, 0, 5},  // body 5 is static: correct
                                  {7, 1, kOutlierLabel, 6},
                                  {8, 1, 3, 0},     // wrong: a cluster on no body
                                  {9, 1, 2, -1}});  // truth unknown
  MarkWrongLabels(run);
  std::vector<bool> wrong;
  for (const LabelledLandmark& dot : run.landmarks[0]) wrong.push_back(dot.wrong);
  EXPECT_THAT(wrong, ElementsAre(false, false, true, true, true, false, false, true, false));
  EXPECT_TRUE(run.has_truth);
}

}  // namespace
}  // namespace cvo::reports
