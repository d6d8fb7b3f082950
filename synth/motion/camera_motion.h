// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "synth/motion/motion.h"
#include "synth/motion/path_description.h"

namespace cvo::synth {

// world_from_left along the camera's route, level but for its shake, which `look_seed` decides.
// Throws Error for a route shorter than the way travelled.
std::shared_ptr<const Motion> MakeCameraMotion(const CameraDescription& camera, double duration_s,
                                               std::uint64_t look_seed);

}  // namespace cvo::synth
