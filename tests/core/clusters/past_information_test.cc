// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests the landmark certainty of a body that is observed for a long time.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/base/rng.h"
#include "core/clusters/cluster_optimization.h"
#include "core/solvers/motion_prior.h"

namespace cvo::past_information_test {
namespace {

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
      OptimizeClusters<WhiteNoiseOnAcceleration, RemoveOutliers, OwnSchur>(
          {options_.NoiseOfFeatures(), options_.solver, options_.motion_prior}, window_, pool_,
          map_);
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

}  // namespace
}  // namespace cvo::past_information_test
