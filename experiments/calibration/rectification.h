// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <string>

#include "core/geometry/stereo_camera.h"
#include "experiments/calibration/stereo_rig.h"

namespace cvo {

// Both cameras turned by half of their relative rotation and then so that the baseline lies along x
// (Bouguet), with one focal length and centre, by which every pixel of the result has been seen.
// Images keep their size. Turns are OpenCV's; focal length and centre are those of its
// stereoRectify (alpha 0) up to version 3, by which public data sets were rectified: 4.6 gives
// others.
class Rectification {
 public:
  // Throws Error where OpenCV finds none.
  Rectification(const StereoRig& rig, const cv::Size& size);

  const StereoCamera& camera() const { return camera_; }
  // A hash of the rig: another one makes other images of the same files.
  const std::string& identity() const { return identity_; }
  // p_in_rectified = R p_in_left, and of the right camera.
  const Eigen::Matrix3d& rectified_from_left() const { return rectified_from_left_; }
  const Eigen::Matrix3d& rectified_from_right() const { return rectified_from_right_; }

  cv::Mat Left(const cv::Mat& image) const { return Remap(image, left_); }
  cv::Mat Right(const cv::Mat& image) const { return Remap(image, right_); }

 private:
  // Where each pixel is taken from.
  struct Maps {
    cv::Mat u, v;
  };
  static cv::Mat Remap(const cv::Mat& image, const Maps& maps);

  std::string identity_;
  StereoCamera camera_;
  Eigen::Matrix3d rectified_from_left_;
  Eigen::Matrix3d rectified_from_right_;
  Maps left_, right_;
};

}  // namespace cvo
