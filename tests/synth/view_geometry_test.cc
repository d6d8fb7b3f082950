// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "synth/render/renderer.h"
#include "tests/synth/worlds.h"

namespace cvo::synth {
namespace {

StereoCamera StreetRig() {
  StereoCamera rig;
  rig.fx = rig.fy = 721.5;
  rig.cx = 609.6;
  rig.cy = 172.9;
  rig.baseline_m = 0.54;
  rig.width_px = 1242;
  rig.height_px = 375;
  return rig;
}

// Returns the column and row at which the right camera, with its error, sees a point that is given
// in the frame of the left camera.
Eigen::Vector2d InRight(const RigError& error, const Eigen::Vector3d& p_in_left) {
  const StereoCamera rig = StreetRig();
  const Eigen::Vector4d clip = ClipFromRight(rig, error) * p_in_left.homogeneous();
  return {(clip[0] / clip[3] + 1.0) * rig.width_px / 2.0 - 0.5,
          (clip[1] / clip[3] + 1.0) * rig.height_px / 2.0 - 0.5};
}

TEST(RigError, ShiftsProjectionsIntoTheRightCamera) {
  const StereoCamera rig = StreetRig();
  const Eigen::Vector3d p(3.0, -1.0, 20.0);
  const Eigen::Vector3d z_px = rig.Project(p).value();
  const Eigen::Vector2d as_calibrated(z_px[2], z_px[1]);
  EXPECT_LT((InRight({}, p) - as_calibrated).norm(), 1e-9);
  const Eigen::Vector2d shifted = InRight({.shift_px = 0.2}, p) - as_calibrated;
  EXPECT_LT((shifted - Eigen::Vector2d(0.2, 0.0)).norm(), 1e-9);
  const Eigen::Vector2d longer = InRight({.focal = 0.01}, p) - as_calibrated;
  EXPECT_NEAR(longer.x(), 0.01 * (z_px[2] - rig.cx), 1e-9);
  // When the camera turns to its right, points move to the left by f (1 + x^2) per radian.
  const double x = (z_px[2] - rig.cx) / rig.fx;
  const Eigen::Vector2d turned = InRight({.rotation_deg = {0.0, 0.001, 0.0}}, p) - as_calibrated;
  EXPECT_NEAR(turned.x(), -rig.fx * (1.0 + x * x) * 0.001 * std::acos(-1.0) / 180.0, 1e-5);
}

// A body of 1 m, 4 m in front of a camera of 20 x 10 pixels, drawn as its near face.
class EdgeDepth : public testing::Test {
 protected:
  EdgeDepth() {
    rig_ = {.fx = 20,
            .fy = 20,
            .cx = 9.5,
            .cy = 4.5,
            .baseline_m = 0.1,
            .width_px = 20,
            .height_px = 10};
    Body body;
    body.id = 1;
    body.size_m = {1.0, 1.0, 1.0};
    bodies_ = {body};
    view_.world_from_body = {RigidTransform(Eigen::Quaterniond::Identity(), {0, 0, 4})};
    rendering_.depth = cv::Mat(10, 20, CV_32FC1, cv::Scalar(8.0));
    rendering_.instances = cv::Mat::zeros(10, 20, CV_16UC1);
    const cv::Rect face(8, 3, 4, 4);
    rendering_.depth(face).setTo(3.5);
    rendering_.instances(face).setTo(1);
  }

  StereoCamera rig_;
  std::vector<Body> bodies_;
  View view_;
  Rendering rendering_;
};

TEST_F(EdgeDepth, TakesDepthOutsideTheBoxFromNeighbours) {
  rendering_.depth.at<float>(3, 9) = 3.1F;   // in front of the box
  rendering_.depth.at<float>(6, 11) = 5.2F;  // behind it, at a corner of the mask
  CorrectEdgeDepth(rig_, bodies_, view_, rendering_);
  EXPECT_FLOAT_EQ(rendering_.depth.at<float>(3, 9), 3.5F);
  EXPECT_FLOAT_EQ(rendering_.depth.at<float>(6, 11), 3.5F);
}

TEST_F(EdgeDepth, LeavesTheBackgroundAndBodiesWithoutSizeAlone) {
  rendering_.depth.at<float>(0, 0) = 0.1F;
  CorrectEdgeDepth(rig_, bodies_, view_, rendering_);
  EXPECT_FLOAT_EQ(rendering_.depth.at<float>(0, 0), 0.1F);
  bodies_[0].size_m.setZero();
  rendering_.depth.at<float>(3, 9) = 3.1F;
  CorrectEdgeDepth(rig_, bodies_, view_, rendering_);
  EXPECT_FLOAT_EQ(rendering_.depth.at<float>(3, 9), 3.1F);
}

}  // namespace
}  // namespace cvo::synth
