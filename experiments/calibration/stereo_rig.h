// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// How a lens departs from a pinhole. Coefficients: none; k1 k2 p1 p2 [k3] of radial and tangential
// distortion ("radtan"); k1 k2 k3 k4 of an equidistant (fisheye) lens.
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

// A stereo pair as it was calibrated.
struct StereoRig {
  LensCamera left;
  LensCamera right;
  RigidTransform right_from_left;  // p_right = R p_left + t, metres
  int width_px = 0;                // of the calibration's images; 0: not stated
  int height_px = 0;
};

// One focal length and centre for both cameras, no distortion, and a baseline along x: images can
// be used as they are.
bool IsRectified(const StereoRig& rig);

// The camera of images of a rig that is rectified.
StereoCamera CameraOf(const StereoRig& rig, int width_px, int height_px);
// Throws Error, naming `where`, if the calibration states that its images have another size.
void CheckSize(const StereoRig& rig, int width_px, int height_px, const std::string& where);

}  // namespace cvo
