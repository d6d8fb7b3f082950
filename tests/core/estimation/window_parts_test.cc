// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <string>

#include "core/estimation/double_track.h"
#include "core/estimation/window_problem.h"
#include "tests/support/estimator_inputs.h"

namespace cvo::window_parts_test {
namespace {

// Tests parts of the window in isolation: visibility, promotion of frames, and the arrays of a
// problem.

const StereoCamera kCamera = test::CentredCamera(500, 0.5, 640, 480);

RigidTransform At(double z, double turn_rad = 0.0) {
  return {ExpSo3({0.0, turn_rad, 0.0}), Eigen::Vector3d(0.0, 0.0, z)};
}

Landmark Seen(int id, double z, const std::vector<int>& frames) {
  Landmark landmark;
  landmark.id = LandmarkId{id};
  landmark.p_in_object = {0.0, 0.0, z};
  for (const int frame : frames) {
    landmark.observations.push_back({FrameId{frame}, Eigen::Vector3d(id, frame, 0.5)});
  }
  return landmark;
}

// Returns a window with frame 0 in T_s, frames 4 and 5 in T_t, and ten landmarks at 1 ... 10 m that
// are observed in frame 0.
Window MakeWindow(const std::vector<int>& seen_by_4) {
  Window window;
  window.camera = kCamera;
  window.prior = CalibrationPrior(kCamera, Vector6d::Ones());
  window.spatial = {{FrameId{0}, At(0.0)}};
  window.temporal = {{FrameId{4}, At(0.0)}, {FrameId{5}, At(1.0)}};
  for (int id = 0; id < 10; ++id) {
    const bool also = std::find(seen_by_4.begin(), seen_by_4.end(), id) != seen_by_4.end();
    window.landmarks.push_back(
        Seen(id, id + 1.0, also ? std::vector<int>{0, 4} : std::vector<int>{0}));
  }
  return window;
}

TEST(PromoteDistant, PromotesByRotationDistanceOrOverlap) {
  const std::vector<int> all = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  const WindowOptions options = {
      .promote_translation = 0.25, .promote_rotation_rad = 0.2, .promote_common = 0.5};
  const auto promotes = [&](const Window& window, const RigidTransform& pose) {
    return PromoteDistant::Promotes(window, {FrameId{4}, pose}, options);
  };
  const Window window = MakeWindow(all);
  EXPECT_FALSE(promotes(window, At(0.0)));
  EXPECT_TRUE(promotes(window, At(0.0, 0.21)));
  EXPECT_FALSE(promotes(window, At(0.0, -0.19)));
  // A quarter of the median depth of 6 m.
  EXPECT_FALSE(promotes(window, At(1.5)));
  EXPECT_TRUE(promotes(window, At(1.6)));
  EXPECT_TRUE(promotes(window, At(-1.6)));
  // Half of the ten landmarks.
  EXPECT_FALSE(promotes(MakeWindow({0, 1, 2, 3, 4}), At(0.0)));
  EXPECT_TRUE(promotes(MakeWindow({0, 1, 2, 3}), At(0.0)));
  Window first = window;
  first.spatial.clear();
  EXPECT_TRUE(promotes(first, At(0.0))) << "there is none to compare with";
}

TEST(PromoteFarFromFirst, ComparesWithTheFirstFrameAndIgnoresRotation) {
  Window window = MakeWindow({0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  window.spatial.push_back({FrameId{2}, At(-1.0)});
  const WindowOptions options = {.promote_translation = 0.25, .promote_common = 0.5};
  const auto promotes = [&](const RigidTransform& pose) {
    return PromoteFarFromFirst::Promotes(window, {FrameId{4}, pose}, options);
  };
  EXPECT_FALSE(promotes(At(1.5, 0.21)));
  EXPECT_TRUE(promotes(At(1.6)));
}

TEST(CalibrationDeviation, CoversFieldShiftOrNothing) {
  const auto expect = [](NoiseOptions noise, double mean_px, double field_px) {
    const Vector6d deviation = CalibrationDeviation(noise);
    EXPECT_EQ(deviation[0], mean_px);
    EXPECT_TRUE((deviation.tail<5>().array() == field_px).all());
  };
  expect({.right_mean_px = 0.1, .right_field_px = 0.2}, 0.1, 0.2);
  expect({.right_mean_px = 0.1, .right_field_px = 0.0}, 0.1, 1e-3);
  EXPECT_FALSE(TrustsCalibration({.right_field_px = 0.0}));
  EXPECT_TRUE(TrustsCalibration({.right_mean_px = 0.0}));
}

TEST(SelectLandmarks, RequiresTwoObservationsAndPrefersTheFirst) {
  const Window window = MakeWindow({0, 3, 8});
  EXPECT_EQ(SelectLandmarks(window, 3), (std::vector<int>{0, 3, 8}));
  EXPECT_EQ(SelectLandmarks(window, 2), (std::vector<int>{0, 3})) << "of equals the first";
  EXPECT_TRUE(SelectLandmarks(window, 0).empty());
}

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

class RowEvidence : public testing::TestWithParam<RightCamera> {
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

TEST_P(RowEvidence, AgreesWithTheColumnsOfTheSameCameraUpToTheirMean) {
  const RowField rows = Rows(GetParam());
  const Vector6d field_px = FieldOfColumns(GetParam());
  const auto disagreement = [&](int coefficient, double change_px) {
    return Disagreement(rows, field_px + change_px * Vector6d::Unit(coefficient));
  };
  const double same = disagreement(0, 0.0);
  EXPECT_LT(same, 1.0);
  EXPECT_NEAR(disagreement(0, 5.0), same, 1e-9 * (1.0 + same));
  // Columns that change from row to row alone contradict.
  EXPECT_GT(disagreement(2, 0.2), 20.0);  // y
  EXPECT_GT(disagreement(5, 0.2), 20.0);  // y^2
}

INSTANTIATE_TEST_SUITE_P(
    Cameras, RowEvidence,
    testing::Values(RightCamera{"exact"}, RightCamera{"pitch", {5e-4, 0.0, 0.0}},
                    RightCamera{"yaw", {0.0, 1e-3, 0.0}}, RightCamera{"roll", {0.0, 0.0, 1e-3}},
                    RightCamera{"focal", Eigen::Vector3d::Zero(), 5e-4},
                    RightCamera{"radial", Eigen::Vector3d::Zero(), 0.0, 5e-4},
                    RightCamera{"tangential_x", Eigen::Vector3d::Zero(), 0.0, 0.0, {0.0, 5e-4}},
                    RightCamera{"tangential_y", Eigen::Vector3d::Zero(), 0.0, 0.0, {2e-4, 0.0}},
                    RightCamera{
                        "slope", {0.0, 0.0, 5e-4}, 0.0, 0.0, Eigen::Vector2d::Zero(), 0.005}),
    [](const auto& camera) { return camera.param.name; });

}  // namespace
}  // namespace cvo::window_parts_test
