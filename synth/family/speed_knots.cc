// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "synth/family/draws.h"
#include "synth/family/layout.h"
#include "synth/motion/speed_profile.h"

namespace cvo::synth {
namespace {

using Knots = std::vector<SpeedProfile::Knot>;

// Places one stop in each of several equal parts of the time.
Knots WithStops(const SpeedRequest& request, Rng& rng) {
  constexpr double kRamp_s = 0.5;
  constexpr double kShortestPart_s = 2.4;
  Knots knots = {{0.0, request.speed_mps}};
  const int stops = std::min(request.stops, static_cast<int>(request.duration_s / kShortestPart_s));
  for (int i = 0; i < stops; ++i) {
    const double part_s = request.duration_s / stops;
    const double pause_s = rng.Uniform(0.5, std::min(2.0, part_s - 1.4));
    const double start_s =
        part_s * i + rng.Uniform(0.2, std::max(0.25, part_s - pause_s - 2.0 * kRamp_s - 0.1));
    knots.push_back({start_s, request.speed_mps});
    knots.push_back({start_s + kRamp_s, 0.0});
    knots.push_back({start_s + kRamp_s + pause_s, 0.0});
    knots.push_back({start_s + 2.0 * kRamp_s + pause_s, request.speed_mps});
  }
  return knots;
}

// Adds a final stop if the distance would exceed `length_m`.
void StopWithin(double length_m, double duration_s, Knots& knots) {
  constexpr double kStop_s = 0.8;
  constexpr double kStopStep_s = 0.05;
  const SpeedProfile profile(knots);
  if (profile.Way_m(duration_s) <= length_m) return;
  double time_s = 0.0;
  while (profile.Way_m(time_s + kStopStep_s) +
             0.5 * kStop_s * profile.Speed_mps(time_s + kStopStep_s) <
         length_m) {
    time_s += kStopStep_s;
  }
  const double speed_mps = profile.Speed_mps(time_s);
  std::erase_if(knots, [&](const SpeedProfile::Knot& knot) { return knot.time_s >= time_s; });
  knots.push_back({time_s, speed_mps});
  knots.push_back({time_s + kStop_s, 0.0});
}

}  // namespace

Json PointJson(const Eigen::Vector2d& point) {
  return Json::array({Millis(point.x()), Millis(point.y())});
}

Json SpeedKnots(const SpeedRequest& request, Rng& rng) {
  Knots knots = WithStops(request, rng);
  StopWithin(request.length_m, request.duration_s, knots);
  if (knots.size() == 1) return Millis(request.speed_mps);
  Json rows = Json::array();
  for (const SpeedProfile::Knot& knot : knots) {
    rows.push_back({Millis(knot.time_s), Millis(knot.speed_mps)});
  }
  return rows;
}

}  // namespace cvo::synth
