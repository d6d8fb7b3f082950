// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/stereo_camera.h"

namespace cvo::test {

// Returns a camera with square pixels and the principal point in the middle of the image.
inline StereoCamera CentredCamera(double focal_px, double baseline_m, int width_px, int height_px) {
  return {.fx = focal_px,
          .fy = focal_px,
          .cx = 0.5 * width_px,
          .cy = 0.5 * height_px,
          .baseline_m = baseline_m,
          .width_px = width_px,
          .height_px = height_px};
}

}  // namespace cvo::test
