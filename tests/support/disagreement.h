// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/solvers/measurement_noise.h"

namespace cvo::testing {

// What the patch of a feature says whose disparity has this standard deviation.
inline float DisagreementOf(double disparity_px) {
  return static_cast<float>(disparity_px / NoiseOptions().disagreement);
}

}  // namespace cvo::testing
