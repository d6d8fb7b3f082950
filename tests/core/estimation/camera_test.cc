// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/rng.h"
#include "core/estimation/camera_solver.h"

namespace cvo::camera_test {
namespace {

const StereoCamera kCamera = {.fx = 700,
                              .fy = 700,
                              .cx = 620,
                              .cy = 187,
                              .baseline_m = 0.54,
                              .width_px = 1242,
                              .height_px = 375};

const RigidTransform kTruth(ExpSo3({0.02, -0.05, 0.01}), Eigen::Vector3d(0.4, -0.1, 1.3));

// Returns measurements of points in front of a camera at kTruth. The first `outliers` are shifted
// at random.
std::vector<PointMeasurement> Measure(int count, int outliers, double noise_px, Rng& rng) {
  std::vector<PointMeasurement> measurements;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d p_in_camera(rng.Uniform(-8, 8), rng.Uniform(-2, 2), rng.Uniform(5, 40));
    Eigen::Vector3d z = *kCamera.Project(p_in_camera);
    for (int k = 0; k < 3; ++k) z[k] += noise_px * rng.Normal();
    if (i < outliers) z += Eigen::Vector3d(rng.Uniform(20, 80), rng.Uniform(-40, 40), 30.0);
    measurements.push_back({kTruth * p_in_camera, z, Eigen::Matrix3d::Identity()});
  }
  return measurements;
}

TEST(SolveCamera, RejectsThirtyPercentOfOutliers) {
  Rng rng(2, "camera");
  const auto solution = SolveCamera(kCamera, Measure(200, 60, 0.0, rng), RigidTransform(), {});
  EXPECT_LT(kTruth.Minus(solution.world_from_camera).norm(), 1e-6);
  EXPECT_EQ(solution.inliers, 140);
  for (int i = 0; i < 60; ++i) EXPECT_FALSE(solution.is_inlier[i]);
}

std::optional<CameraSolution> SolveInCubes(const std::vector<PointMeasurement>& measurements,
                                           int iterations, int min_inliers, Rng& rng) {
  return SolveCameraRansac(kCamera, measurements, {}, CubesOf(kCamera, measurements), iterations,
                           min_inliers, rng);
}

TEST(SolveCameraRansac, FindsTheCameraAmongSixtyPercentOfOutliers) {
  Rng rng(3, "ransac");
  const auto measurements = Measure(150, 90, 0.3, rng);
  const auto solution = SolveInCubes(measurements, 300, 20, rng);
  ASSERT_TRUE(solution);
  EXPECT_LT(kTruth.Minus(solution->world_from_camera).norm(), 0.02);
  EXPECT_GE(solution->inliers, 55);
}

// A vehicle ahead that moves with the camera, has twice as many points as the scene, and covers
// more of the image.
std::vector<PointMeasurement> MeasureBehindVehicle(Rng& rng) {
  std::vector<PointMeasurement> measurements = Measure(100, 0, 0.3, rng);
  const RigidTransform other =
      kTruth * RigidTransform(Eigen::Quaterniond::Identity(), Eigen::Vector3d(0.0, 0.0, -0.8));
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d p_in_camera(rng.Uniform(-1.5, 1.5), rng.Uniform(-1, 1),
                                      rng.Uniform(4, 4.3));
    measurements.push_back(
        {other * p_in_camera, *kCamera.Project(p_in_camera), Eigen::Matrix3d::Identity()});
  }
  return measurements;
}

TEST(SolveCameraRansac, PrefersInliersThatCoverMoreOfSpace) {
  Rng rng(6, "ransac");
  const auto measurements = MeasureBehindVehicle(rng);
  const auto solution = SolveInCubes(measurements, 300, 20, rng);
  ASSERT_TRUE(solution);
  EXPECT_LT(kTruth.Minus(solution->world_from_camera).norm(), 0.02);
}

TEST(RefineCamera, IsNotDrawnToTheMotionOfMostPoints) {
  Rng rng(6, "camera");
  const auto measurements = MeasureBehindVehicle(rng);
  const RigidTransform near =
      kTruth * RigidTransform(Eigen::Quaterniond::Identity(), Eigen::Vector3d(0.0, 0.0, 0.02));
  EXPECT_GT(kTruth.Minus(SolveCamera(kCamera, measurements, near, {}).world_from_camera).norm(),
            0.5);
  EXPECT_LT(kTruth.Minus(RefineCamera(kCamera, measurements, near, {}).world_from_camera).norm(),
            0.02);
}

TEST(SolveCameraRansac, FindsNothingWithoutAgreement) {
  Rng rng(4, "ransac");
  EXPECT_FALSE(SolveInCubes(Measure(60, 60, 0.3, rng), 300, 20, rng));
  EXPECT_FALSE(SolveInCubes(Measure(2, 0, 0.3, rng), 300, 3, rng));
}

TEST(SolveCamera, IgnoresPointsBehindTheCamera) {
  Rng rng(6, "camera");
  std::vector<PointMeasurement> measurements = Measure(30, 0, 0.0, rng);
  PointMeasurement behind = measurements[0];
  behind.p_in_world = kTruth * Eigen::Vector3d(1.0, 0.0, -5.0);
  measurements.insert(measurements.begin(), behind);
  const auto solution = SolveCamera(kCamera, measurements, RigidTransform(), {});
  EXPECT_LT(kTruth.Minus(solution.world_from_camera).norm(), 1e-9);
  EXPECT_EQ(solution.inliers, 30);
  EXPECT_FALSE(solution.is_inlier[0]);
}

// Measurements with a hundredfold standard deviation must have little influence.
TEST(SolveCamera, WeightsMeasurementsByTheirInformation) {
  Rng rng(7, "camera");
  std::vector<PointMeasurement> measurements = Measure(20, 0, 0.0, rng);
  const std::vector<PointMeasurement> sure = measurements;
  for (const PointMeasurement& m : sure) {
    measurements.push_back(m);
    measurements.back().z_px += Eigen::Vector3d(1.0, 0.0, 1.0);
    measurements.back().sqrt_information *= 0.01;
  }
  const auto solution = SolveCamera(kCamera, measurements, kTruth, {});
  EXPECT_LT(kTruth.Minus(solution.world_from_camera).norm(), 1e-4);
  for (PointMeasurement& m : measurements) m.sqrt_information.setIdentity();
  EXPECT_GT(kTruth.Minus(SolveCamera(kCamera, measurements, kTruth, {}).world_from_camera).norm(),
            2e-4);
}

// A measurement without a disparity cannot be triangulated.
TEST(SolveCameraRansac, DoesNotSampleMeasurementsWithoutDisparity) {
  Rng rng(9, "ransac");
  std::vector<PointMeasurement> measurements = Measure(40, 0, 0.0, rng);
  for (std::size_t i = 0; i < 20; ++i) measurements[i].z_px[2] = measurements[i].z_px[0] + 1.0;
  const auto solution = SolveInCubes(measurements, 100, 20, rng);
  ASSERT_TRUE(solution);
  EXPECT_EQ(solution->inliers, 20);
  EXPECT_LT(kTruth.Minus(solution->world_from_camera).norm(), 1e-6);
  for (PointMeasurement& m : measurements) m.z_px[2] = m.z_px[0] + 1.0;
  EXPECT_FALSE(SolveInCubes(measurements, 100, 3, rng));
}

}  // namespace
}  // namespace cvo::camera_test
