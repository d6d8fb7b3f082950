// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/stereo_camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <string>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "tests/support/gradient_check.h"

namespace cvo {
namespace {

using testing::HasSubstr;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// fx and fy differ, so that mixing them up is detected.
StereoCamera Camera() {
  StereoCamera camera;
  camera.fx = 720.0;
  camera.fy = 710.0;
  camera.cx = 609.5;
  camera.cy = 172.8;
  camera.baseline_m = 0.54;
  camera.width_px = 1242;
  camera.height_px = 375;
  return camera;
}

Eigen::Vector3d RandomPoint(Rng& rng) {
  const double z = rng.Uniform(1.0, 60.0);
  return {z * rng.Uniform(-0.8, 0.8), z * rng.Uniform(-0.3, 0.3), z};
}

TEST(StereoCamera, ProjectMatchesHandComputedValues) {
  const auto z_px = Camera().Project({1.0, -2.0, 10.0});
  ASSERT_TRUE(z_px.has_value());
  EXPECT_NEAR((*z_px)[0], 720.0 * 0.1 + 609.5, 1e-12);
  EXPECT_NEAR((*z_px)[1], 710.0 * -0.2 + 172.8, 1e-12);
  EXPECT_NEAR((*z_px)[2], 720.0 * 0.046 + 609.5, 1e-12);
}

TEST(StereoCamera, BackProjectUndoesProject) {
  Rng rng(1, "round trip");
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d p = RandomPoint(rng);
    const auto z_px = Camera().Project(p);
    ASSERT_TRUE(z_px.has_value());
    const auto back = Camera().BackProject(*z_px);
    ASSERT_TRUE(back.has_value());
    EXPECT_LT((*back - p).norm(), 1e-11 * p.norm());
  }
}

TEST(StereoCamera, RightShiftMovesTheRightColumnAndIsUndone) {
  StereoCamera camera = Camera();
  const Eigen::Vector3d p(1.0, -2.0, 10.0);
  const Eigen::Vector3d perfect = camera.Project(p).value();
  camera.right_shift_px = 0.25;
  const Eigen::Vector3d seen = camera.Project(p).value();
  EXPECT_LT((seen - perfect - Eigen::Vector3d(0.0, 0.0, 0.25)).norm(), 1e-12);
  EXPECT_NEAR(camera.Disparity(seen), perfect[0] - perfect[2], 1e-12);
  EXPECT_LT((camera.BackProject(seen).value() - p).norm(), 1e-11);
}

TEST(StereoCamera, RightFieldVariesOverTheImageAndIsUndone) {
  Rng rng(5, "field");
  StereoCamera camera = Camera();
  const Eigen::Vector3d perfect = camera.Project({1.0, -2.0, 10.0}).value();
  camera.right_field_px << 0.3, -20.0, 10.0, 30.0, -10.0, 20.0;
  const double x = 2.0 * (perfect[0] + 0.5) / camera.width_px - 1.0;
  const double y = 2.0 * (perfect[1] + 0.5) / camera.height_px - 1.0;
  const double shift = 0.3 - 20.0 * x + 10.0 * y + 30.0 * (x * x - 1.0 / 3.0) - 10.0 * x * y +
                       20.0 * (y * y - 1.0 / 3.0);
  EXPECT_NEAR(camera.Project({1.0, -2.0, 10.0}).value()[2], perfect[2] + shift, 1e-11);

  const auto project = [&](const Eigen::VectorXd& p) -> Eigen::VectorXd {
    return camera.Project(p).value();
  };
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d p = RandomPoint(rng);
    const Eigen::Vector3d z_px = camera.Project(p).value();
    EXPECT_LT((camera.BackProject(z_px).value() - p).norm(), 1e-9 * p.norm());
    const Eigen::Matrix3d J = camera.ProjectionJacobian(p);
    EXPECT_TRUE(test::JacobianMatches(project, p, J, 1e-6));
    const Eigen::Matrix3d product = camera.BackProjectionJacobian(z_px) * J;
    EXPECT_LT((product - Eigen::Matrix3d::Identity()).norm(), 1e-9);
  }
}

TEST(StereoCamera, ProjectionJacobianMatchesCentralDifferences) {
  Rng rng(2, "projection");
  const auto project = [](const Eigen::VectorXd& p) -> Eigen::VectorXd {
    return Camera().Project(p).value();
  };
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d p = RandomPoint(rng);
    EXPECT_TRUE(test::JacobianMatches(project, p, Camera().ProjectionJacobian(p), 1e-6));
  }
}

TEST(StereoCamera, BackProjectionJacobianMatchesCentralDifferencesAndIsTheInverse) {
  Rng rng(3, "back-projection");
  const auto back_project = [](const Eigen::VectorXd& z_px) -> Eigen::VectorXd {
    return Camera().BackProject(z_px).value();
  };
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d p = RandomPoint(rng);
    const Eigen::Vector3d z_px = Camera().Project(p).value();
    const Eigen::Matrix3d J = Camera().BackProjectionJacobian(z_px);
    EXPECT_TRUE(test::JacobianMatches(back_project, z_px, J, 1e-6));
    const Eigen::Matrix3d product = J * Camera().ProjectionJacobian(p);
    EXPECT_LT((product - Eigen::Matrix3d::Identity()).norm(), 1e-9);
  }
}

// det J_pi = fx^2 fy b / Z^4 (METHOD.md 1.2).
TEST(StereoCamera, DeterminantOfTheProjectionJacobian) {
  Rng rng(4, "determinant");
  const StereoCamera camera = Camera();
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d p = RandomPoint(rng);
    const double expected =
        camera.fx * camera.fx * camera.fy * camera.baseline_m / (p.z() * p.z() * p.z() * p.z());
    EXPECT_NEAR(camera.ProjectionJacobian(p).determinant() / expected, 1.0, 1e-9);
  }
}

// |Sigma_Z| = |Sigma_z| Z^8 / (fx^4 fy^2 b^2); depth variance = 2 sigma^2 (Z^2 / (fx b))^2.
TEST(StereoCamera, CovarianceHasTheStatedDeterminantAndDepthVariance) {
  const StereoCamera camera = Camera();
  const double sigma = 0.7;
  for (const double z : {2.0, 10.0, 40.0}) {
    const Eigen::Vector3d z_px = camera.Project({0.3 * z, -0.1 * z, z}).value();
    const Eigen::Matrix3d covariance =
        camera.PointCovariance(z_px, sigma * sigma * Eigen::Matrix3d::Identity());
    EXPECT_LT((covariance - covariance.transpose()).norm(), 1e-12 * covariance.norm());
    const double determinant =
        std::pow(sigma, 6) * std::pow(z, 8) /
        (std::pow(camera.fx, 4) * std::pow(camera.fy, 2) * std::pow(camera.baseline_m, 2));
    EXPECT_NEAR(covariance.determinant() / determinant, 1.0, 1e-6);
    const double deviation = std::sqrt(2.0) * sigma * z * z / (camera.fx * camera.baseline_m);
    EXPECT_NEAR(std::sqrt(covariance(2, 2)) / deviation, 1.0, 1e-12);
  }
}

TEST(StereoCamera, DoesNotProjectPointsBehindOrTooNear) {
  const StereoCamera camera = Camera();
  EXPECT_FALSE(camera.Project({0, 0, -1}).has_value());
  EXPECT_FALSE(camera.Project({0, 0, 0}).has_value());
  EXPECT_FALSE(camera.Project({0, 0, StereoCamera::kMinDepth_m}).has_value());
  EXPECT_FALSE(camera.Project({0, 0, kNaN}).has_value());
  EXPECT_TRUE(camera.Project({0, 0, 0.06}).has_value());
}

TEST(StereoCamera, DoesNotBackProjectWithoutDisparity) {
  const StereoCamera camera = Camera();
  EXPECT_FALSE(camera.BackProject({100, 50, 100}).has_value());
  EXPECT_FALSE(camera.BackProject({100, 50, 101}).has_value());
  EXPECT_FALSE(camera.BackProject({kNaN, 50, 99}).has_value());
}

TEST(StereoCamera, InImageIncludesTheFirstAndTheLastPixel) {
  const StereoCamera camera = Camera();
  EXPECT_TRUE(camera.InImage(0, 0));
  EXPECT_TRUE(camera.InImage(1241, 374));
  EXPECT_FALSE(camera.InImage(1241.1, 10));
  EXPECT_FALSE(camera.InImage(10, 374.1));
  EXPECT_FALSE(camera.InImage(-0.1, 10));
  EXPECT_FALSE(camera.InImage(kNaN, 10));
}

std::string CheckError(const StereoCamera& camera) {
  try {
    camera.Check();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(StereoCamera, CheckNamesTheInvalidField) {
  EXPECT_EQ(CheckError(Camera()), "");
  StereoCamera camera = Camera();
  camera.baseline_m = 0.0;
  EXPECT_EQ(CheckError(camera), "stereo camera, baseline: found 0, expected a positive number");
  camera = Camera();
  camera.fx = kNaN;
  EXPECT_THAT(CheckError(camera), HasSubstr("fx: found nan"));
  camera = Camera();
  camera.fy = -700.0;
  EXPECT_THAT(CheckError(camera), HasSubstr("fy: found -700"));
  camera = Camera();
  camera.cy = std::numeric_limits<double>::infinity();
  EXPECT_THAT(CheckError(camera), HasSubstr("principal point: found 609.5 inf"));
  camera = Camera();
  camera.height_px = 0;
  EXPECT_THAT(CheckError(camera), HasSubstr("height: found 0"));
}

}  // namespace
}  // namespace cvo
