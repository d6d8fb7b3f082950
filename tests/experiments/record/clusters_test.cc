// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <sstream>

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "core/record/csv_rows.h"
#include "experiments/runner/run_files.h"
#include "experiments/runner/run_result.h"
#include "tests/support/collected.h"
#include "tests/support/estimator_inputs.h"

namespace cvo::clusters_test {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

// Tests the tables of clusters and landmarks on hand-made results.

RigidTransform At(double x, double y, double z) {
  return {Eigen::Quaterniond::Identity(), Eigen::Vector3d(x, y, z)};
}

std::vector<std::vector<std::string>> Cells(const std::string& table, char separator) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back(1);
    for (const char c : line) {
      if (c == separator) {
        rows.back().emplace_back();
      } else {
        rows.back().back() += c;
      }
    }
  }
  return rows;
}

const VariantInfo kNone{"none", "", nullptr, nullptr};

// A run of one frame, frame 4 of its folder, with one cluster: a box of 2 x 1 x 4 m centred at
// (0, 0, 10) in the camera and world frames.
class Clusters : public testing::Test {
 protected:
  Clusters() {
    sequence_.camera = {100, 100, 50, 40, 0.5, 100, 80};
    sequence_.left_offset_m = 0.06;
    sequence_.first_frame = 4;
    sequence_.images.resize(1);
    FrameRecord frame;
    frame.frame = 4;
    frame.timestamp_ns = 500;
    ClusterReport cluster;
    cluster.id = ClusterId{3};
    cluster.category = "Car";
    cluster.world_from_object = At(0, 0, 9);
    cluster.center_in_object = {0, 0, 1};
    cluster.half_size_m = {0.4, 0.2, 0.8};
    cluster.box = {Heading(-std::numbers::pi / 2.0), {4.0, 1.0, 2.0}};
    cluster.observed_landmarks = 12;
    cluster.score = 0.75;
    frame.report.clusters = {cluster};
    frames_ = {frame};
  }

  // A box pose with this heading, 1 m ahead of the cluster's origin.
  static RigidTransform Heading(double radians) {
    return {ExpSo3({0.0, radians, 0.0}), Eigen::Vector3d(0.0, 0.0, 1.0)};
  }
  // The trajectory of the cluster with one tracked frame.
  ClusterTrajectory Refined(std::int64_t frame, const RigidTransform& world_from_object) {
    return {ClusterId{3},
            "Car",
            {test::PoseInFrame(frame, 500, ClusterStatus::kTracked, world_from_object, cluster())}};
  }
  ClusterReport& cluster() { return frames_[0].report.clusters[0]; }
  RunResult Run() const {
    RunResult run{RunRequest{.sequence = sequence_, .variant = kNone, .options = {}}};
    run.frames = frames_;
    run.clusters = clusters_;
    return run;
  }
  std::optional<ImageBox> Box() const {
    std::optional<ImageBox> box;
    ForEachLiveCluster(Run(),
                       [&](const LiveCluster& row) { box = ProjectedBox(row, sequence_.camera); });
    return box;
  }
  std::string ObjectTable() const { return test::Collected(WriteObjectTable, Run()); }
  std::string KittiTracks() const { return test::Collected(WriteKittiTracks, Run()); }
  std::vector<std::string> Track() const {
    const auto rows = Cells(KittiTracks(), ' ');
    return rows.empty() ? std::vector<std::string>() : rows[0];
  }

  Sequence sequence_;
  std::vector<FrameRecord> frames_;
  std::vector<ClusterTrajectory> clusters_;
};

TEST_F(Clusters, TheImageBoxIsThatOfTheNearestFace) {
  // The nearest face is at 8 m, where +-1 m and +-0.5 m are +-12.5 px and +-6.25 px.
  const auto box = Box();
  ASSERT_TRUE(box);
  EXPECT_NEAR(box->left_px, 37.5, 1e-9);
  EXPECT_NEAR(box->right_px, 62.5, 1e-9);
  EXPECT_NEAR(box->top_px, 33.75, 1e-9);
  EXPECT_NEAR(box->bottom_px, 46.25, 1e-9);
}

TEST_F(Clusters, ABoxThatReachesBehindTheCameraFillsTheImageOnItsSide) {
  cluster().world_from_object = At(2.0, 0, 0);  // from x = 1 to 3, z = -1 to 3
  const auto box = Box();
  ASSERT_TRUE(box);
  EXPECT_NEAR(box->left_px, 50 + 100.0 / 3.0, 1e-9);
  EXPECT_EQ(box->right_px, 99.0);
  EXPECT_EQ(box->top_px, 0.0);
  EXPECT_EQ(box->bottom_px, 79.0);
}

TEST_F(Clusters, APredictedPoseIsNoTrack) {
  cluster().status = ClusterStatus::kPredicted;
  EXPECT_TRUE(KittiTracks().empty());
  EXPECT_THAT(Cells(ObjectTable(), ','), SizeIs(2));
}

TEST_F(Clusters, AClusterOutOfViewHasNoBoxAndNoTrack) {
  for (const RigidTransform& pose : {At(0, 0, -9), At(30, 0, 9), At(0, -30, 9)}) {
    cluster().world_from_object = pose;
    EXPECT_FALSE(Box());
    EXPECT_TRUE(KittiTracks().empty());
    const auto rows = Cells(ObjectTable(), ',');
    ASSERT_THAT(rows, SizeIs(2));
    EXPECT_THAT(rows[1], SizeIs(rows[0].size()));
  }
}

TEST_F(Clusters, TheBoxIsUprightOnItsBottom) {
  const auto row = Track();
  ASSERT_THAT(row, SizeIs(18));
  EXPECT_THAT(std::vector(row.begin(), row.begin() + 5), ElementsAre("4", "3", "Car", "-1", "-1"));
  EXPECT_NEAR(std::stod(row[16]), -std::numbers::pi / 2.0, 1e-12);
  EXPECT_NEAR(std::stod(row[10]), 1.0, 1e-12);    // height
  EXPECT_NEAR(std::stod(row[11]), 2.0, 1e-12);    // width
  EXPECT_NEAR(std::stod(row[12]), 4.0, 1e-12);    // length
  EXPECT_NEAR(std::stod(row[13]), -0.06, 1e-12);  // camera 0 is to the right of the one read
  EXPECT_NEAR(std::stod(row[14]), 0.5, 1e-12);    // bottom: y is down
  EXPECT_NEAR(std::stod(row[15]), 10.0, 1e-12);
  EXPECT_EQ(row[17], "0.75");
}

TEST_F(Clusters, TheHeadingIsThatOfTheBoxWithoutItsTilt) {
  cluster().box.object_from_box = Heading(0.7);
  EXPECT_NEAR(std::stod(Track()[16]), 0.7, 1e-12);
  const RigidTransform tilted(ExpSo3({0.0, 0.0, 0.2}), Eigen::Vector3d::Zero());
  cluster().box.object_from_box = Heading(0.7) * tilted;
  const auto row = Track();
  EXPECT_NEAR(std::stod(row[16]), 0.7, 1e-12);
  EXPECT_NEAR(std::stod(row[10]), 1.0, 1e-12);  // height
  EXPECT_NEAR(std::stod(row[12]), 4.0, 1e-12);
}

TEST_F(Clusters, TheImageBoxOfATrackIsThatOfItsDetection) {
  frames_[0].detections = {{{1, 2, 3, 4}, "Car", 1.0}, {{5, 6, 7, 8.5}, "Car", 1.0}};
  cluster().detection = 1;
  const auto row = Track();
  EXPECT_THAT(std::vector(row.begin() + 6, row.begin() + 10), ElementsAre("5", "6", "7", "8.5"));
}

TEST_F(Clusters, TracksUseRefinedPosesOfClusterAndCamera) {
  frames_[0].refined_world_from_camera = At(1, 0, 0);
  EXPECT_NEAR(std::stod(Track()[13]), -0.06, 1e-12);  // no refined cluster pose: both are causal
  clusters_ = {Refined(0, At(3, 0, 9))};
  EXPECT_NEAR(std::stod(Track()[13]), 2.0 - 0.06, 1e-12);
}

TEST_F(Clusters, ARowHasAllFields) {
  cluster().status = ClusterStatus::kPredicted;
  cluster().velocity_m_s = {0.1, 0.2, 0.3};
  auto rows = Cells(ObjectTable(), ',');
  ASSERT_THAT(rows, SizeIs(2));
  ASSERT_THAT(rows[0], SizeIs(49));
  ASSERT_THAT(rows[1], SizeIs(49));
  EXPECT_THAT(std::vector(rows[1].begin(), rows[1].begin() + 15),
              ElementsAre("4", "500", "3", "Car", ToString(ClusterStatus::kPredicted), "0", "0",
                          "9", "0", "0", "0", "1", "0.1", "0.2", "0.3"));
  EXPECT_EQ(rows[1][16], "");  // no refined pose
  EXPECT_EQ(rows[1][31], "0.8");
  EXPECT_EQ(rows[1][34], "1");  // of the box in the object frame
  EXPECT_EQ(rows[0][39], "length_m");
  EXPECT_EQ(rows[1][39], "4");
  EXPECT_EQ(rows[1][46], "12");
  EXPECT_EQ(rows[1][47], "");  // no detection
  EXPECT_EQ(rows[1][48], "0.75");
  clusters_ = {Refined(0, At(0, 0, 8))};
  rows = Cells(ObjectTable(), ',');
  EXPECT_EQ(rows[1][4], "predicted");  // each pose with a status of its own
  EXPECT_EQ(rows[1][15], "tracked");
  EXPECT_EQ(rows[1][18], "8");
}

TEST_F(Clusters, FramesBeforeConfirmationHaveOnlyARefinedPose) {
  frames_.push_back(frames_[0]);
  frames_[1].frame = 5;
  clusters_ = {Refined(0, At(0, 0, 8))};
  clusters_[0].poses.push_back(
      test::PoseInFrame(1, 600, ClusterStatus::kTracked, At(0, 0, 8.5), cluster()));
  frames_[0].report.clusters.clear();
  const auto rows = Cells(ObjectTable(), ',');
  ASSERT_THAT(rows, SizeIs(3));
  EXPECT_THAT(std::vector(rows[1].begin(), rows[1].begin() + 8),
              ElementsAre("4", "500", "3", "Car", "", "", "", ""));
  EXPECT_EQ(rows[1][15], "tracked");
  EXPECT_EQ(rows[1][18], "8");
  EXPECT_EQ(rows[1][39], "4");  // its box in that frame
  EXPECT_EQ(rows[1][46], "12");
  EXPECT_EQ(rows[2][7], "9");
  EXPECT_EQ(Track()[0], "4");
}

TEST(LandmarkRows, HaveTheFeatureTheLabelsAndTheTruth) {
  StereoFrame frame;
  frame.features.resize(2);
  frame.features[1].z_px = {10.5, 20, 8};
  LandmarkReport landmark;
  landmark.id = LandmarkId{77};
  landmark.feature = 1;
  landmark.cluster = ClusterId{2};
  landmark.confidence = -3;
  landmark.p_in_world = {1, 2, 3};
  EXPECT_EQ(LandmarkRows(9, frame, {landmark}, {}), "9,77,10.5,20,8,2,,-3,1,2,3,\n");
  EXPECT_EQ(LandmarkRows(9, frame, {landmark}, {{-1}, {4}}), "9,77,10.5,20,8,2,,-3,1,2,3,4\n");
  EXPECT_THROW(LandmarkRows(9, frame, {landmark}, {{4}}), Error);
  EXPECT_EQ(Cells(CsvHeader<reports::LandmarkRow>() + "\n", ',')[0].size(), 12U);
}

RigidTransform At(double x) { return {Eigen::Quaterniond::Identity(), Eigen::Vector3d(x, 0, 0)}; }

// The origin of the run's world is at x = 1 m in the world of the truth; body 2 is scored in frame
// 1 only.
TEST(TruthFile, PutsTheTruthIntoTheWorldOfTheRun) {
  ObjectTruth objects;
  objects.timestamps_ns = {0, 1};
  TruthBody body;
  body.id = 2;
  body.size_m.x() = 0.5;
  body.frames = {std::nullopt, BodyFrame{At(5), true}};
  objects.bodies = {body};
  BodyScore score;
  score.id = 2;
  score.name = "ball";
  score.cluster = 7;
  score.errors = {{1}, {0.25}};
  score.estimated_positions = {{5.25, 0, 0}};
  Sequence sequence;
  sequence.groundtruth_world_from_camera = {At(1), std::nullopt};
  RunResult run{RunRequest{.sequence = sequence, .variant = kNone, .options = {}}};
  run.job = "id";
  run.scores.truth_from_estimate = At(1);
  run.scores.refined_bodies = {score};
  const Json file = ParseJson(TruthFile(run, &objects), "truth.json");
  EXPECT_EQ(file["job"], "id");
  EXPECT_EQ(file["camera"][0], Json({0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}));
  EXPECT_TRUE(file["camera"][1].is_null());
  const Json& ball = file["bodies"][0];
  EXPECT_EQ(ball["cluster"], 7);
  EXPECT_EQ(ball["truth"]["frames"], Json({1}));
  EXPECT_EQ(ball["truth"]["poses"][0][0], 4.0);
  EXPECT_EQ(ball["truth"]["visible"], Json({true}));
  EXPECT_EQ(ball["estimated"]["positions_m"], Json::parse("[[4.25, 0.0, 0.0]]"));
  EXPECT_EQ(ball["predicted"]["frames"], Json::array());
}

}  // namespace
}  // namespace cvo::clusters_test
