// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

#include "core/clusters/cluster_association.h"
#include "core/clusters/cluster_map.h"
#include "core/clusters/cluster_prediction.h"
#include "core/solvers/motion_prior.h"
#include "tests/core/clusters/small_windows.h"

namespace cvo::parts_test {
namespace {

using test::At;
using test::kCamera;
using test::kInterval_ns;
using test::MakeLandmark;
using test::StateAt;
using test::WindowOf;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

// Tests parts of the life cycle, the association and the prediction of clusters in isolation.

std::vector<std::int64_t> Ids(const std::vector<Landmark>& landmarks) {
  std::vector<std::int64_t> ids;
  for (const Landmark& landmark : landmarks) ids.push_back(landmark.id.value);
  return ids;
}

TEST(TrimCluster, DropsWhatIsOlderThanTheWindowExceptTheLastState) {
  Cluster cluster;
  for (int f = 0; f < 4; ++f) cluster.states.push_back(StateAt(f, At(0, 0, 5)));
  cluster.landmarks = {MakeLandmark(0, {0, 3}), MakeLandmark(1, {0, 1}), MakeLandmark(2, {1})};
  cluster.landmarks[1].past_information.setIdentity();
  cluster.last_observed = FrameId{5};
  TrimCluster(WindowOf(2, 5), FrameId{5}, {}, cluster);
  ASSERT_THAT(cluster.states, SizeIs(2));
  EXPECT_EQ(cluster.states[0].frame, FrameId{2});
  EXPECT_THAT(Ids(cluster.landmarks), ElementsAre(0, 1));
  EXPECT_THAT(cluster.landmarks[0].observations, SizeIs(1));
  EXPECT_THAT(cluster.landmarks[1].observations, IsEmpty());
  EXPECT_EQ(cluster.landmarks[1].observations.capacity(), 0U);
  cluster.last_observed = FrameId{12};
  TrimCluster(WindowOf(8, 12), FrameId{12}, {}, cluster);
  ASSERT_THAT(cluster.states, SizeIs(1));
  EXPECT_EQ(cluster.states[0].frame, FrameId{3});
}

TEST(TrimCluster, DropsTheLongestUnseenLandmarksBeyondTheLimit) {
  ClusterOptions options;
  options.max_landmarks = 3;
  Cluster cluster;
  cluster.states = {StateAt(5, At(0, 0, 5))};
  cluster.landmarks = {MakeLandmark(0, {4, 5}), MakeLandmark(1, {3}), MakeLandmark(2, {4}),
                       MakeLandmark(3, {2}),    MakeLandmark(4, {4}), MakeLandmark(5, {1})};
  Cluster full = cluster;
  TrimCluster(WindowOf(1, 6), FrameId{6}, options, cluster);
  // Of those last seen in frame 4, the newer ones stay.
  EXPECT_THAT(Ids(cluster.landmarks), ElementsAre(0, 2, 4));
  // Landmarks observed in the newest frame always stay.
  for (Landmark& landmark : full.landmarks) landmark.last_seen = FrameId{6};
  TrimCluster(WindowOf(1, 6), FrameId{6}, options, full);
  EXPECT_THAT(full.landmarks, SizeIs(6));
}

Cluster ClusterSeen(std::int64_t id, std::int64_t observed, std::int64_t detected, int detections) {
  Cluster cluster;
  cluster.id = ClusterId{id};
  cluster.states = {StateAt(observed, At(0, 0, 5))};
  cluster.last_observed = FrameId{observed};
  cluster.last_detected = FrameId{detected};
  cluster.detections = detections;
  return cluster;
}

std::vector<std::int64_t> LiveIds(const ClusterMap& map) {
  std::vector<std::int64_t> ids;
  for (const Cluster& cluster : map.live) ids.push_back(cluster.id.value);
  return ids;
}

TEST(RetireClusters, RemovesTheLostAndForgetsTheUnconfirmed) {
  const ClusterOptions options;
  const int L = Options().LiveFrames();
  ClusterMap map;
  map.live = {ClusterSeen(1, 100 - L + 1, 80, 2),                        // unseen for L - 1 frames
              ClusterSeen(2, 100 - L, 80, 2),                            // for L frames
              ClusterSeen(3, 100, 100 - options.confirm_frames, 1),      // never confirmed
              ClusterSeen(4, 100, 100 - options.confirm_frames + 1, 1),  // has one frame left
              ClusterSeen(5, 100 - L, -1, 0),
              ClusterSeen(6, 100 - L, -1, 0)};
  map.live[5].given_body = BodyId{7};  // given bodies need no confirmation
  for (const Cluster& cluster : map.live) map.trajectories[cluster.id].id = cluster.id;
  RetireClusters(FrameId{100}, Options().LiveFrames(), options, map);
  EXPECT_THAT(LiveIds(map), ElementsAre(1, 4));
  std::vector<std::int64_t> told;
  for (const auto& cluster : ConfirmedTrajectories(map, options)) told.push_back(cluster.id.value);
  EXPECT_THAT(told, ElementsAre(1, 2, 6));
}

TEST(RetireClusters, RemovesWhatStandsStillUndetected) {
  const ClusterOptions options;
  const std::int64_t last = 100 - options.undetected_frames;
  ClusterMap map;
  // 1 and 2 have moved by less than a twelfth of their size, 3 and 4 by more.
  for (const RigidTransform& end : {At(0, 0, 5), At(0.05, 0, 5), At(0.1, 0, 5), At(0, 0, 5, 0.5)}) {
    Cluster cluster = ClusterSeen(map.next.value++, 100, last, 2);
    cluster.states = {StateAt(90, At(0, 0, 5)), StateAt(100, end)};
    cluster.half_size_m = {0.2, 0.1, 0.1};
    map.live.push_back(cluster);
  }
  // The others are like 1, but one was detected a frame later, one more often, and one was given.
  for (int id = 5; id <= 7; ++id) {
    map.live.push_back(map.live[0]);
    map.live.back().id = ClusterId{id};
  }
  map.live[4].last_detected = FrameId{last + 1};
  map.live[5].detections = options.undetected_frames + 1;
  map.live[6].given_body = BodyId{8};
  RetireClusters(FrameId{100}, Options().LiveFrames(), options, map);
  EXPECT_THAT(LiveIds(map), ElementsAre(3, 4, 5, 6, 7));
}

// A landmark on a body 6 m ahead, last observed by a camera at the origin.
struct Prediction {
  Options options;
  PredictedCluster predicted;
  Landmark landmark;
  RigidTransform world_from_camera;

  Prediction() {
    predicted.world_from_object = At(0.5, -0.2, 6.0, 0.4);
    landmark.p_in_object = {0.3, 0.1, -0.5};

    const Eigen::Vector3d p = predicted.world_from_object * landmark.p_in_object;
    landmark.depth_m = p.z();
    landmark.covariance.in_object_m2 = Eigen::Vector3d(1e-4, 2e-4, 3e-4).asDiagonal();
  }
  std::optional<PredictedLandmark> Predict() const {
    const StereoFrame frame;
    const FeatureGrid grid({}, kCamera);
    return PredictLandmark({frame, {}, grid, kCamera, world_from_camera, options}, predicted,
                           landmark);
  }
};

TEST(PredictLandmark, InnovationSumsPositionMotionAndMeasurement) {
  Prediction p;
  const Eigen::Vector3d p_in_world = p.predicted.world_from_object * p.landmark.p_in_object;
  const Eigen::Matrix3d J = kCamera.ProjectionJacobian(p_in_world);
  const Eigen::Matrix3d R = p.predicted.world_from_object.RotationMatrix();
  const Eigen::Matrix3d position =
      J * R * p.landmark.covariance.in_object_m2 * R.transpose() * J.transpose();
  const Eigen::Matrix3d measurement = MeasurementCovariance(p.options.noise, 1.0);
  auto seen = p.Predict();
  EXPECT_LT((seen->position_px2 - position).norm(), 1e-9);
  EXPECT_LT((seen->measurement_px2 - measurement).norm(), 1e-12);
  EXPECT_LT((seen->innovation_px2 - position - measurement).norm(), 1e-9);
  p.predicted.translation_variance_m2 = 0.01;
  p.predicted.rotation_variance_rad2 = 0.04;
  seen = p.Predict();
  // The lever arm is the landmark's distance from the origin of the body.
  const double motion_m2 = 0.01 + 0.04 * p.landmark.p_in_object.squaredNorm();
  EXPECT_LT((seen->innovation_px2 - position - measurement - motion_m2 * J * J.transpose()).norm(),
            1e-9);
  EXPECT_LT((seen->position_px2 - position).norm(), 1e-9);
}

TEST(PredictLandmark, IsInvisibleOutsideTheImageAndBehindTheCamera) {
  Prediction p;
  p.world_from_camera = At(0.0, 0.0, 0.0, 3.1);
  EXPECT_FALSE(p.Predict());
  p.world_from_camera = At(6.0, 0.0, 0.0);
  EXPECT_FALSE(p.Predict());
}

TEST(PredictedCluster, AgreesUpToTheGateInPositionAndInOrientation) {
  PredictedCluster predicted;
  predicted.world_from_object = At(1.0, 0.0, 5.0, 0.3);
  predicted.translation_variance_m2 = 0.01;
  predicted.rotation_variance_rad2 = 0.04;
  const auto agrees = [&](double off_m, double off_rad) {
    return AgreesWithPrediction(predicted, At(1.0 + off_m, 0.0, 5.0, 0.3 - off_rad), 9.0);
  };
  EXPECT_TRUE(agrees(0.29, 0.59));
  EXPECT_FALSE(agrees(0.31, 0.0));
  EXPECT_FALSE(agrees(-0.31, 0.0));
  EXPECT_FALSE(agrees(0.0, 0.61));
}

// The track of a cluster with so many landmarks, last seen so many frames ago, in a frame that
// shows them turned by the angle, and so many others anywhere.
ClusterTrack TrackTurned(int landmarks, int frames_ago, double turned_rad, int wrong = 0,
                         const std::vector<Detection>& detections = {}) {
  Options options;
  options.association.max_entropy = 1.0;
  StereoFrame frame;
  Cluster cluster;
  cluster.category = "tower";
  cluster.states = {StateAt(10, At(0, 0, 5))};
  for (int i = 0; i < landmarks + wrong; ++i) {
    cluster.landmarks.push_back(MakeLandmark(i, {10}));
    Landmark& landmark = cluster.landmarks.back();
    landmark.p_in_object = {0.3 * std::cos(i), 0.3 * std::sin(i), 0.1 * (i % 3)};
    landmark.depth_m = 5.0;
    const bool is_wrong = i >= landmarks;
    StereoFeature feature;
    feature.z_px =
        *kCamera.Project(At(is_wrong ? 0.2 * i : 0.0, 0, 5, turned_rad) * landmark.p_in_object);
    frame.features.push_back(feature);
  }
  ClusterMap map;
  map.live = {cluster};
  constexpr auto kMatchInOrder = [](std::span<const PredictedLandmark> predicted,
                                    const FeatureGrid&, const TakenFeatures&,
                                    const ClusterAssociationOptions&) {
    std::vector<Match> matches;
    for (const PredictedLandmark& p : predicted) matches.push_back({p.landmark, p.landmark});
    return matches;
  };
  const auto predict = [](const Cluster& c) {
    return PredictedCluster{c.Latest().world_from_object, {}, 0.01, 0.01};
  };
  const FeatureGrid grid(frame.features, kCamera);
  TakenFeatures taken(frame.features.size(), 0);
  Rng rng(1, "test");
  const auto tracks = AssociateClusters(
      {frame, {detections, {}, {}}, grid, kCamera, {}, options}, FrameId{10 + frames_ago},
      {kMatchInOrder, &BoundedBoxes::Compute, &BoundedBoxes::Cost, true, &NoBoxRematch::Rematch},
      predict, map, rng, taken);
  return tracks[0];
}

bool IsFoundTurned(int landmarks, int frames_ago, double turned_rad, int wrong = 0) {
  return TrackTurned(landmarks, frames_ago, turned_rad, wrong).is_tracked;
}

TEST(AssociateClusters, FewMatchesAfterAGapMustAgreeWithThePrediction) {
  const int many = ClusterAssociationOptions().min_rematch;
  EXPECT_TRUE(IsFoundTurned(many - 1, 2, 0.1));
  EXPECT_FALSE(IsFoundTurned(many - 1, 2, 0.5));
  EXPECT_TRUE(IsFoundTurned(many - 1, 1, 0.5));
  EXPECT_TRUE(IsFoundTurned(many, 2, 0.5));
}

TEST(AssociateClusters, FewMatchesAfterAGapMustBeHalfOfAll) {
  const int many = ClusterAssociationOptions().min_rematch;
  EXPECT_TRUE(IsFoundTurned(many - 1, 2, 0.1, many - 1));
  EXPECT_FALSE(IsFoundTurned(many - 1, 2, 0.1, many));
  EXPECT_TRUE(IsFoundTurned(many - 1, 1, 0.1, many));
  EXPECT_TRUE(IsFoundTurned(many, 2, 0.1, many + 2));
}

TEST(AssociateClusters, AfterAGapAMinorityOfMatchesMustAgreeWithThePrediction) {
  const int many = ClusterAssociationOptions().min_rematch;
  EXPECT_TRUE(IsFoundTurned(many, 2, 0.5, many));
  EXPECT_FALSE(IsFoundTurned(many, 2, 0.5, many + 2));
  EXPECT_TRUE(IsFoundTurned(many, 1, 0.5, many + 2));
}

TEST(AssociateClusters, BoxesOfOtherClassesTakeNoVotes) {
  const auto box_among = [](const std::vector<std::string>& categories) {
    std::vector<Detection> detections;
    for (const std::string& category : categories) {
      detections.push_back({{270.0, 190.0, 370.0, 290.0}, category, 1.0});
    }
    return TrackTurned(20, 1, 0.0, 0, detections).detection;
  };
  EXPECT_EQ(box_among({"chair", "tower", "chair"}), 1);
  EXPECT_EQ(box_among({"tower", "tower", "tower"}), -1) << "undecided";
  EXPECT_EQ(box_among({"chair"}), -1);
}

TEST(RematchInBox, AClusterThatIsNotFoundKeepsItsBoxWhileItIsNewOrItsPlaceIsKnown) {
  const Options options;
  const StereoFrame frame;
  const FeatureGrid grid({}, kCamera);
  const std::vector<Detection> boxes = {{{10.0, 10.0, 50.0, 50.0}, "Crate"}};
  ShownBodies shown;
  shown.detections = boxes;
  ClusterMap map;
  map.live.resize(1);
  map.live[0].half_size_m = {0.1, 0.25, 0.2};
  TakenFeatures taken;
  Rng rng(1, "test");
  const auto keeps = [&](double deviation_m, std::size_t states = 3) {
    map.live[0].states.resize(states);
    std::vector<ClusterTrack> tracks(1);
    tracks[0].detection = 0;
    tracks[0].predicted.translation_variance_m2 = deviation_m * deviation_m;
    RematchInBox::Rematch({frame, shown, grid, kCamera, {}, options}, map, rng, taken, tracks);
    EXPECT_EQ(tracks[0].is_tracked, tracks[0].detection == 0);
    return tracks[0].is_tracked;
  };
  EXPECT_TRUE(keeps(0.399));
  EXPECT_FALSE(keeps(0.401));
  EXPECT_TRUE(keeps(0.401, 2));
}

TEST(PredictCluster, ExtrapolatesWithGrowingUncertainty) {
  const ClusterOptions options;
  const MotionPriorOptions motion;
  Cluster cluster;
  cluster.frames = 2;
  cluster.states = {StateAt(8, At(0.0, 0.0, 5.0, 0.1)),
                    StateAt(10, At(0.2, 0.0, 5.0, 0.3), {1.0, 0.0, 0.5})};
  const auto predict = [&](std::int64_t frame) {
    return PredictCluster(cluster, frame * kInterval_ns,
                          Extrapolate<WhiteNoiseOnAcceleration, ConstantMotion>, motion);
  };
  const PredictedCluster next = predict(11);
  EXPECT_LT(next.world_from_object.Minus(At(0.3, 0.0, 5.05, 0.4)).norm(), 1e-12);
  // q dt^3 / 3 + dt^2 (5 m/s / n^2)^2, n = 2.
  const double speed = 5.0 / 4.0;
  EXPECT_NEAR(next.translation_variance_m2, motion.q_m2_s3 * 1e-3 / 3.0 + 0.01 * speed * speed,
              1e-12);
  const double turn = 2.0 / 4.0;
  EXPECT_NEAR(next.rotation_variance_rad2, 0.01 * turn * turn, 1e-12);
  EXPECT_GT(predict(15).translation_variance_m2, 20.0 * next.translation_variance_m2);
  const auto held = PredictCluster(cluster, 11 * kInterval_ns,
                                   Extrapolate<WhiteNoiseOnAcceleration, HeldRotation>, motion);
  EXPECT_LT(held.world_from_object.Minus(At(0.3, 0.0, 5.05, 0.3)).norm(), 1e-12);
}

TEST(UpdateExtent, SpansTheCentralLandmarks) {
  Cluster cluster;
  UpdateExtent(cluster);
  EXPECT_TRUE(cluster.half_size_m.isZero());
  for (int i = 0; i <= 100; ++i) {
    cluster.landmarks.push_back(MakeLandmark(i, {0}));
    cluster.landmarks.back().p_in_object = {0.01 * i, 1.0, -0.02 * i};
  }
  UpdateExtent(cluster);
  EXPECT_LT((cluster.center_in_object - Eigen::Vector3d(0.5, 1.0, -1.0)).norm(), 1e-9);
  EXPECT_LT((cluster.half_size_m - Eigen::Vector3d(0.2, kMinHalfSize_m, 0.4)).norm(), 1e-9);
}

}  // namespace
}  // namespace cvo::parts_test
