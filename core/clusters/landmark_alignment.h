// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/association/match.h"
#include "core/estimation/landmark.h"
#include "core/features/stereo_feature.h"
#include "core/geometry/rigid_transform.h"

namespace cvo {

// Moves features that were matched with landmarks of one body to where they show the same points
// as when these were first seen, and marks them as aligned (METHOD.md 3.4). Those that do not look
// alike stay where their corners are. `scale_factor`: from a level of the pyramid to the next.
void AlignToLandmarks(double scale_factor, const RigidTransform& camera_from_object,
                      const std::vector<Landmark>& landmarks, const std::vector<Match>& matches,
                      std::span<StereoFeature> features);

// The landmark's reference after it was seen as the feature, at the depth landmark.depth_m: a new
// one where there is none, the feature is not aligned, or its size has changed much.
void UpdateReference(double scale_factor, const StereoFeature& feature, Landmark& landmark);

}  // namespace cvo
