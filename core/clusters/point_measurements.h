// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/association/match.h"
#include "core/estimation/camera_solver.h"
#include "core/estimation/landmark.h"

namespace cvo {

// Converts matches of a body's landmarks with features to measurements of the camera pose in the
// body's frame.
std::vector<PointMeasurement> MeasurementsOf(const FeatureNoise& noise,
                                             const std::vector<Landmark>& landmarks,
                                             std::span<const StereoFeature> features,
                                             const std::vector<Match>& matches);

}  // namespace cvo
