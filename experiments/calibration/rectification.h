// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <string>

#include "core/geometry/stereo_camera.h"
#include "experiments/calibration/stereo_rig.h"

namespace cvo {

// Rectifies a stereo pair (Bouguet): rotates each camera by half of their relative rotation, then
// both so that the baseline lies along x. Both get the same focal length and principal point,
// chosen so that every pixel of a rectified image was seen by its camera. The image size is kept.
// The rotations are OpenCV's. Focal length and principal point are those of OpenCV's stereoRectify
// (alpha 0) up to version 3, with which public data sets were rectified; version 4.6 yields others.
// For fisheye lenses they are those of the installed version.
class Rectification {
 public:
  // Throws Error if OpenCV finds no rectification.
  Rectification(const StereoRig& rig, const cv::Size& size);

  const StereoCamera& camera() const { return camera_; }
  // Hash of the rig: another rig makes other images from the same files.
  const std::string& identity() const { return identity_; }
  // p_in_rectified = R p_in_left, and likewise for the right camera.
  const Eigen::Matrix3d& rectified_from_left() const { return rectified_from_left_; }
  const Eigen::Matrix3d& rectified_from_right() const { return rectified_from_right_; }

  cv::Mat Left(const cv::Mat& image) const { return Remap(image, left_); }
  cv::Mat Right(const cv::Mat& image) const { return Remap(image, right_); }

 private:
  // Source coordinates of each pixel of the rectified image.
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
