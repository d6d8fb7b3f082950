// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/render/edge_depth.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace cvo::synth {
namespace {

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

TEST_F(EdgeDepth, LeavesDepthWithinTheBox) {
  const cv::Mat drawn = rendering_.depth.clone();
  CorrectEdgeDepth(rig_, bodies_, view_, rendering_);
  EXPECT_EQ(cv::norm(drawn, rendering_.depth, cv::NORM_INF), 0.0);
}

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
