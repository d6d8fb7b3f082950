// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace cvo::synth {

// Speed over time: constant before the first knot and after the last, eased between knots so that
// it is twice differentiable.
class SpeedProfile {
 public:
  struct Knot {
    double time_s = 0.0;
    double speed_mps = 0.0;
  };

  // Throws Error unless there is at least one knot and times increase.
  explicit SpeedProfile(std::vector<Knot> knots);

  double Speed_mps(double time_s) const;
  // Distance travelled since time zero, m.
  double Way_m(double time_s) const { return WaySinceFirst_m(time_s) - way_of_zero_m_; }

 private:
  std::size_t Segment(double time_s) const;  // number of knots at or before the time
  double WaySinceFirst_m(double time_s) const;

  std::vector<Knot> knots_;
  std::vector<double> way_m_;  // distance from the first knot to each
  double way_of_zero_m_ = 0.0;
};

}  // namespace cvo::synth
