// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace cvo::testing {

// Returns the patch disagreement of a feature whose disparity has the given standard deviation. In
// rendered rooms, 1.48 times the median absolute disparity error is 1.6 times the median
// disagreement.
inline float DisagreementOf(double disparity_px) { return static_cast<float>(disparity_px / 1.6); }

}  // namespace cvo::testing
