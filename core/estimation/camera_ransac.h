// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "core/base/rng.h"
#include "core/estimation/camera_solver.h"

namespace cvo {

// Scores a hypothesis by its inliers: CoveredCells for a camera, CountInliers for a body, which may
// lie in a single cell of the image.
using Support = int(const StereoCamera&, std::span<const PointMeasurement>,
                    std::span<const char> is_inlier);
int CountInliers(const StereoCamera& camera, std::span<const PointMeasurement> measurements,
                 std::span<const char> is_inlier);

// Estimates the camera pose without an initial guess from measurements that may contain many
// outliers. Each hypothesis is a 3D-3D alignment of three triangulated points. The one with the
// highest support among the measurements within the gate (widened by noise.hypothesis_gate) is
// refined by SolveCamera. Empty if there is no hypothesis, or if the refined pose has fewer than
// min_inliers inliers.
std::optional<CameraSolution> SolveCameraRansac(const StereoCamera& camera,
                                                std::span<const PointMeasurement> measurements,
                                                const NoiseOptions& noise, Support& support,
                                                int iterations, int min_inliers, Rng& rng);

}  // namespace cvo
