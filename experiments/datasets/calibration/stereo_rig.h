// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// Deviation of a lens from the pinhole model. Coefficients: none; k1 k2 p1 p2 [k3 [k4 k5 k6]] of
// radial and tangential distortion ("radtan"); k1 k2 k3 k4 of an equidistant (fisheye) lens.
enum class LensModel { kPinhole, kPlumbBob, kEquidistant };
constexpr std::array<const char*, 3> EnumNames(LensModel) {
  return {"none", "plumb_bob", "equidistant"};
}

struct LensCamera {
  double fx = 0.0;  // px
  double fy = 0.0;
  double cx = 0.0;
  double cy = 0.0;
  LensModel lens = LensModel::kPinhole;
  std::vector<double> coefficients;
};

// A calibrated stereo pair, before rectification.
struct StereoRig {
  LensCamera left;
  LensCamera right;
  RigidTransform right_from_left;  // p_right = R p_left + t, metres
  int width_px = 0;                // of the images it was calibrated with; 0: not stated
  int height_px = 0;
};

// Whether both cameras have the same focal lengths and principal point, no distortion, and a
// baseline along x, so that their images can be used as they are.
bool IsRectified(const StereoRig& rig);

// Returns the camera of a rectified rig, for images of this size.
StereoCamera CameraOf(const StereoRig& rig, int width_px, int height_px);
// Throws Error, naming `where`, if the calibration states another image size.
void CheckSize(const StereoRig& rig, int width_px, int height_px, const std::string& where);

// Throws Error, naming `where`, if one focal length is more than twice the other or the principal
// point is outside the images.
void CheckCamera(const StereoCamera& camera, const std::string& where);

// Checks both cameras of a rig in the same way, and that the images have the size that the rig
// states (CheckSize).
void CheckCameras(const StereoRig& rig, int width_px, int height_px, const std::string& where);

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
