// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests what is read from the folder of a run in order to draw it.
#include <gmock/gmock.h>

#include <set>

#include "reports/overlays/overlay_run.h"
#include "reports/overlays/panels.h"
#include "reports/overlays/thumbnails.h"
#include "tests/reports/overlays/overlay_scene.h"
#include "tests/reports/results/run_folder.h"
#include "tests/support/error_message.h"

namespace cvo::reports {
namespace {

using test::Json;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A run of frames 10 to 14, 0.1 s apart, with a static camera. Cluster 7 moves 0.2 m per frame to
// the right, 2 m in front of the camera.
struct OverlayFiles {
  test::RunFiles files;
  std::string landmarks =
      "frame,id,u_px,v_px,u_right_px,cluster,inferred,confidence,energy_2d,energy_3d,"
      "energy_motion,x,y,z,truth_body\n"
      "10,1,20.5,30,10,0,7,1,0,0,0,0,0,0,0\n"
      "10,2,40,50,30,7,,1,0,0,0,0,0,0,3\n"
      "10,3,60,70,50,,0,1,0,0,0,0,0,0,\n"
      "11,2,41,50,31,7,7,1,0,0,0,0,0,0,3\n";
  std::string tracks =
      "10 7 big car -1 -1 0 5 6 25 36 1 1 1 0 0 2 0 0.9\n"
      "12 7 big car -1 -1 0 7 8 27 38 1 1 1 0 0 2 0 0.9\n";

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
                 ",0,2,0,0,0,1,9,0,0,,,,,,,,,,,0.1,0,0,0.5,0.4,0.3,"
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
    folder.Write("tracks.kitti", tracks);
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

TEST(OverlayRun, DetectionsAreThoseOfAssociatedRows) {
  const OverlayRun run = OverlayFiles().Read();
  ASSERT_EQ(FrameOf(run, 10).detections.size(), 1U);
  EXPECT_EQ(FrameOf(run, 10).detections[0].bottom_px, 36.0);
  EXPECT_THAT(FrameOf(run, 11).detections, IsEmpty());
}

TEST(OverlayRun, ClusterIsInCameraCoordinatesWithItsMotion) {
  const OverlayFrame frame = FrameOf(OverlayFiles().Read(), 12);
  EXPECT_NEAR(frame.time_s, 0.2, 1e-12);
  ASSERT_EQ(frame.clusters.size(), 1U);
  const ClusterShape& cluster = frame.clusters[0];
  EXPECT_EQ(cluster.category, "big car");
  EXPECT_FALSE(cluster.predicted);
  EXPECT_NEAR(cluster.center[0], 0.5, 1e-12);  // origin at 0.4, centre of the box 0.1 further
  EXPECT_NEAR(cluster.corners[7][0], 1.0, 1e-12);
  EXPECT_NEAR(cluster.corners[7][1], 0.4, 1e-12);
  EXPECT_NEAR(cluster.corners[0][2], 1.7, 1e-12);
  EXPECT_NEAR(cluster.ahead[0], 0.5 + 2.0 * kAhead_s, 1e-9);  // 0.2 m in 0.1 s
  ASSERT_EQ(cluster.trail.size(), 2U);
  EXPECT_NEAR(cluster.trail[0][0], 0.1, 1e-12);
}

TEST(OverlayRun, APredictedClusterMovesAsTheModelSays) {
  const OverlayFrame frame = FrameOf(OverlayFiles().Read(), 13);
  EXPECT_TRUE(frame.clusters[0].predicted);
  EXPECT_NEAR(frame.clusters[0].ahead[0], 0.7 + 9.0 * kAhead_s, 1e-9);
}

TEST(OverlayRun, AccountsForTheRotationOfTheCamera) {
  OverlayFiles files;
  const double half = std::sqrt(0.5);  // rotated by 90 degrees about y: it looks along x
  files.files.result["frames"][0]["refined"] = {-2.0, 0.0, 2.0, 0.0, half, 0.0, half};
  const ClusterShape cluster = FrameOf(files.Read(), 10).clusters[0];
  EXPECT_NEAR(cluster.center[0], 0.0, 1e-12);
  EXPECT_NEAR(cluster.center[2], 2.1, 1e-12);
}

TEST(OverlayRun, ReportsMissingFiles) {
  OverlayFiles files;
  files.landmarks.clear();
  const OverlayRun run = files.Read();
  EXPECT_FALSE(run.has_landmarks);
  EXPECT_THAT(run.missing, ElementsAre(AllOf(HasSubstr("drawn without landmarks"),
                                             HasSubstr("landmarks.csv: no such file"))));
  EXPECT_EQ(FrameOf(run, 10).clusters.size(), 1U);
}

TEST(OverlayRun, ReportsTruncatedFiles) {
  OverlayFiles files;
  files.landmarks.resize(files.landmarks.size() - 4);
  EXPECT_THAT(files.Read().missing,
              ElementsAre(AllOf(HasSubstr("drawn without landmarks"), HasSubstr("landmarks.csv:5"),
                                HasSubstr("without a line end"))));
  files = {};
  files.landmarks.insert(files.landmarks.find("40,50"), "x");
  EXPECT_THAT(files.Read().missing, ElementsAre(AllOf(HasSubstr("landmarks.csv:3"),
                                                      HasSubstr("\"x40\" in column u_px"))));
  files = {};
  files.landmarks += "11,2\n";
  EXPECT_THAT(files.Read().missing, ElementsAre(HasSubstr(":6: found 2 cells, expected 15")));
  files = {};
  files.landmarks = "frame,id\n";
  EXPECT_THAT(files.Read().missing, ElementsAre(HasSubstr("no column u_px")));
  files = {};
  files.files.objects.resize(files.files.objects.size() - 4);
  const OverlayRun run = files.Read();
  EXPECT_THAT(run.missing, ElementsAre(HasSubstr("drawn without clusters")));
  EXPECT_THAT(FrameOf(run, 10).clusters, IsEmpty());
  files = {};
  files.tracks = "10 7 car\n";
  EXPECT_THAT(files.Read().missing, ElementsAre(AllOf(HasSubstr("drawn without detections"),
                                                      HasSubstr("tracks.kitti:1"))));
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

OverlayRun RunWithLabels(const std::vector<LandmarkDot>& dots) {
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
  for (const LandmarkDot& dot : run.landmarks[0]) wrong.push_back(dot.wrong);
  EXPECT_THAT(wrong, ElementsAre(false, false, true, true, true, false, false, true, false));
  EXPECT_TRUE(run.has_truth);
}

TEST(AgreeOnColors, MatchesClustersBySharedLandmarks) {
  std::vector<OverlayRun> runs = {
      RunWithLabels({{1, 1, 2}, {2, 1, 2}, {3, 1, 2}, {4, 1, 9}, {5, 1, 8}}),
      RunWithLabels({{1, 1, 4}, {2, 1, 4}, {3, 1, 7}, {4, 1, 7}, {5, 1, 0}})};
  AgreeOnColors(runs);
  EXPECT_THAT(runs[0].color_ids, ElementsAre(testing::Pair(2, 4), testing::Pair(9, 7)));
  EXPECT_THAT(runs[1].color_ids, IsEmpty());
}

// Clusters 2 and 9 of the first run share landmarks with one cluster of the second, 4, whose colour
// a third cluster of the first run has by its own id.
TEST(AgreeOnColors, KeepsClustersOfOneRunApart) {
  std::vector<OverlayRun> runs = {
      RunWithLabels({{1, 1, 2}, {2, 1, 9}, {3, 1, 9}, {4, 1, 4}, {5, 1, 4}}),
      RunWithLabels({{1, 1, 4}, {2, 1, 4}, {3, 1, 4}, {4, 1, 0}, {5, 1, 0}})};
  AgreeOnColors(runs);
  std::set<std::int64_t> colors;
  for (const std::int64_t id : {2, 4, 9}) {
    const auto found = runs[0].color_ids.find(id);
    colors.insert(found == runs[0].color_ids.end() ? id : found->second);
  }
  EXPECT_THAT(colors, testing::SizeIs(3));
  EXPECT_EQ(runs[0].color_ids.at(9), 4) << "it shares most";
}

TEST(ErrorChart, HasALineForEachBodyInTheColourOfItsCluster) {
  OverlayRun run = OverlayFiles().Read();
  const auto count = [&](Rgb color) {
    return test::CountColor(ErrorChart(run, 12, 9, {320, 240}), color);
  };
  BodyDetail body;
  body.cluster = 7;
  for (int i = 0; i < 5; ++i) body.estimated.push_back({10 + i, {}, 0.01 * i});
  run.detail.bodies = {body};
  const int whole = count(ClusterColor(7));
  EXPECT_GT(whole, 100);
  run.detail.bodies[0].estimated.erase(run.detail.bodies[0].estimated.begin() + 2);
  EXPECT_LT(count(ClusterColor(7)), 2 * whole / 3) << "not across the gap";
  run.detail.bodies.clear();
  EXPECT_EQ(count(ClusterColor(7)), 0);
}

// Ids 1 and 17 have the same default colour.
TEST(ApartColors, SeparateClustersOfTheSameFrames) {
  const auto row = [](int frame, std::int64_t id) {
    ClusterRow made;
    made.frame = frame;
    made.id = id;
    return made;
  };
  ASSERT_EQ(ClusterColor(1), ClusterColor(17));
  EXPECT_THAT(ApartColors({row(1, 1), row(2, 17)}), IsEmpty());
  EXPECT_THAT(ApartColors({row(1, 1), row(2, 1), row(2, 17)}), ElementsAre(testing::Pair(17, 2)));
  std::vector<ClusterRow> crowd;
  for (std::int64_t id = 1; id <= 18; ++id) crowd.push_back(row(1, id));
  EXPECT_THAT(ApartColors(crowd), IsEmpty()) << "none is free";
}

TEST(Thumbnails, AreOfEveryKthFrameWithAnImage) {
  const OverlayRun run = OverlayFiles().Read();
  ThumbnailOptions options;
  options.width_px = 160;
  options.most_frames = 3;
  const auto images = [](int frame) { return frame == 12 ? cv::Mat() : test::FlatImage(); };
  const ThumbnailStrip strip = MakeThumbnails(run, images, options);
  ASSERT_EQ(strip.thumbnails.size(), 2U);
  EXPECT_EQ(strip.thumbnails[0].frame, 10);
  EXPECT_EQ(strip.thumbnails[1].frame, 14);
  EXPECT_NEAR(strip.thumbnails[1].time_s, 0.4, 1e-12);
  EXPECT_EQ(strip.width_px, 160);
  EXPECT_GT(strip.height_px, 120);
  EXPECT_EQ(strip.thumbnails[0].jpeg.substr(0, 2), "\xFF\xD8");
  EXPECT_THAT(strip.thumbnails[0].alt, HasSubstr("frame 10; 0.00 s; camera tracked; bodies 1"));
  EXPECT_THAT(strip.missing, ElementsAre("1 frames have no image"));
  EXPECT_EQ(MakeThumbnails(run, images, options).thumbnails[0].jpeg, strip.thumbnails[0].jpeg);
}

TEST(Thumbnails, KeepWithinTheByteLimit) {
  const OverlayRun run = OverlayFiles().Read();
  const auto noise = [](int frame) {
    cv::Mat image(240, 320, CV_8UC1);
    cv::RNG random(static_cast<std::uint64_t>(frame));
    random.fill(image, cv::RNG::UNIFORM, 0, 256);
    return image;
  };
  const auto bytes = [&](std::size_t most) {
    ThumbnailOptions options;
    options.most_bytes = most;
    std::size_t sum = 0;
    for (const Thumbnail& thumbnail : MakeThumbnails(run, noise, options).thumbnails) {
      sum += thumbnail.jpeg.size();
    }
    return sum;
  };
  const std::size_t free = bytes(1'000'000'000);
  EXPECT_LT(bytes(free * 3 / 4), free * 3 / 4 + 1);
  ThumbnailOptions wide;
  wide.width_px = 640;
  EXPECT_THAT(ErrorMessage([&] { MakeThumbnails(run, noise, wide); }), HasSubstr("32 to 320"));
}

TEST(EmptiestCorner, IsTheOneWithFewestBodies) {
  OverlayRun run;
  run.sequence.camera = test::FlatCamera();
  EXPECT_EQ(EmptiestCorner(run), Corner::kTopLeft);
  run.landmarks[1] = {{5.0F, 5.0F, 7}, {310.0F, 5.0F, 7}, {5.0F, 5.0F, kStaticLabel}};
  EXPECT_EQ(EmptiestCorner(run), Corner::kBottomLeft);
  run.detections[1] = {{0, 120, 200, 240}};
  EXPECT_EQ(EmptiestCorner(run), Corner::kBottomRight);
}

}  // namespace
}  // namespace cvo::reports
