// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace cvo::testing {

// What the patch of a feature says whose disparity has this standard deviation. On rendered rooms
// errors (1.48 times their median) are 1.6 times the median disagreement.
inline float DisagreementOf(double disparity_px) { return static_cast<float>(disparity_px / 1.6); }

}  // namespace cvo::testing
