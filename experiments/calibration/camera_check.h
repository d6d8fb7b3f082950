// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "experiments/calibration/stereo_rig.h"

namespace cvo {

// Throws Error, naming `where`, where one focal length is more than twice the other, or the centre
// is outside the images.
void CheckCamera(const StereoCamera& camera, const std::string& where);

// The same of both cameras of a rig, whose images must have the size that it states (CheckSize).
void CheckCameras(const StereoRig& rig, int width_px, int height_px, const std::string& where);

}  // namespace cvo
