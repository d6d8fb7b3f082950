// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "experiments/datasets/sequence.h"

namespace cvo {

// What StereoCamera::right_field_px should be found for a rendered scene: the best fit, over the
// whole image, to the disparity error that the scene's right camera gives points far away. The
// camera's right_shift_px, which is known, is not part of it. Empty if the sequence is not a
// rendered scene, or is perturbed.
std::optional<Vector6d> TrueRightField(const Sequence& sequence);

}  // namespace cvo
