// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "experiments/metrics/trajectory.h"

namespace cvo {

// Offset of the clock of the ground truth from that of the estimate: adding offset_s to a time of
// the estimate gives the time of the truth (METHOD.md 10.6).
struct ClockOffset {
  double offset_s = 0.0;
  double deviation_s = 0.0;         // standard deviation, from the residuals
  double residual_rad_per_s = 0.0;  // root mean square over all axes
  // Fraction of the variance of the estimate's turn rates that the truth's rates explain at the
  // offset.
  double explained = 0.0;
  std::size_t pairs = 0;  // number of pairs of consecutive poses

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("offset_s", self.offset_s);
    archive.Field("deviation_s", self.deviation_s);
    archive.Field("residual_rad_per_s", self.residual_rad_per_s);
    archive.Field("explained", self.explained);
    archive.Field("pairs", self.pairs);
  }
};

inline constexpr double kMostClockOffset_s = 10.0;

// Finds the offset within +/- `most_s` (above 0, up to kMostClockOffset_s) at which the turn rates
// of the two trajectories agree best. Both are world_from_camera of the same camera, each in its
// own world. Throws Error if their motions do not determine the offset: they overlap too little in
// time, hardly turn, or agree as well at another offset.
ClockOffset EstimateClockOffset(const Trajectory& truth, const Trajectory& estimate, double most_s);

}  // namespace cvo
