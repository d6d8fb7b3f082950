// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/calibration/stereo_rig.h"

#include <algorithm>

#include "core/base/error.h"

namespace cvo {

bool IsRectified(const StereoRig& rig) {
  const LensCamera& a = rig.left;
  const LensCamera& b = rig.right;
  // Far below what is visible in pixels. Products of poses read from text are never exact.
  constexpr double kRounding = 1e-9;
  const Eigen::Vector3d t = rig.right_from_left.translation();
  return a.lens == LensModel::kPinhole && b.lens == LensModel::kPinhole && a.fx == b.fx &&
         a.fy == b.fy && a.cx == b.cx && a.cy == b.cy && t.x() < 0.0 &&
         t.tail<2>().norm() < kRounding &&
         RotationAngle(rig.right_from_left.rotation()) < kRounding;
}

StereoCamera CameraOf(const StereoRig& rig, int width_px, int height_px) {
  const LensCamera& left = rig.left;
  return {left.fx,  left.fy,  left.cx, left.cy, -rig.right_from_left.translation().x(),
          width_px, height_px};
}

void CheckSize(const StereoRig& rig, int width_px, int height_px, const std::string& where) {
  if (rig.width_px == 0 || (rig.width_px == width_px && rig.height_px == height_px)) return;
  ThrowError(where, StrCat("a calibration of ", rig.width_px, "x", rig.height_px, " px"),
             StrCat(width_px, "x", height_px, " px, as the images"));
}

void CheckCamera(const StereoCamera& camera, const std::string& where) {
  constexpr double kUnlike = 2.0;  // pixels are nearly square
  if (std::max(camera.fx, camera.fy) > kUnlike * std::min(camera.fx, camera.fy)) {
    ThrowError(where, StrCat("fx ", camera.fx, ", fy ", camera.fy),
               "focal lengths within a factor of 2");
  }
  if (camera.cx < 0.0 || camera.cx >= camera.width_px || camera.cy < 0.0 ||
      camera.cy >= camera.height_px) {
    ThrowError(
        where, StrCat("cx ", camera.cx, ", cy ", camera.cy),
        StrCat("a centre within the images of ", camera.width_px, "x", camera.height_px, " px"));
  }
}

void CheckCameras(const StereoRig& rig, int width_px, int height_px, const std::string& where) {
  CheckSize(rig, width_px, height_px, where);
  CheckCamera(CameraOf(rig, width_px, height_px), where + ", left camera");
  StereoRig right = rig;
  right.left = rig.right;
  CheckCamera(CameraOf(right, width_px, height_px), where + ", right camera");
}

}  // namespace cvo
