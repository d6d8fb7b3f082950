// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "core/base/rng.h"
#include "core/estimation/camera_solver.h"

namespace cvo {

// What a hypothesis has in its favour: CoveredCells for a camera, CountInliers for a body, which
// may lie in a single cell of the image.
using Support = int(const StereoCamera&, std::span<const PointMeasurement>,
                    std::span<const char> is_inlier);
int CountInliers(const StereoCamera& camera, std::span<const PointMeasurement> measurements,
                 std::span<const char> is_inlier);

// Camera from measurements of which many may be wrong and of which no initial guess exists: three
// triangulated points fix a hypothesis (3D-3D alignment), the one whose measurements within the
// gate support it most wins and is refined by SolveCamera. Empty where no hypothesis has
// min_inliers.
std::optional<CameraSolution> SolveCameraRansac(const StereoCamera& camera,
                                                std::span<const PointMeasurement> measurements,
                                                const NoiseOptions& noise, Support& support,
                                                int iterations, int min_inliers, Rng& rng);

}  // namespace cvo
