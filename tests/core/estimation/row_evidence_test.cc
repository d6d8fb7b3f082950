// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/row_evidence.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <string>

namespace cvo {
namespace {

StereoCamera Camera() {
  StereoCamera camera;
  camera.fx = camera.fy = 720.0;
  camera.cx = 610.0;
  camera.cy = 175.0;
  camera.baseline_m = 0.54;
  camera.width_px = 1242;
  camera.height_px = 375;
  return camera;
}

// How the right camera differs from the calibration.
struct RightCamera {
  std::string name;
  Eigen::Vector3d turn_rad = Eigen::Vector3d::Zero();
  double focal = 0.0;                                    // relative
  double radial = 0.0;                                   // k1
  Eigen::Vector2d tangential = Eigen::Vector2d::Zero();  // p1, p2
  double baseline_slope = 0.0;                           // rise of the right camera per baseline

  // Where a point far away, seen at (u, v) in the left image, is seen in the right one.
  Eigen::Vector2d SeenAt(double u, double v) const {
    const StereoCamera camera = Camera();
    const Eigen::Vector3d ray((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
    const Eigen::Vector2d x = (ExpSo3(turn_rad).conjugate() * ray).hnormalized();
    const double r2 = x.squaredNorm();
    const Eigen::Vector2d shift(
        2.0 * tangential[0] * x[0] * x[1] + tangential[1] * (r2 + 2.0 * x[0] * x[0]),
        tangential[0] * (r2 + 2.0 * x[1] * x[1]) + 2.0 * tangential[1] * x[0] * x[1]);
    const Eigen::Vector2d seen = (1.0 + focal) * ((1.0 + radial * r2) * x + shift);
    return {camera.fx * seen[0] + camera.cx, camera.fy * seen[1] + camera.cy};
  }
};

class RowEvidence : public ::testing::TestWithParam<RightCamera> {
 protected:
  // Row offsets over the whole image, at disparities that do not depend on the place.
  static RowField Rows(const RightCamera& right) {
    std::vector<RowOffset> samples;
    ForEachPixel([&](double u, double v) {
      for (const double disparity : {2.0, 30.0}) {
        samples.push_back(
            {u, v, disparity, right.SeenAt(u, v)[1] - v + right.baseline_slope * disparity, 0.4});
      }
    });
    RowField rows;
    for (int pair = 0; pair < 10; ++pair) rows.Add(samples, Camera());
    return rows;
  }

  static Vector6d FieldOfColumns(const RightCamera& right) {
    Matrix6d information = Matrix6d::Zero();
    Vector6d weighted = Vector6d::Zero();
    ForEachPixel([&](double u, double v) {
      const Vector6d basis = Camera().BasisAt(u, v).value;
      information += basis * basis.transpose();
      weighted += basis * (right.SeenAt(u, v)[0] - u);
    });
    return information.llt().solve(weighted);
  }

  // Returns the squared whitened difference between what rows imply and this field.
  static double Disagreement(const RowField& rows, const Vector6d& field_px) {
    WindowPrior prior = CalibrationPrior(Camera(), Vector6d::Constant(1e3));
    AppendRowEvidence(rows, Camera(), 0.03, prior);
    return (prior.r0 + prior.J0 * (field_px - prior.right_field_point_px)).tail<4>().squaredNorm();
  }

 private:
  static void ForEachPixel(auto visit) {
    for (double u = 0.0; u < 1242.0; u += 54.0) {
      for (double v = 0.0; v < 375.0; v += 25.0) visit(u, v);
    }
  }
};

TEST_P(RowEvidence, AgreesWithTheColumnsOfTheSameCamera) {
  const Vector6d field_px = FieldOfColumns(GetParam());
  EXPECT_LT(Disagreement(Rows(GetParam()), field_px), 1.0);
}

TEST_P(RowEvidence, SaysNothingOfTheMean) {
  const RowField rows = Rows(GetParam());
  Vector6d field_px = FieldOfColumns(GetParam());
  const double before = Disagreement(rows, field_px);
  field_px[0] += 5.0;
  EXPECT_NEAR(Disagreement(rows, field_px), before, 1e-9 * (1.0 + before));
}

TEST_P(RowEvidence, ContradictsColumnsThatChangeFromRowToRowAlone) {
  const RowField rows = Rows(GetParam());
  for (const int coefficient : {2, 5}) {  // y, y^2
    Vector6d field_px = FieldOfColumns(GetParam());
    field_px[coefficient] += 0.2;
    EXPECT_GT(Disagreement(rows, field_px), 20.0) << coefficient;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Cameras, RowEvidence,
    ::testing::Values(RightCamera{"exact"}, RightCamera{"pitch", {5e-4, 0.0, 0.0}},
                      RightCamera{"yaw", {0.0, 1e-3, 0.0}}, RightCamera{"roll", {0.0, 0.0, 1e-3}},
                      RightCamera{"focal", Eigen::Vector3d::Zero(), 5e-4},
                      RightCamera{"radial", Eigen::Vector3d::Zero(), 0.0, 5e-4},
                      RightCamera{"tangential_x", Eigen::Vector3d::Zero(), 0.0, 0.0, {0.0, 5e-4}},
                      RightCamera{"tangential_y", Eigen::Vector3d::Zero(), 0.0, 0.0, {2e-4, 0.0}},
                      RightCamera{
                          "slope", {0.0, 0.0, 5e-4}, 0.0, 0.0, Eigen::Vector2d::Zero(), 0.005}),
    [](const auto& camera) { return camera.param.name; });

TEST(RowOffsetsOfFeatures, LeaveOutThoseThatAreNotKnown) {
  std::vector<StereoFeature> features(2);
  features[0].z_px = {100.0, 50.0, 90.0};
  features[0].octave = 1;
  features[0].row_offset_px = 0.5F;
  const std::vector<RowOffset> offsets = RowOffsets(features, 1.2);
  ASSERT_EQ(offsets.size(), 1u);
  EXPECT_EQ(offsets[0].u_px, 100.0);
  EXPECT_EQ(offsets[0].disparity_px, 10.0);
  EXPECT_EQ(offsets[0].offset_px, 0.5);
  EXPECT_DOUBLE_EQ(offsets[0].sigma_px, 1.2 * RowSigma(1.0));
}

}  // namespace
}  // namespace cvo
