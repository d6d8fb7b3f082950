// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/features/row_field.h"
#include "core/features/stereo_feature.h"
#include "core/solvers/window_prior.h"

namespace cvo {

// Returns the row offsets of all features that have one.
std::vector<RowOffset> RowOffsets(const std::vector<StereoFeature>& features, double scale_factor);

// Appends to the prior what the row offsets of the pair say of its right_field_px (METHOD.md 7.6):
// a rotation of the right camera, a longer lens and a shifted centre of distortion move rows and
// columns by related amounts. `deviation_px` is the standard deviation of each coefficient of the
// row field from such a cause.
void AppendRowEvidence(const RowField& rows, const StereoCamera& camera, double deviation_px,
                       WindowPrior& prior);

}  // namespace cvo
