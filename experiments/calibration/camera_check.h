// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "experiments/calibration/stereo_rig.h"

namespace cvo {

// Throws Error, naming `where`, if one focal length is more than twice the other or the principal
// point is outside the images.
void CheckCamera(const StereoCamera& camera, const std::string& where);

// Checks both cameras of a rig in the same way, and that the images have the size that the rig
// states (CheckSize).
void CheckCameras(const StereoRig& rig, int width_px, int height_px, const std::string& where);

}  // namespace cvo
