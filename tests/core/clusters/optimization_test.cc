// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "core/base/rng.h"
#include "core/clusters/cluster_map.h"
#include "core/clusters/cluster_optimization.h"
#include "core/solvers/motion_prior.h"
#include "tests/core/clusters/small_windows.h"

namespace cvo::optimization_test {
namespace {

using test::At;
using test::kCamera;
using test::MakeLandmark;
using test::StateAt;
using test::WindowOf;
using testing::SizeIs;

// Tests the optimisation of clusters, and the information that remains of observations that leave
// the window.

// A rotated body with one landmark, observed in frames 0 and 1. Frame 0 is leaving the window.
struct Absorption {
  Window window = WindowOf(1, 2);
  WindowFrame leaving{FrameId{0}, At(0.2, 0.1, 0.3, 0.1), false};
  Cluster cluster;
  ClusterOptions options;

  Absorption() {
    cluster.states = {StateAt(0, At(1.0, 0.5, 8.0, 0.7)), StateAt(1, At(1.1, 0.5, 8.0, 0.8))};
    cluster.landmarks = {MakeLandmark(0, {0, 1})};
    cluster.landmarks[0].p_in_object = {0.3, -0.2, 0.4};
    cluster.landmarks[0].observations[0].octave = 2;
    cluster.landmarks[0].observations[0].z_px = Project(cluster.landmarks[0].p_in_object);
  }
  // Projects a point of the body into the leaving frame.
  Eigen::Vector3d Project(const Eigen::Vector3d& p_in_object) const {
    return *kCamera.Project(leaving.world_from_camera.Inverse() *
                            (cluster.states[0].world_from_object * p_in_object));
  }
  void Absorb() { AbsorbObservations(window, leaving, {{}, 1.2}, options, cluster); }
  const Landmark& landmark() const { return cluster.landmarks[0]; }
};

TEST(AbsorbObservations, InformationIsThatOfTheReprojectionError) {
  Absorption a;
  a.Absorb();
  EXPECT_THAT(a.landmark().observations, SizeIs(1));
  EXPECT_EQ(a.landmark().observations[0].frame, FrameId{1});
  // J, by central differences of the projection of a point of the body.
  Eigen::Matrix3d J;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d step = 1e-5 * Eigen::Vector3d::Unit(k);
    J.col(k) =
        (a.Project(a.landmark().p_in_object + step) - a.Project(a.landmark().p_in_object - step)) /
        2e-5;
  }
  const Eigen::Matrix3d expected =
      J.transpose() *
      MeasurementCovariance({.disparity_px = NoiseOptions().least_disparity_px}, 1.2 * 1.2)
          .inverse() *
      J;
  EXPECT_LT((a.landmark().past_information - expected).norm(), 1e-6 * expected.norm());
}

TEST(AbsorbObservations, MeanIsWhereTheObservationsPlaceThePoint) {
  Absorption a;
  Landmark& landmark = a.cluster.landmarks[0];
  const Eigen::Vector3d truth = landmark.p_in_object + Eigen::Vector3d(1e-3, -1e-3, 2e-3);
  landmark.observations[0].z_px = a.Project(truth);
  a.Absorb();
  EXPECT_LT((landmark.past_mean_in_object - truth).norm(), 1e-5);
  // Later changes of the estimate do not shift the remembered mean.
  landmark.p_in_object += Eigen::Vector3d(5e-3, 0.0, 0.0);
  landmark.observations.insert(landmark.observations.begin(), {FrameId{0}, a.Project(truth), 2});
  a.Absorb();
  EXPECT_LT((landmark.past_mean_in_object - truth).norm(), 5e-5);
}

TEST(AbsorbObservations, ErrorsBeyondTheRobustThresholdAreDownweighted) {
  Absorption a;
  a.Absorb();
  Absorption b;
  b.cluster.landmarks[0].observations[0].z_px[0] += 30.0;
  b.Absorb();
  EXPECT_LT(b.landmark().past_information.norm(), 0.5 * a.landmark().past_information.norm());
}

TEST(AbsorbObservations, ForgetsThemIfAskedTo) {
  Absorption a;
  a.options.max_past_observations = 0.0;
  a.Absorb();
  EXPECT_TRUE(a.landmark().past_information.isZero());
}

TEST(AbsorbObservations, PastInformationIsBounded) {
  Absorption a;
  a.options.max_past_observations = 10.0;
  a.Absorb();
  const Eigen::Matrix3d one = a.landmark().past_information;
  for (int k = 0; k < 500; ++k) {
    a.cluster.landmarks[0].observations.insert(
        a.cluster.landmarks[0].observations.begin(),
        {FrameId{0}, a.Project(a.landmark().p_in_object), 2});
    a.Absorb();
    EXPECT_LE(a.landmark().past_information.norm(), 10.0 * one.norm() * (1.0 + 1e-12));
  }
  EXPECT_NEAR(a.landmark().past_information.norm(), 10.0 * one.norm(), 1e-6 * one.norm());
}

// Tests the landmark certainty of a body that is observed for a long time.

constexpr int kPoints = 30;
constexpr double kNoise_px = 0.5;

// A body that rotates slowly in front of a static camera. Its points are measured with noise in
// every frame; T_t has 15 frames.
class LongStay {
 public:
  explicit LongStay(std::uint64_t seed) : rng_(seed, "stay") {
    options_.noise.corner_px = kNoise_px;
    options_.noise.disparity_px = kNoise_px;
    options_.noise.disagreement = 0.0;  // equal noise for all disparities
    window_.camera = {450.0, 450.0, 320.0, 240.0, 0.3, 640, 480};
    for (int i = 0; i < kPoints; ++i) {
      truth_.emplace_back(rng_.Uniform(-0.4, 0.4), rng_.Uniform(-0.4, 0.4),
                          rng_.Uniform(-0.2, 0.2));
    }
    map_.live.resize(1);
    map_.live[0].id = ClusterId{1};
  }

  // If `forgets_mean`, the mean of the past information is moved to the current landmark estimate
  // before every solve, as if the past had measured it.
  void Watch(int frames, bool forgets_mean) {
    for (int f = 0; f < frames; ++f) {
      AddFrame(f);
      for (Landmark& landmark : map_.live[0].landmarks) {
        if (forgets_mean) landmark.past_mean_in_object = landmark.p_in_object;
      }
      OptimizeClusters(options_, test::kOurEnergy, window_, pool_, map_);
    }
  }

  // Returns the mean normalised estimation error squared of the landmarks, 3 for a consistent
  // covariance. It is computed after the best rigid alignment with the truth, which takes 6 of the
  // 3 n degrees of freedom.
  double MeanNees() {
    for (const WindowFrame& frame : window_.temporal) Absorb(frame);
    Eigen::Matrix3Xd estimate(3, kPoints);
    Eigen::Matrix3Xd truth(3, kPoints);
    for (int i = 0; i < kPoints; ++i) {
      estimate.col(i) = map_.live[0].landmarks[i].p_in_object;
      truth.col(i) = truth_[i];
    }
    const Eigen::Matrix4d T = Eigen::umeyama(truth, estimate, false);
    double sum = 0.0;
    for (int i = 0; i < kPoints; ++i) {
      const Eigen::Vector3d e =
          estimate.col(i) - T.topLeftCorner<3, 3>() * truth_[i] - T.topRightCorner<3, 1>();
      sum += e.dot(map_.live[0].landmarks[i].past_information * e);
    }
    return sum / (kPoints - 2);
  }

 private:
  static RigidTransform Pose(int frame) {
    return {ExpSo3({0.0, 0.002 * frame, 0.0}), Eigen::Vector3d(0.1, 0.0, 4.0)};
  }

  void Absorb(const WindowFrame& frame) {
    AbsorbObservations(window_, frame, options_.NoiseOfFeatures(), options_.clusters, map_.live[0]);
  }

  void AddFrame(int f) {
    Cluster& cluster = map_.live[0];
    const FrameId id{f};
    window_.temporal.push_back({id, {}, false});
    const RigidTransform pose = f < 2 ? Pose(f) : cluster.Latest().world_from_object;
    cluster.states.push_back({id, f * 33'000'000LL, pose, Eigen::Vector3d::Zero()});
    cluster.last_observed = id;
    for (int i = 0; i < kPoints; ++i) {
      const double corner_px = kNoise_px * rng_.Normal();
      const Eigen::Vector3d noise_px(corner_px, kNoise_px * rng_.Normal(),
                                     corner_px + kNoise_px * rng_.Normal());
      const Eigen::Vector3d z_px = *window_.camera.Project(Pose(f) * truth_[i]) + noise_px;
      if (f == 0) {
        cluster.landmarks.emplace_back();
        cluster.landmarks[i].id = LandmarkId{i};
        cluster.landmarks[i].p_in_object = pose.Inverse() * *window_.camera.BackProject(z_px);
      }
      cluster.landmarks[i].observations.push_back({id, z_px, 0});
      cluster.landmarks[i].last_seen = id;
    }
    if (window_.temporal.size() <= 15) return;
    const WindowFrame leaving = window_.temporal.front();
    window_.temporal.erase(window_.temporal.begin());
    Absorb(leaving);
    TrimCluster(window_, id, options_.clusters, cluster);
  }

  Rng rng_;
  Options options_;
  TaskPool pool_{1};
  Window window_;
  ClusterMap map_;
  std::vector<Eigen::Vector3d> truth_;
};

double MeanNees(bool forgets_mean) {
  double sum = 0.0;
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    LongStay stay(seed);
    stay.Watch(80, forgets_mean);
    sum += stay.MeanNees() / 2.0;
  }
  return sum;
}

// Treating poses as exact makes the covariance overconfident, the bound on past observations makes
// it conservative.
TEST(PastInformation, LandmarkCovarianceIsConsistentAfterALongStay) {
  const double kept = MeanNees(false);
  EXPECT_GT(kept, 0.5);
  EXPECT_LT(kept, 3.5);
  EXPECT_GT(MeanNees(true), 2.0 * kept);
}

constexpr std::int64_t kFrames = 5;

// A body that moves 5 cm to the right per frame in front of a static camera. Its twelve points are
// observed in every frame without noise. All states start at the truth, except the pose in the last
// frame, which is off by 3 cm.
struct Moving {
  Options options;
  TaskPool pool{1};
  Window window;
  ClusterMap map;

  Moving() {
    window.camera = {450.0, 450.0, 320.0, 240.0, 0.3, 640, 480};
    Cluster cluster;
    cluster.id = ClusterId{1};
    for (int i = 0; i < 12; ++i) {
      Landmark landmark;
      landmark.id = LandmarkId{i};
      landmark.p_in_object = {0.2 * (i % 4) - 0.3, 0.2 * (i / 4) - 0.2, 0.1 * (i % 3)};
      cluster.landmarks.push_back(landmark);
    }
    for (std::int64_t f = 0; f < kFrames; ++f) {
      window.temporal.push_back({FrameId{f}, {}, false});
      cluster.states.push_back(
          {FrameId{f}, f * 100'000'000, Truth(f), Eigen::Vector3d(0.5, 0.0, 0.0)});
      for (Landmark& landmark : cluster.landmarks) {
        const auto z_px = window.camera.Project(Truth(f) * landmark.p_in_object);
        landmark.observations.push_back({FrameId{f}, *z_px, 0});
      }
    }
    cluster.states.back().world_from_object = Truth(kFrames - 1) * At(0.03);
    cluster.last_observed = FrameId{kFrames - 1};
    map.live.push_back(cluster);
  }

  static RigidTransform At(double x) {
    return {Eigen::Quaterniond::Identity(), Eigen::Vector3d(x, 0.0, 0.0)};
  }
  static RigidTransform Truth(std::int64_t frame) {
    return {Eigen::Quaterniond::Identity(),
            Eigen::Vector3d(0.05 * static_cast<double>(frame), 0.0, 4.0)};
  }
  double LastError_m() const {
    const RigidTransform& pose = map.live[0].Latest().world_from_object;
    return (pose.translation() - Truth(kFrames - 1).translation()).norm();
  }
  void Optimize() { OptimizeClusters(options, test::kOurEnergy, window, pool, map); }
};

TEST(OptimizeClusters, RemovesOutliersOfTheLastFrame) {
  Moving body;
  for (int i = 0; i < 4; ++i) {
    body.map.live[0].landmarks[i].observations.back().z_px += Eigen::Vector3d(12.0, 0.0, 12.0);
  }
  body.Optimize();
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(FindObservation(body.map.live[0].landmarks[i], FrameId{kFrames - 1}), nullptr) << i;
  }
  body.Optimize();  // with Huber's loss alone they would still have an influence
  EXPECT_LT(body.LastError_m(), 1e-4);
}

TEST(OptimizeClusters, AWrongFirstPoseOfAYoungBodyMovesInsteadOfItsLandmarks) {
  constexpr double kError_m = 0.005;
  for (const bool is_young : {true, false}) {
    Moving body;
    Cluster& cluster = body.map.live[0];
    cluster.states.back().world_from_object = Moving::Truth(kFrames - 1);
    cluster.states.front().world_from_object = Moving::Truth(0) * Moving::At(kError_m);
    ClusterPose first;
    first.frame = is_young ? 0 : -1;
    body.map.trajectories[cluster.id].poses.push_back(first);
    const Eigen::Vector3d before = cluster.landmarks[0].p_in_object;
    for (int i = 0; i < 10; ++i) body.Optimize();
    EXPECT_NEAR(before.x() - cluster.landmarks[0].p_in_object.x(), is_young ? 0.0 : kError_m, 1e-4);
  }
}

}  // namespace
}  // namespace cvo::optimization_test
