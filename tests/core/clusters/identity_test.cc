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

RigidTransform At(double x, double yaw = 0.0) {
  return {ExpSo3({0.0, yaw, 0.0}), Eigen::Vector3d(x, 0.0, 6.0)};
}

constexpr std::int64_t kInterval_ns = 100'000'000;
const Eigen::Vector3d kVelocity_m_s(1.0, 0.0, 0.0);

// Cluster 1 was lost after frame 10 and is archived; its prediction is at x = 1. Cluster 2 was
// created in frame 19 and is confirmed in frame 20, at x = 1.1 and rotated. Both move at 1 m/s, so
// that cluster 1 is 0.1 m behind.
struct Return {
  ClusterAssociationOptions association;
  ClusterOptions options;
  MotionPriorOptions motion;
  ClusterPredictor predict;
  ClusterMap map;
  std::vector<LostCluster> lost;

  Return() {
    Cluster old = Make(1, {{10, At(0.0)}});
    old.detections = 8;
    map.archived = {old};
    map.live = {Make(2, {{19, At(1.0, 0.7)}, {20, At(1.1, 0.8)}})};
    map.live[0].detections = options.confirm_detections;
    Landmark landmark;
    landmark.id = LandmarkId{3};
    landmark.label.cluster = ClusterId{2};
    landmark.p_in_object = {0.2, -0.1, 0.4};
    landmark.covariance.in_object_m2 = Eigen::Vector3d(1.0, 2.0, 3.0).asDiagonal();
    landmark.past_information = Eigen::Vector3d(4.0, 5.0, 6.0).asDiagonal();
    map.live[0].landmarks = {landmark};
    map.live[0].center_in_object = {0.1, 0.0, 0.1};
    lost = {Predicted(1, 1.0)};
  }
  Cluster Make(std::int64_t id, const std::vector<std::pair<std::int64_t, RigidTransform>>& poses) {
    Cluster cluster;
    cluster.id = ClusterId{id};
    cluster.category = "cart";
    cluster.size.Add(1.0, true);
    cluster.frames = 100;
    ClusterReport report;
    report.velocity_m_s = kVelocity_m_s;
    report.id = cluster.id;
    report.box.object_from_box = At(0.3);
    ClusterTrajectory& trajectory = map.trajectories[cluster.id];
    trajectory.id = cluster.id;
    for (const auto& [frame, pose] : poses) {
      cluster.states.push_back({FrameId{frame}, frame * kInterval_ns, pose, kVelocity_m_s});
      cluster.last_observed = cluster.last_detected = FrameId{frame};
      // Poses are recorded at the end of a frame; that of frame 20 does not exist yet.
      if (frame < 20) {
        trajectory.poses.push_back(
            test::PoseInFrame(frame, frame * kInterval_ns, ClusterStatus::kTracked, pose, report));
      }
    }
    return cluster;
  }
  static LostCluster Predicted(std::int64_t id, double x, double variance_m2 = 0.04) {
    LostCluster predicted{ClusterId{id}, {}};
    predicted.predicted.world_from_object = At(x);
    predicted.predicted.translation_variance_m2 = variance_m2;
    return predicted;
  }
  IdentityStep Step() const { return {association, options, motion, FrameId{20}, predict}; }
  // Returns the id of the new cluster after the step.
  std::int64_t Found() {
    InheritIdentities(Step(), lost, map);
    return map.live.at(0).id.value;
  }
  void StopTurning() { map.live[0].states[1].world_from_object = At(1.1, 0.7); }
  double FoundX() const { return map.live[0].Latest().world_from_object.translation().x(); }
};

TEST(InheritIdentities, NewClusterTakesOverTheLostIdentity) {
  Return r;
  EXPECT_EQ(r.Found(), 1);
  EXPECT_THAT(r.map.live, testing::SizeIs(1));
  EXPECT_THAT(r.map.archived, IsEmpty());
  ASSERT_EQ(r.map.trajectories.size(), 1u);
  std::vector<std::int64_t> frames;
  for (const ClusterPose& pose : r.map.trajectories.at(ClusterId{1}).poses) {
    frames.push_back(pose.frame);
  }
  EXPECT_THAT(frames, ElementsAre(10, 19));
  EXPECT_EQ(r.map.live[0].landmarks[0].label.cluster, ClusterId{1});
}

TEST(InheritIdentities, ChangesOnlyTheObjectFrame) {
  Return r;
  const Cluster before = r.map.live[0];
  const ClusterPose told = r.map.trajectories.at(before.id).poses.back();
  ASSERT_EQ(r.Found(), 1);
  const Cluster& after = r.map.live[0];
  // The lost cluster did not rotate, so the axes rotate at half the new cluster's rate of 1 rad/s
  // over 0.9 s. The origin remains the new cluster's in every frame.
  EXPECT_LT(after.states[0].world_from_object.Minus(At(1.0, 0.45)).norm(), 1e-9);
  for (std::size_t i = 0; i < 2; ++i) {
    const RigidTransform& was = before.states[i].world_from_object;
    const RigidTransform& is = after.states[i].world_from_object;
    EXPECT_LT((was.translation() - is.translation()).norm(), 1e-12);
    const Landmark& old = before.landmarks[0];
    const Landmark& now = after.landmarks[0];
    EXPECT_LT((was * old.p_in_object - is * now.p_in_object).norm(), 1e-12);
    EXPECT_LT((was * before.center_in_object - is * after.center_in_object).norm(), 1e-12);
    const Eigen::Matrix3d R = was.RotationMatrix();
    const Eigen::Matrix3d S = is.RotationMatrix();
    EXPECT_LT((R * old.covariance.in_object_m2 * R.transpose() -
               S * now.covariance.in_object_m2 * S.transpose())
                  .norm(),
              1e-12);
    EXPECT_LT((R * old.past_information * R.transpose() - S * now.past_information * S.transpose())
                  .norm(),
              1e-12);
  }
  const ClusterPose& recorded = r.map.trajectories.at(ClusterId{1}).poses.back();
  EXPECT_LT(recorded.world_from_object.Minus(after.states[0].world_from_object).norm(), 1e-12);
  EXPECT_EQ(recorded.id, ClusterId{1});
  const RigidTransform world_from_box = told.world_from_object * told.box.object_from_box;
  EXPECT_LT(
      (recorded.world_from_object * recorded.box.object_from_box).Minus(world_from_box).norm(),
      1e-12);
}

TEST(InheritIdentities, OriginIsBetweenMotionAndBoxEstimates) {
  // The boxes place the body 0.1 m from where its motions place it. Their deviation is relative to
  // that of the motions (0.3 of the predicted one).
  const auto placed_at = [](double relative_deviation) {
    Return r;
    r.StopTurning();
    const double speed = SpeedVariance(r.map.live[0]);
    const BridgedMotion way = BridgeMotion(0.9, r.motion.q_m2_s3, speed, speed);
    const double variance = relative_deviation * relative_deviation * 0.3 * 0.3 * way.variance;
    const Eigen::Matrix3d information = 2.0 / variance * Eigen::Matrix3d::Identity();
    r.map.archived[0].box_center.Add(Eigen::Vector3d::Zero(), information);
    // Many boxes from one side carry no more information than one.
    for (int i = 0; i < 9; ++i) r.map.live[0].box_center.Add(Eigen::Vector3d::Zero(), information);
    EXPECT_EQ(r.Found(), 1);
    return r.FoundX();
  };
  EXPECT_NEAR(placed_at(1e-6), 1.1, 1e-6);
  EXPECT_NEAR(placed_at(1.0), 1.05, 1e-6);
  EXPECT_NEAR(placed_at(1e6), 1.0, 1e-6);
}

TEST(AlignInheritedFrames, AdjustsTheFrameUntilThereAreEnoughBoxes) {
  Return r;
  r.StopTurning();
  const Eigen::Matrix3d nothing = 1e-12 * Eigen::Matrix3d::Identity();
  r.map.archived[0].box_center.Add(Eigen::Vector3d::Zero(), nothing);
  r.map.live[0].box_center.Add(Eigen::Vector3d::Zero(), nothing);
  ASSERT_EQ(r.Found(), 1);
  EXPECT_NEAR(r.FoundX(), 1.0, 1e-6);
  // If the velocity at its recovery turns out to be larger, so was the distance travelled.
  ClusterPose& first = r.map.trajectories.at(ClusterId{1}).poses.back();
  first.velocity_m_s.x() = 1.2;
  Rng rng(0, "identity");
  AlignInheritedFrames(r.Step(), r.map, rng);
  EXPECT_NEAR(r.FoundX(), 1.0 + 0.9 * 0.5 * 0.2, 1e-6);
  // The frame is adjusted for the last time.
  for (int i = 0; i < 20; ++i) r.map.live[0].box_center.Add(Eigen::Vector3d::Zero(), nothing);
  first.velocity_m_s.x() = 1.4;
  AlignInheritedFrames(r.Step(), r.map, rng);
  EXPECT_NEAR(r.FoundX(), 1.0 + 0.9 * 0.5 * 0.4, 1e-6);
  first.velocity_m_s.x() = 2.0;
  AlignInheritedFrames(r.Step(), r.map, rng);
  EXPECT_NEAR(r.FoundX(), 1.0 + 0.9 * 0.5 * 0.4, 1e-6);
}

TEST(InheritIdentities, ReplacesALiveClusterThatWasOnlyPredicted) {
  Return r;
  r.map.live.insert(r.map.live.begin(), r.map.archived[0]);
  r.map.archived.clear();
  r.map.trajectories[ClusterId{1}].poses.push_back(
      test::PoseInFrame(19, 19, ClusterStatus::kPredicted, At(0.9)));
  EXPECT_EQ(r.Found(), 1);
  EXPECT_THAT(r.map.live, testing::SizeIs(1));
  EXPECT_EQ(r.map.live[0].last_observed, FrameId{20});
  const auto& poses = r.map.trajectories.at(ClusterId{1}).poses;
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses[1].frame, 19);
  EXPECT_EQ(poses[1].status, ClusterStatus::kTracked);
}

TEST(InheritIdentities, RefusesDistantPredictionsAndOtherClasses) {
  Return far;
  far.lost = {Return::Predicted(1, 3.0)};
  EXPECT_EQ(far.Found(), 2);
  Return other;
  other.map.archived[0].category = "chair";
  EXPECT_EQ(other.Found(), 2);
  EXPECT_EQ(other.map.archived.size(), 1u);
}

TEST(InheritIdentities, RefusesAmbiguousCandidates) {
  Return r;
  r.map.archived.push_back(r.Make(4, {{9, At(0.0)}}));
  r.lost.push_back(Return::Predicted(4, 1.22));
  EXPECT_EQ(r.Found(), 2);
  // If one is much nearer than the other, there is no ambiguity.
  Return clear;
  clear.map.archived.push_back(clear.Make(4, {{9, At(0.0)}}));
  clear.lost.push_back(Return::Predicted(4, 1.6));
  EXPECT_EQ(clear.Found(), 1);
  EXPECT_EQ(clear.map.archived.size(), 1u);
}

TEST(InheritIdentities, RefusesBodiesOfAnotherSize) {
  Return r;
  r.lost = {Return::Predicted(1, 1.0, 1.0)};
  r.map.archived[0].size.Add(5.0, true);
  EXPECT_EQ(r.Found(), 2);
  Return unknown;
  unknown.lost = {Return::Predicted(1, 1.0, 1.0)};
  unknown.map.archived[0].size = {};  // known from given labels only
  EXPECT_EQ(unknown.Found(), 1);
}

TEST(InheritIdentities, PartialViewsMayBeSmallerButNotLarger) {
  const auto found = [](double found_m, double lost_m) {
    Return r;
    r.lost = {Return::Predicted(1, 1.0, 1.0)};
    r.map.live[0].size = {found_m, false};
    r.map.archived[0].size = {lost_m, true};
    return r.Found();
  };
  EXPECT_EQ(found(0.2, 1.0), 1);
  EXPECT_EQ(found(5.0, 1.0), 2);
}

TEST(InheritIdentities, HappensOnlyAtConfirmation) {
  Return early;
  --early.map.live[0].detections;
  EXPECT_EQ(early.Found(), 2);
  Return late;
  ++late.map.live[0].detections;
  EXPECT_EQ(late.Found(), 2);
}

TEST(InheritIdentities, NeverTakesTheIdOfAnotherGivenBody) {
  Return r;
  r.map.archived[0].given_body = BodyId{1};
  r.map.live[0].given_body = BodyId{2};
  EXPECT_EQ(r.Found(), 2);
  r.map.live[0].given_body = BodyId{1};
  EXPECT_EQ(r.Found(), 1);
}

TEST(IdentityPolicies, OnlyInheritLostIdentityInherits) {
  const ClusterPredictor predict = [](const Cluster& cluster) {
    return Return::Predicted(cluster.id.value, 1.0).predicted;
  };
  const auto found = [&](auto policy) {
    Return r;
    Rng rng(0, "identity");
    r.predict = predict;
    decltype(policy)::Update(r.Step(), r.map, rng);
    return r.map.live.at(0).id.value;
  };
  EXPECT_EQ(found(InheritLostIdentity()), 1);
  EXPECT_EQ(found(AlwaysNewIdentity()), 2);
}

}  // namespace
}  // namespace cvo::identity_test
