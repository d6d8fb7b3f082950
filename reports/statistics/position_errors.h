// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "core/record/body_row.h"

namespace cvo::reports {

// Calls `act` with the indices of each frame that both ascending lists have. `shift` and
// `other_shift` convert their frames to a common numbering.
template <typename Act>
void ForCommonFrames(const std::vector<int>& frames, int shift, const std::vector<int>& others,
                     int other_shift, const Act& act) {
  for (std::size_t i = 0, k = 0; i < frames.size() && k < others.size();) {
    const int frame = frames[i] + shift;
    const int other = others[k] + other_shift;
    if (frame == other) act(i, k);
    if (frame <= other) ++i;
    if (other <= frame) ++k;
  }
}

// Root mean square errors of both over the frames that both have. Empty if they have no frame in
// common.
std::optional<std::pair<double, double>> CommonRootMeanSquares(const FrameErrors& a,
                                                               const FrameErrors& b);

// Distances (m) between estimated and true positions of the same index, after applying to the
// estimate the rotation and translation that minimise the sum of their squares (AlignPoints), as
// for camera ATE. Both lists must have the same size.
std::vector<double> AlignedErrors(const std::vector<std::array<double, 3>>& estimate,
                                  const std::vector<std::array<double, 3>>& truth);

}  // namespace cvo::reports
