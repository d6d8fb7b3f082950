// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "experiments/metrics/objects/object_scores.h"
#include "experiments/runner/run_job.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/support/estimator_inputs.h"
#include "tests/support/temp_folder.h"

namespace cvo::clusters_test {
namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

// Tests how detections reach an estimator and its clusters leave it, with a fake that makes a
// cluster of each box.

constexpr int kFrames = 4;

RigidTransform At(double x) {
  return {Eigen::Quaterniond::Identity(), Eigen::Vector3d(x, 0.0, 10.0)};
}

// Reports the i-th box as cluster i + 1. The first feature belongs to cluster 1, all others to the
// static scene.
class BoxOdometry : public Odometry {
 public:
  FrameReport Process(const StereoFrame& frame, StageTimes&) override {
    FrameReport report = Skip(frame.timestamp_ns);
    report.status = FrameStatus::kTracked;
    for (std::size_t i = 0; i < frame.detections.size(); ++i) {
      ClusterReport cluster;
      cluster.id = ClusterId{static_cast<std::int64_t>(i) + 1};
      cluster.category = frame.detections[i].category;
      cluster.detection = static_cast<int>(i);
      cluster.world_from_object = At(0.1 * static_cast<double>(frames_));
      cluster.half_size_m.setConstant(1.0);
      cluster.observed_landmarks = 5;
      report.clusters.push_back(cluster);
      trajectories_.resize(std::max(trajectories_.size(), i + 1));
      trajectories_[i].id = cluster.id;
      trajectories_[i].category = cluster.category;
      trajectories_[i].poses.push_back(
          test::PoseInFrame(frames_ - 1, frame.timestamp_ns, ClusterStatus::kTracked,
                            At(0.1 * static_cast<double>(frames_) + 0.01), cluster));
    }
    for (std::size_t i = 0; i < frame.features.size(); ++i) {
      LandmarkReport landmark;
      landmark.id = LandmarkId{static_cast<std::int64_t>(i)};
      landmark.feature = static_cast<int>(i);
      landmark.cluster = i == 0 && !frame.detections.empty() ? ClusterId{1} : kStaticScene;
      report.landmarks.push_back(landmark);
    }
    return report;
  }
  FrameReport Skip(std::int64_t) override {
    ++frames_;
    FrameReport report;
    report.status = FrameStatus::kSkipped;
    return report;
  }
  std::vector<RigidTransform> Trajectory() const override {
    return std::vector<RigidTransform>(static_cast<std::size_t>(frames_));
  }
  std::vector<ClusterTrajectory> ClusterTrajectories() const override { return trajectories_; }

 private:
  std::int64_t frames_ = 0;
  std::vector<ClusterTrajectory> trajectories_;
};

std::unique_ptr<Odometry> Make(const OdometrySetup&, TaskPool&) {
  return std::make_unique<BoxOdometry>();
}
Options Defaults() { return {}; }
const VariantInfo kBoxes{"boxes", "", &Defaults, &Make};

class RunnerClusters : public testing::Test {
 protected:
  RunnerClusters() {
    test::WriteTinySequence(folder_.path() / "tiny", kFrames);
    folder_.Write("boxes.txt",
                  "0 5 Car -1 -1 -10 10 10 60 60 -1 -1 -1 -1000 -1000 -1000 -10 0.5\n"
                  "1 5 Car -1 -1 -10 10 10 60 60 -1 -1 -1 -1000 -1000 -1000 -10 0.5\n"
                  "1 6 Cyclist -1 -1 -10 10 10 60 60 -1 -1 -1 -1000 -1000 -1000 -10 0.5\n"
                  "1 7 Van -1 -1 -10 70 10 300 60 -1 -1 -1 -1000 -1000 -1000 -10 0.5\n"
                  "3 5 Car -1 -1 -10 10 10 60 60 -1 -1 -1 -1000 -1000 -1000 -10 0.5\n");
    Open("boxes.txt");
  }

  void Open(const std::string& detections) {
    SequenceRequest request;
    request.folder = folder_.path() / "tiny";
    request.type = "kitti-odometry";
    if (!detections.empty()) request.detections_file = folder_.path() / detections;
    sequence_ = OpenSequence(request);
  }
  RunRequest Request() const { return {.sequence = sequence_, .variant = kBoxes, .options = {}}; }
  fs::path Out() const {
    fs::create_directories(folder_.path() / "out");
    return folder_.path() / "out";
  }

  test::TempFolder folder_;
  Sequence sequence_;
};

TEST_F(RunnerClusters, DetectionsReachTheirFrames) {
  const RunResult run = RunSequence(Request()).value();
  ASSERT_THAT(run.frames, SizeIs(kFrames));
  EXPECT_THAT(run.frames[0].detections, SizeIs(1));
  ASSERT_THAT(run.frames[1].detections, SizeIs(2));
  EXPECT_THAT(run.frames[2].detections, IsEmpty());
  EXPECT_EQ(run.frames[1].detections[1].category, "Van");
  EXPECT_EQ(run.frames[1].detections[1].box.right_px, test::kTinyWidth_px - 1);
  EXPECT_EQ(run.frames[1].report.clusters[1].detection, 1);
  EXPECT_EQ(run.detections.given, 4);
  EXPECT_EQ(run.detections.other_classes.at("Cyclist"), 1);
  EXPECT_THAT(run.clusters, SizeIs(2));
}

TEST_F(RunnerClusters, LandmarksAreHandedOverFrameByFrame) {
  std::vector<std::string> rows;
  const auto keep = [&rows](const EstimatedFrame& seen) {
    rows.push_back(LandmarkRows(seen.record.frame, seen.given, seen.record.report.landmarks, {}));
  };
  const RunResult run = RunSequence(Request(), nullptr, keep).value();
  EXPECT_THAT(run.frames[0].report.landmarks, IsEmpty());
  ASSERT_THAT(rows, SizeIs(kFrames));
  EXPECT_THAT(rows[3], StartsWith("3,0,"));
}

TEST_F(RunnerClusters, FilesOfAnEarlierRunAreRemoved) {
  RunRequest request = Request();
  request.landmarks = true;
  ASSERT_TRUE(RunJob(request, Out()).has_value());
  EXPECT_TRUE(fs::exists(Out() / "clusters" / "1.tum"));
  EXPECT_TRUE(fs::exists(Out() / "clusters" / "2.tum"));
  EXPECT_TRUE(fs::exists(Out() / "landmarks.csv"));
  folder_.Write("out/clusters/notes.txt", "mine");

  folder_.Write("boxes.txt", "3 5 Car -1 -1 -10 10 10 60 60 -1 -1 -1 -1000 -1000 -1000 -10 0.5\n");
  Open("boxes.txt");
  ASSERT_TRUE(RunJob(Request(), Out()).has_value());
  EXPECT_TRUE(fs::exists(Out() / "clusters" / "1.tum"));
  EXPECT_FALSE(fs::exists(Out() / "clusters" / "2.tum"));
  EXPECT_FALSE(fs::exists(Out() / "landmarks.csv"));
  EXPECT_TRUE(fs::exists(Out() / "clusters" / "notes.txt"));

  fs::remove(Out() / "clusters" / "notes.txt");
  Open("");
  ASSERT_TRUE(RunJob(Request(), Out()).has_value());
  EXPECT_FALSE(fs::exists(Out() / "clusters"));
}

TEST_F(RunnerClusters, ClassesAndOracleArePartOfTheJob) {
  RunRequest request = Request();
  const std::string job = IdentifyJob(request);
  request.classes = {"Car"};
  EXPECT_NE(IdentifyJob(request), job);
  request.classes = RigidClasses();
  EXPECT_EQ(IdentifyJob(request), job);
  request.oracle.camera = true;
  EXPECT_NE(IdentifyJob(request), job);
  ASSERT_TRUE(RunJob(request, Out()).has_value());
  EXPECT_EQ(ReadJson(Out() / "result.json")["given"]["oracle"], Json::array({"camera"}));
  request.oracle.boxes = true;
  EXPECT_THROW((void)RunJob(request, Out()), Error);
}

TEST_F(RunnerClusters, EstimatesHaveCausalAndRefinedClusters) {
  const RunResult run = RunSequence(Request()).value();
  const ObjectEstimate causal = ObjectEstimateOf(run, reports::PoseTime::kCausal);
  const ObjectEstimate refined = ObjectEstimateOf(run, reports::PoseTime::kRefined);
  ASSERT_THAT(causal.clusters, SizeIs(2));
  ASSERT_THAT(causal.clusters[0].frames, SizeIs(3));
  EXPECT_EQ(causal.clusters[0].frames[2].frame, 3);
  EXPECT_NEAR(causal.clusters[0].frames[2].world_from_object.translation().x(), 0.4, 1e-12);
  EXPECT_NEAR(refined.clusters[0].frames[2].world_from_object.translation().x(), 0.41, 1e-12);
  EXPECT_EQ(causal.clusters[0].frames[2].observed_landmarks, 5);
  EXPECT_THAT(causal.world_from_camera, SizeIs(kFrames));
}

// A body turns about its origin, and only landmarks on one side of it are seen: their centre moves,
// the origin does not.
TEST(ObjectEstimateOf, VelocityIsComparedAtTheClusterCentre) {
  ObjectTruth truth;
  truth.mover_travel_m = -1.0;
  TruthBody body;
  body.id = 1;
  body.name = "top";
  body.category = "Ball";
  std::vector<FrameRecord> frames;
  for (int k = 0; k < 3; ++k) {
    const RigidTransform pose(ExpSo3({0.0, 0.3 * k, 0.0}), {0.0, 0.0, 5.0});
    truth.timestamps_ns.push_back(100'000'000 * k);
    truth.world_from_camera.emplace_back(RigidTransform());
    body.frames.push_back(BodyFrame{pose, true});
    ClusterReport cluster;
    cluster.id = ClusterId{1};
    cluster.world_from_object = pose;
    cluster.center_in_object = Eigen::Vector3d(0.2, 0.0, -0.3);
    cluster.observed_landmarks = 5;
    FrameRecord frame;
    frame.frame = k;
    frame.report.status = FrameStatus::kTracked;
    frame.report.clusters = {cluster};
    frame.landmarks.assign(5, {1, {1, PointMotion::kMoving}});
    frames.push_back(frame);
  }
  const Sequence sequence;
  RunResult run{RunRequest{.sequence = sequence, .variant = kBoxes, .options = {}}};
  run.frames = frames;
  truth.bodies.push_back(body);
  FinishTruth(truth);
  const ObjectScores scores =
      ScoreObjects(truth, ObjectEstimateOf(run, reports::PoseTime::kCausal));
  ASSERT_THAT(scores.bodies, SizeIs(1));
  EXPECT_NEAR(*scores.bodies[0].velocity_m_s, 0.0, 1e-12);
}

TEST(ObjectEstimateOf, FramesBeforeConfirmationHaveOnlyRefinedPoses) {
  std::vector<FrameRecord> frames(2);
  frames[1].frame = 1;
  ClusterReport cluster;
  cluster.id = ClusterId{1};
  frames[1].report.clusters = {cluster};
  ClusterTrajectory trajectory{cluster.id, "", {}};
  for (int k = 0; k < 2; ++k) {
    trajectory.poses.push_back(
        test::PoseInFrame(k, k, ClusterStatus::kTracked, At(1.0 + k), cluster));
  }
  const Sequence sequence;
  RunResult run{RunRequest{.sequence = sequence, .variant = kBoxes, .options = {}}};
  run.frames = frames;
  run.clusters = {trajectory};
  const auto causal = ObjectEstimateOf(run, reports::PoseTime::kCausal).clusters.at(0).frames;
  ASSERT_THAT(causal, SizeIs(1));
  EXPECT_EQ(causal[0].frame, 1);
  EXPECT_EQ(causal[0].world_from_object.translation().x(), 0.0);
  const auto refined = ObjectEstimateOf(run, reports::PoseTime::kRefined).clusters.at(0).frames;
  ASSERT_THAT(refined, SizeIs(2));
  EXPECT_EQ(refined[0].world_from_object.translation().x(), 1.0);
}

}  // namespace
}  // namespace cvo::clusters_test
