// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "synth/motion/motion.h"
#include "synth/motion/path_description.h"

namespace cvo::synth {

// Returns world_from_left along the camera's route, without roll except for the shake, which
// `look_seed` determines. Throws Error if the route is shorter than the distance travelled.
std::shared_ptr<const Motion> MakeCameraMotion(const CameraDescription& camera, double duration_s,
                                               std::uint64_t look_seed);

}  // namespace cvo::synth
