// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/motion/speed_profile.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"

namespace cvo::synth {
namespace {

// A step from 0 to 1 whose first two derivatives vanish at both ends, and its integral from 0.
double Ease(double x) { return x * x * x * (10.0 + x * (-15.0 + 6.0 * x)); }
double EaseIntegral(double x) { return x * x * x * x * (2.5 + x * (-3.0 + x)); }

}  // namespace

SpeedProfile::SpeedProfile(std::vector<Knot> knots) : knots_(std::move(knots)) {
  Require(!knots_.empty(), "a speed profile has knots");
  way_m_.push_back(0.0);
  for (std::size_t i = 1; i < knots_.size(); ++i) {
    const double duration_s = knots_[i].time_s - knots_[i - 1].time_s;
    Require(duration_s > 0.0, "knots of a speed profile are in the order of time");
    way_m_.push_back(way_m_.back() +
                     0.5 * duration_s * (knots_[i - 1].speed_mps + knots_[i].speed_mps));
  }
  way_of_zero_m_ = WaySinceFirst_m(0.0);
}

std::size_t SpeedProfile::Segment(double time_s) const {
  const auto above =
      std::upper_bound(knots_.begin(), knots_.end(), time_s,
                       [](double time, const Knot& knot) { return time < knot.time_s; });
  return static_cast<std::size_t>(above - knots_.begin());
}

double SpeedProfile::Speed_mps(double time_s) const {
  const std::size_t i = Segment(time_s);
  if (i == 0) return knots_.front().speed_mps;
  if (i == knots_.size()) return knots_.back().speed_mps;
  const Knot& from = knots_[i - 1];
  const Knot& to = knots_[i];
  const double x = (time_s - from.time_s) / (to.time_s - from.time_s);
  return from.speed_mps + (to.speed_mps - from.speed_mps) * Ease(x);
}

double SpeedProfile::WaySinceFirst_m(double time_s) const {
  const std::size_t i = Segment(time_s);
  const Knot& from = knots_[i == 0 ? 0 : i - 1];
  const double elapsed_s = time_s - from.time_s;
  const double way = way_m_[i == 0 ? 0 : i - 1] + from.speed_mps * elapsed_s;
  if (i == 0 || i == knots_.size()) return way;
  const double duration_s = knots_[i].time_s - from.time_s;
  return way +
         (knots_[i].speed_mps - from.speed_mps) * duration_s * EaseIntegral(elapsed_s / duration_s);
}

}  // namespace cvo::synth
