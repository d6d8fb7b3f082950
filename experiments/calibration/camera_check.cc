// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/calibration/camera_check.h"

#include <algorithm>

#include "core/base/error.h"

namespace cvo {

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
