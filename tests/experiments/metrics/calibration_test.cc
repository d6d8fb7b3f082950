// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "core/geometry/stereo_camera.h"
#include "experiments/metrics/camera_metrics.h"

namespace cvo::calibration_metrics_test {
namespace {

const Vector6d kTruth_px{{0.2, -0.01, 0.03, 0.02, 0.0, -0.05}};

CalibrationReport Estimate(const Vector6d& error_px) {
  return {kTruth_px + error_px, 1e4 * Matrix6d::Identity()};
}

TEST(EvaluateCalibration, ErrorIsTheRootMeanSquareOverTheImage) {
  StereoCamera camera;
  camera.width_px = 1242;
  camera.height_px = 375;
  const Vector6d error_px{{0.03, -0.02, 0.05, 0.04, -0.06, 0.01}};
  double squares = 0.0;
  for (int v = 0; v < camera.height_px; ++v) {
    for (int u = 0; u < camera.width_px; ++u) {
      squares += std::pow(error_px.dot(camera.BasisAt(u, v).value), 2);
    }
  }
  const auto metrics = EvaluateCalibration(kTruth_px, Estimate(error_px));
  ASSERT_EQ(metrics.size(), 2u);
  EXPECT_EQ(metrics[0].name, "calibration_error");
  EXPECT_NEAR(metrics[0].value, std::sqrt(squares / (camera.width_px * camera.height_px)), 1e-5);
}

TEST(EvaluateCalibration, NeesIsOneIfErrorsAreAsLargeAsClaimed) {
  CalibrationReport estimate = Estimate(Vector6d::Zero());
  const Vector6d sigma_px = estimate.Covariance_px2().diagonal().cwiseSqrt();
  estimate.right_field_px += sigma_px;
  EXPECT_NEAR(EvaluateCalibration(kTruth_px, estimate)[1].value, 1.0, 1e-9);
  estimate.right_field_px += sigma_px;
  EXPECT_NEAR(EvaluateCalibration(kTruth_px, estimate)[1].value, 4.0, 1e-9);
}

TEST(EvaluateCalibration, IsEmptyWithoutSelfCalibration) {
  EXPECT_TRUE(EvaluateCalibration(kTruth_px, {}).empty());
}

}  // namespace
}  // namespace cvo::calibration_metrics_test
