// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "core/base/task_pool.h"
#include "core/geometry/stereo_camera.h"
#include "core/interface/frame.h"
#include "core/odometry/camera_tracking.h"
#include "tests/support/estimator_inputs.h"
#include "variants/all.h"
#include "variants/registry.h"

namespace cvo::odometry_test {
namespace {

// A static world of points with distinct descriptors. Produces stereo frames without images, to
// test everything downstream of the front end.
class FeatureWorld {
 public:
  // Creates points around the path of a camera that drives along z.
  explicit FeatureWorld(std::uint64_t seed, int points = 3000) : rng_(seed, "feature world") {
    for (int i = 0; i < points; ++i) {
      points_.emplace_back(rng_.Uniform(-8.0, 8.0), rng_.Uniform(-3.0, 3.0),
                           rng_.Uniform(3.0, 60.0));
      descriptors_.push_back(test::RandomDescriptor(rng_));
    }
  }

  const StereoCamera& camera() const { return camera_; }
  const std::vector<Eigen::Vector3d>& points() const { return points_; }

  // Returns world_from_camera: speed_m forward per frame, on a gentle curve.
  static RigidTransform CameraAt(int frame, double speed_m = 0.3) {
    const double turn = 0.004 * frame;
    return {ExpSo3({0.0, turn, 0.0}),
            Eigen::Vector3d(0.5 * turn * speed_m * frame, 0.0, speed_m * frame)};
  }

  // Returns at most 500 features. The standard deviation of corners is noise_px, that of
  // disparities half of it.
  StereoFrame Observe(const RigidTransform& world_from_camera, std::int64_t timestamp_ns,
                      double noise_px) {
    StereoFrame frame;
    frame.timestamp_ns = timestamp_ns;
    const RigidTransform camera_from_world = world_from_camera.Inverse();
    for (std::size_t i = 0; i < points_.size() && frame.features.size() < 500; ++i) {
      const Eigen::Vector3d p_in_camera = camera_from_world * points_[i];
      const auto z = camera_.Project(p_in_camera);
      if (!z || p_in_camera.z() > 30.0 || !camera_.InImage((*z)[0], (*z)[1])) continue;
      const double du = noise_px * rng_.Normal();
      const Eigen::Vector3d noise(du, noise_px * rng_.Normal(),
                                  du + 0.5 * noise_px * rng_.Normal());
      StereoFeature feature;
      feature.z_px = *z + noise;
      feature.disagreement_px = test::DisagreementOf(0.5 * noise_px);
      feature.descriptor = descriptors_[i];
      frame.features.push_back(feature);
    }
    return frame;
  }

 private:
  Rng rng_;
  StereoCamera camera_ = test::kFeatureCamera;
  std::vector<Eigen::Vector3d> points_;
  std::vector<Descriptor> descriptors_;
};

struct MisspeltAxis : Full {
  using BoxRematches = NoBoxRematch;
};

TEST(Axes, AblationsChangeTheStatedAxes) {
  EXPECT_EQ((CountDifferences<Full, Full>()), 0);
  EXPECT_EQ((CountDifferences<Full, MisspeltAxis>()), 0);
  EXPECT_EQ((CountDifferences<Full, Only2d>()), 2);
  EXPECT_EQ((CountDifferences<Static, Only2d>()), 3);
}

TEST(MaskDetections, FeaturesInBoxesLoseTheirDisparity) {
  StereoFrame frame;
  frame.features.resize(2);
  frame.features[0].z_px = {50.0, 50.0, 40.0};
  frame.features[1].z_px = {150.0, 50.0, 140.0};
  frame.detections = {{{0.0, 0.0, 100.0, 100.0}, "Car"}};
  EXPECT_TRUE(MaskDetections::Show(frame).detections.empty());
  EXPECT_TRUE(IsLeftOnly(frame.features[0]));
  EXPECT_FALSE(IsLeftOnly(frame.features[1]));
}

constexpr std::int64_t kInterval_ns = 100'000'000;

// The output of a variant for the frames of a world.
struct WorldRun {
  std::vector<FrameReport> reports;
  std::vector<RigidTransform> trajectory;
};

std::unique_ptr<Odometry> MakeOdometry(std::string_view variant, const FeatureWorld& world,
                                       TaskPool& pool, std::uint64_t seed = 0) {
  const VariantInfo& info = FindVariant(variant);
  return info.make({world.camera(), info.defaults(), seed}, pool);
}

template <typename Change>
WorldRun RunWorld(std::string_view variant, int frames, double noise_px, Change change,
                  std::uint64_t seed = 0) {
  FeatureWorld world(7);
  TaskPool pool(1);
  const auto odometry = MakeOdometry(variant, world, pool, seed);
  WorldRun run;
  StageTimes times;
  for (int i = 0; i < frames; ++i) {
    StereoFrame frame = world.Observe(FeatureWorld::CameraAt(i), i * kInterval_ns, noise_px);
    change(i, frame);
    run.reports.push_back(odometry->Process(frame, times));
  }
  run.trajectory = odometry->Trajectory();
  return run;
}

const auto kUnchanged = [](int, StereoFrame&) {};

double PositionError(const RigidTransform& estimate, int frame) {
  return (estimate.translation() - FeatureWorld::CameraAt(frame).translation()).norm();
}

class EveryVariant : public testing::TestWithParam<std::string_view> {};

std::vector<std::string_view> VariantNames() {
  std::vector<std::string_view> names;
  for (const VariantInfo& variant : NamedVariantInfos()) names.push_back(variant.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Odometry, EveryVariant, testing::ValuesIn(VariantNames()),
                         [](const auto& variant) { return std::string(variant.param); });

TEST_P(EveryVariant, FollowsANoiseFreeCameraExactly) {
  const WorldRun run = RunWorld(GetParam(), 40, 0.0, kUnchanged);
  for (int i = 0; i < 40; ++i) {
    EXPECT_EQ(run.reports[i].status, i == 0 ? FrameStatus::kFirst : FrameStatus::kTracked);
    EXPECT_LT(PositionError(run.trajectory[i], i), 1e-4) << "frame " << i;
  }
}

TEST_P(EveryVariant, StaysNearTheTruthUnderPixelNoise) {
  const WorldRun run = RunWorld(GetParam(), 60, 0.5, kUnchanged);
  // 0.3 % of the 18 m driven, the drift to expect from half a pixel of noise on 500 features.
  EXPECT_LT(PositionError(run.trajectory.back(), 59), 0.054);
}

TEST_P(EveryVariant, KeepsTheWindowWithinItsSize) {
  const WorldRun run = RunWorld(GetParam(), 60, 0.3, kUnchanged);
  const WindowOptions defaults = FindVariant(GetParam()).defaults().window;
  for (const FrameReport& report : run.reports) {
    EXPECT_LE(report.window_frames, defaults.spatial + defaults.temporal);
    EXPECT_LE(report.spatial_ages.size(), static_cast<std::size_t>(defaults.spatial));
    for (const int age : report.spatial_ages) EXPECT_GE(age, defaults.temporal);
  }
  EXPECT_GE(run.reports.back().window_frames, defaults.temporal);
}

TEST_P(EveryVariant, BridgesLostFramesAndRecovers) {
  const auto blind = [](int i, StereoFrame& frame) {
    if (i >= 20 && i < 23) frame.features.clear();
  };
  const WorldRun run = RunWorld(GetParam(), 30, 0.3, blind);
  for (int i = 20; i < 23; ++i) EXPECT_EQ(run.reports[i].status, FrameStatus::kLost);
  EXPECT_EQ(run.reports[23].status, FrameStatus::kRecovered);
  EXPECT_EQ(run.reports[24].status, FrameStatus::kTracked);
  EXPECT_LT(PositionError(run.trajectory[29], 29), 0.05);
  // While lost, the camera is predicted from its velocity.
  EXPECT_LT(PositionError(run.trajectory[21], 21), 0.1);
}

TEST_P(EveryVariant, RestartsAtThePredictedCameraInAnUnknownPlace) {
  const auto move = [](int i, StereoFrame& frame) {
    if (i < 10) return;
    for (StereoFeature& feature : frame.features) {
      for (std::uint64_t& word : feature.descriptor) word = ~word;
    }
  };
  const WorldRun run = RunWorld(GetParam(), 24, 0.3, move);
  const int restart = 10 + TrackingOptions().restart_after;
  for (int i = 10; i < restart; ++i) EXPECT_EQ(run.reports[i].status, FrameStatus::kLost);
  EXPECT_EQ(run.reports[restart].status, FrameStatus::kFirst);
  EXPECT_EQ(run.reports[restart + 1].status, FrameStatus::kTracked);
  EXPECT_LT(PositionError(run.trajectory[restart], restart), 0.5);
  EXPECT_LT(PositionError(run.trajectory[23], 23), 1.0);
}

// The rest of the scene is far away, so that a small rotation without translation explains it
// almost as well, and most of the matches agree with that.
TEST(CameraTracking, IgnoresANearBodyThatStartsToMoveWithTheCamera) {
  constexpr int kStart = 20;
  constexpr double kSpeed_m = 0.05;
  FeatureWorld world(7);
  Rng rng(3, "near body");
  std::vector<Eigen::Vector3d> body;  // in the camera frame of kStart
  std::vector<Descriptor> descriptors(120);
  for (Descriptor& descriptor : descriptors) {
    body.emplace_back(rng.Uniform(0.2, 0.8), rng.Uniform(-0.3, 0.3), rng.Uniform(2.6, 2.9));
    descriptor = test::RandomDescriptor(rng);
  }
  const auto camera = [](int i) {
    return RigidTransform(Eigen::Quaterniond::Identity(), Eigen::Vector3d(kSpeed_m * i, 0, 0));
  };
  TaskPool pool(1);
  const auto odometry = MakeOdometry("static", world, pool);
  StageTimes times;
  for (int i = 0; i < kStart + 5; ++i) {
    StereoFrame frame = world.Observe(camera(i), i * kInterval_ns, 0.3);
    std::erase_if(frame.features, [&](const StereoFeature& feature) {
      return world.camera().fx * world.camera().baseline_m / (feature.z_px[0] - feature.z_px[2]) <
             10;
    });
    const RigidTransform here_from_start = camera(std::min(i, kStart)).Inverse() * camera(kStart);
    for (std::size_t k = 0; k < body.size(); ++k) {
      const auto z = world.camera().Project(here_from_start * body[k]);
      if (!z) continue;
      StereoFeature feature;
      feature.z_px = *z;
      feature.disagreement_px = test::DisagreementOf(0.15);
      feature.descriptor = descriptors[k];
      frame.features.push_back(feature);
    }
    odometry->Process(frame, times);
  }
  for (int i = 0; i < kStart + 5; ++i) {
    EXPECT_LT((odometry->Trajectory()[i].translation() - camera(i).translation()).norm(), 0.02)
        << "frame " << i;
  }
}

TEST_P(EveryVariant, RecoversAfterAnUnpredictableJump) {
  FeatureWorld world(7);
  TaskPool pool(1);
  const auto odometry = MakeOdometry(GetParam(), world, pool);
  StageTimes times;
  for (int i = 0; i < 10; ++i) {
    odometry->Process(world.Observe(FeatureWorld::CameraAt(i), i * kInterval_ns, 0.3), times);
  }
  const RigidTransform jumped =
      FeatureWorld::CameraAt(10) *
      RigidTransform(ExpSo3({0.0, 0.25, 0.0}), Eigen::Vector3d(0.8, 0.1, 0.5));
  const FrameReport report =
      odometry->Process(world.Observe(jumped, 10 * kInterval_ns, 0.3), times);
  EXPECT_EQ(report.status, FrameStatus::kTracked);
  EXPECT_LT((report.world_from_camera.translation() - jumped.translation()).norm(), 0.05);
}

TEST_P(EveryVariant, RefusesARepeatedTimestamp) {
  FeatureWorld world(7);
  TaskPool pool(1);
  const auto odometry = MakeOdometry(GetParam(), world, pool);
  StageTimes times;
  const StereoFrame frame = world.Observe(FeatureWorld::CameraAt(0), 0, 0.1);
  odometry->Process(frame, times);
  EXPECT_THROW(odometry->Process(frame, times), Error);
}

TEST_P(EveryVariant, IgnoresAMovingBody) {
  // A third of the features belong to an object that slides sideways.
  const auto sliding = [](int i, StereoFrame& frame) {
    for (std::size_t k = 0; k < frame.features.size(); k += 3) {
      frame.features[k].z_px += Eigen::Vector3d(6.0 * i, 0.0, 6.0 * i);
    }
  };
  const WorldRun run = RunWorld(GetParam(), 20, 0.3, sliding);
  EXPECT_LT(PositionError(run.trajectory.back(), 19), 0.05);
}

TEST_P(EveryVariant, IgnoresTheMotionOfAVehicleAhead) {
  // It has as many features as the scene, covers less than a tenth of the image and moves at the
  // speed of the camera.
  FeatureWorld world(7);
  TaskPool pool(1);
  const auto odometry = MakeOdometry(GetParam(), world, pool);
  Rng rng(3, "vehicle");
  std::vector<StereoFeature> vehicle(500);
  for (StereoFeature& feature : vehicle) {
    const double u_px = rng.Uniform(240.0, 400.0);
    feature.z_px = {u_px, rng.Uniform(180.0, 330.0), u_px - 30.0};
    feature.disagreement_px = test::DisagreementOf(0.1);
    feature.descriptor = test::RandomDescriptor(rng);
  }
  StageTimes times;
  for (int i = 0; i < 10; ++i) {
    const RigidTransform truth = FeatureWorld::CameraAt(i, 0.8);
    StereoFrame frame = world.Observe(truth, i * kInterval_ns, 0.2);
    frame.features.insert(frame.features.end(), vehicle.begin(), vehicle.end());
    const FrameReport report = odometry->Process(frame, times);
    EXPECT_LT((report.world_from_camera.translation() - truth.translation()).norm(), 0.1)
        << "frame " << i;
  }
}

TEST(MotionModel, ExtrapolatesATurnOverAnyInterval) {
  const RigidTransform step(ExpSo3({0.0, 0.1, 0.0}), Eigen::Vector3d(0.0, 0.0, 1.0));
  MotionModel model;
  model.Update(0, RigidTransform());
  model.Update(kInterval_ns, step);
  EXPECT_LT((step * step).Minus(model.Predict(2 * kInterval_ns)).norm(), 1e-12);
  const RigidTransform half(ExpSo3({0.0, 0.05, 0.0}), Eigen::Vector3d(0.0, 0.0, 0.5));
  EXPECT_LT((step * half).Minus(model.Predict(3 * kInterval_ns / 2)).norm(), 1e-12);
}

TEST(Variants, UnknownNameListsTheKnownOnes) {
  try {
    FindVariant("statik");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("statik"));
    EXPECT_THAT(error.what(), testing::HasSubstr("one of: full, paper, "));
  }
}

}  // namespace
}  // namespace cvo::odometry_test
