// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "core/base/rng.h"
#include "core/estimation/camera_solver.h"

namespace cvo {

// Camera from measurements of which many may be wrong and of which no initial guess exists: three
// triangulated points fix a hypothesis (3D-3D alignment), the one whose measurements within the
// gate cover most of the image wins and is refined by SolveCamera. Empty where no hypothesis has
// min_inliers.
std::optional<CameraSolution> SolveCameraRansac(const StereoCamera& camera,
                                                std::span<const PointMeasurement> measurements,
                                                const NoiseOptions& noise, int iterations,
                                                int min_inliers, Rng& rng);

}  // namespace cvo
