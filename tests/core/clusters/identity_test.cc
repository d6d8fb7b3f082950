// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/identity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/estimator_inputs.h"

namespace cvo::identity_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

RigidTransform At(double x, double yaw = 0.0) {
  return {ExpSo3({0.0, yaw, 0.0}), Eigen::Vector3d(x, 0.0, 6.0)};
}

constexpr std::int64_t kInterval_ns = 100'000'000;

// The frame of cluster 2 in that of cluster 1, which is the same body.
const RigidTransform kLostFromFound(ExpSo3({0.1, 0.7, -0.2}), Eigen::Vector3d(0.3, -0.1, 0.2));

// Cluster 1 was lost after frame 10 and is archived. Cluster 2 was created in frame 19 and is
// confirmed in frame 20; it sees `common` of the landmarks of cluster 1, and moves at 1 m/s while
// it turns at 1 rad/s.
struct Return {
  Options options;
  ClusterMap map;
  double off_m = 0.2;  // of the prediction of cluster 1, whose standard deviation is 0.1 m

  explicit Return(int common = 12) {
    map.archived = {Make(1, {{10, At(0.0)}})};
    map.live = {Make(2, {{19, At(1.0, 0.7)}, {20, At(1.1, 0.8)}})};
    Cluster& lost = map.archived[0];
    Cluster& found = map.live[0];
    lost.frames = 100;
    found.detections = options.clusters.confirm_detections;
    found.half_size_m = Eigen::Vector3d::Constant(0.1);
    found.center_in_object = {0.1, 0.0, 0.1};
    Rng rng(3, "identity test");
    for (int i = 0; i < 20; ++i) {
      Landmark landmark;
      landmark.p_in_object = {rng.Normal(), rng.Normal(), rng.Normal()};
      for (std::uint64_t& word : landmark.descriptor) word = rng.NextU64();
      landmark.covariance.in_object_m2 = Eigen::Vector3d(1.0, 2.0, 3.0).asDiagonal();
      landmark.past_information = Eigen::Vector3d(4.0, 5.0, 6.0).asDiagonal();
      landmark.label.cluster = found.id;
      landmark.id = LandmarkId{100 + i};
      found.landmarks.push_back(landmark);
      landmark.p_in_object = kLostFromFound * landmark.p_in_object;
      landmark.label.cluster = lost.id;
      landmark.id = LandmarkId{i};
      if (i >= common) landmark.descriptor = {};
      lost.landmarks.push_back(landmark);
    }
  }
  Cluster Make(std::int64_t id, const std::vector<std::pair<std::int64_t, RigidTransform>>& poses) {
    Cluster cluster;
    cluster.id = ClusterId{id};
    cluster.category = "cart";
    cluster.detections = 8;
    cluster.frames = static_cast<int>(poses.size());
    ClusterReport report;
    report.velocity_m_s = {1.0, 0.0, 0.0};
    report.id = cluster.id;
    report.box.object_from_box = At(0.3);
    ClusterTrajectory& trajectory = map.trajectories[cluster.id];
    trajectory.id = cluster.id;
    for (const auto& [frame, pose] : poses) {
      cluster.states.push_back({FrameId{frame}, frame * kInterval_ns, pose, report.velocity_m_s});
      cluster.last_observed = cluster.last_detected = FrameId{frame};
      // Poses are recorded at the end of a frame; that of frame 20 does not exist yet.
      if (frame < 20) {
        trajectory.poses.push_back(
            test::PoseInFrame(frame, frame * kInterval_ns, ClusterStatus::kTracked, pose, report));
      }
    }
    return cluster;
  }
  // Returns the id of the new cluster after the step.
  template <typename Policy = InheritLostIdentity>
  std::int64_t Found() {
    Rng rng(0, "identity");
    const ClusterPredictor predict = [&](const Cluster&) {
      PredictedCluster predicted;
      predicted.world_from_object = At(1.1 + off_m, 0.8) * kLostFromFound.Inverse();
      predicted.translation_variance_m2 = 0.01;
      return predicted;
    };
    Policy::Update({options, FrameId{20}, predict}, map, rng);
    return map.live.at(0).id.value;
  }
};

TEST(InheritLostIdentity, NewClusterTakesOverTheLostIdentity) {
  Return r;
  EXPECT_EQ(r.Found(), 1);
  EXPECT_THAT(r.map.live, SizeIs(1));
  EXPECT_THAT(r.map.archived, IsEmpty());
  ASSERT_EQ(r.map.trajectories.size(), 1u);
  std::vector<std::int64_t> frames;
  for (const ClusterPose& pose : r.map.trajectories.at(ClusterId{1}).poses) {
    frames.push_back(pose.frame);
    EXPECT_EQ(pose.id, ClusterId{1});
  }
  EXPECT_THAT(frames, ElementsAre(10, 19));
  ASSERT_THAT(r.map.live[0].landmarks, SizeIs(40));
  for (const Landmark& landmark : r.map.live[0].landmarks) {
    EXPECT_EQ(landmark.label.cluster, ClusterId{1});
  }
}

TEST(InheritLostIdentity, ChangesOnlyTheObjectFrame) {
  Return r;
  const Cluster before = r.map.live[0];
  const ClusterPose told = r.map.trajectories.at(before.id).poses.back();
  ASSERT_EQ(r.Found(), 1);
  const Cluster& after = r.map.live[0];
  for (std::size_t i = 0; i < 2; ++i) {
    const RigidTransform& was = before.states[i].world_from_object;
    const RigidTransform& is = after.states[i].world_from_object;
    EXPECT_LT((was * kLostFromFound.Inverse()).Minus(is).norm(), 1e-9);
    const Landmark& old = before.landmarks[0];
    const Landmark& now = after.landmarks[20];
    ASSERT_EQ(old.id, now.id);
    EXPECT_LT((was * old.p_in_object - is * now.p_in_object).norm(), 1e-9);
    EXPECT_LT((was * before.center_in_object - is * after.center_in_object).norm(), 1e-9);
    const Eigen::Matrix3d R = was.RotationMatrix();
    const Eigen::Matrix3d S = is.RotationMatrix();
    EXPECT_LT((R * old.covariance.in_object_m2 * R.transpose() -
               S * now.covariance.in_object_m2 * S.transpose())
                  .norm(),
              1e-9);
    EXPECT_LT((R * old.past_information * R.transpose() - S * now.past_information * S.transpose())
                  .norm(),
              1e-9);
    // The new origin moves with the body, which turns at 1 rad/s.
    const Eigen::Vector3d lever = is.translation() - was.translation();
    EXPECT_LT((after.states[i].velocity_m_s - before.states[i].velocity_m_s -
               Eigen::Vector3d::UnitY().cross(lever))
                  .norm(),
              1e-9);
  }
  const ClusterPose& recorded = r.map.trajectories.at(ClusterId{1}).poses.back();
  EXPECT_LT(recorded.world_from_object.Minus(after.states[0].world_from_object).norm(), 1e-9);
  const RigidTransform world_from_box = told.world_from_object * told.box.object_from_box;
  EXPECT_LT(
      (recorded.world_from_object * recorded.box.object_from_box).Minus(world_from_box).norm(),
      1e-9);
}

TEST(InheritLostIdentity, ReplacesALiveClusterThatWasOnlyPredicted) {
  Return r;
  r.map.live.insert(r.map.live.begin(), r.map.archived[0]);
  r.map.archived.clear();
  r.map.trajectories[ClusterId{1}].poses.push_back(
      test::PoseInFrame(19, 19, ClusterStatus::kPredicted, At(0.9)));
  EXPECT_EQ(r.Found(), 1);
  EXPECT_THAT(r.map.live, SizeIs(1));
  EXPECT_EQ(r.map.live[0].last_observed, FrameId{20});
  const auto& poses = r.map.trajectories.at(ClusterId{1}).poses;
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses[1].frame, 19);
  EXPECT_EQ(poses[1].status, ClusterStatus::kTracked);
}

TEST(InheritLostIdentity, RefusesWithoutEnoughCommonLandmarks) {
  Return r(ClusterAssociationOptions().min_rematch - 1);
  EXPECT_EQ(r.Found(), 2);
  EXPECT_THAT(r.map.archived, SizeIs(1));
}

TEST(InheritLostIdentity, RefusesLandmarksThatDoNotFormTheBody) {
  Return r;
  for (Landmark& landmark : r.map.archived[0].landmarks) {
    landmark.p_in_object = landmark.p_in_object.cwiseProduct(Eigen::Vector3d(-1.0, 1.0, 1.0));
  }
  EXPECT_EQ(r.Found(), 2);
}

TEST(InheritLostIdentity, NeedsMoreThanHalfOfTheSimilarLandmarks) {
  const auto id_with_wrong = [](int wrong) {
    Return r(16);
    for (int i = 0; i < wrong; ++i) r.map.archived[0].landmarks[i].p_in_object.x() += 1.0 + i;
    return r.Found();
  };
  EXPECT_EQ(id_with_wrong(7), 1);
  EXPECT_EQ(id_with_wrong(8), 2);
}

TEST(InheritLostIdentity, RefusesABodyThatCannotHaveMovedThere) {
  Return r;
  r.off_m = 0.5;
  EXPECT_EQ(r.Found(), 2);
}

TEST(InheritLostIdentity, RefusesOtherClassesAndOtherGivenBodies) {
  Return other;
  other.map.archived[0].category = "chair";
  EXPECT_EQ(other.Found(), 2);
  Return given;
  given.map.archived[0].given_body = BodyId{1};
  given.map.live[0].given_body = BodyId{2};
  EXPECT_EQ(given.Found(), 2);
  given.map.live[0].given_body = BodyId{1};
  EXPECT_EQ(given.Found(), 1);
}

TEST(InheritLostIdentity, OnlyNewConfirmedClustersInherit) {
  Return unconfirmed;
  --unconfirmed.map.live[0].detections;
  EXPECT_EQ(unconfirmed.Found(), 2);
  Return old;
  old.map.live[0].frames = 16;
  EXPECT_EQ(old.Found(), 2);
  Return never;
  EXPECT_EQ(never.Found<AlwaysNewIdentity>(), 2);
}

}  // namespace
}  // namespace cvo::identity_test
