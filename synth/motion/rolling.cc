// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/motion/rolling.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cvo::synth {

using Eigen::Vector3d;

RollingMotion::RollingMotion(RouteTravel travel, double radius_m, double height_m,
                             double duration_s)
    : travel_(std::move(travel)),
      radius_m_(radius_m),
      height_m_(height_m),
      step_m_(std::min(0.01, 0.05 * radius_m)) {
  table_.push_back(Eigen::Quaterniond::Identity());
  const double end_m = travel_.Way_m(duration_s);
  for (double way = 0.0; way < end_m; way = step_m_ * static_cast<double>(table_.size() - 1)) {
    table_.push_back((Turn(way, way + step_m_) * table_.back()).normalized());
  }
}

Vector3d RollingMotion::TurnPerMetre(double way_m) const {
  return Vector3d::UnitZ().cross(travel_.At(way_m).per_metre) / radius_m_;
}

// Fourth-order Magnus expansion at the two Gauss-Legendre nodes.
Eigen::Quaterniond RollingMotion::Turn(double from_m, double to_m) const {
  const double h = to_m - from_m;
  const double middle = 0.5 * (from_m + to_m);
  const double offset = h * std::sqrt(3.0) / 6.0;
  const Vector3d w1 = TurnPerMetre(middle - offset);
  const Vector3d w2 = TurnPerMetre(middle + offset);
  return ExpSo3(0.5 * h * (w1 + w2) - std::sqrt(3.0) / 12.0 * h * h * w1.cross(w2));
}

Eigen::Quaterniond RollingMotion::Orientation(double way_m) const {
  const double last = static_cast<double>(table_.size() - 1);
  const double nearest = std::clamp(std::round(way_m / step_m_), 0.0, last);
  Eigen::Quaterniond orientation = table_[static_cast<std::size_t>(nearest)];
  // One step within the table, more steps before time zero and after the end.
  double at = nearest * step_m_;
  while (at != way_m) {
    const double next = at + std::clamp(way_m - at, -step_m_, step_m_);
    orientation = Turn(at, std::abs(way_m - next) < 1e-12 ? way_m : next) * orientation;
    at = std::abs(way_m - next) < 1e-12 ? way_m : next;
  }
  return orientation;
}

MotionState RollingMotion::At(double time_s) const {
  const double way = travel_.Way_m(time_s);
  const RouteTravel::State at = travel_.At(way);
  const Vector3d velocity = travel_.Speed_mps(time_s) * at.per_metre;
  return {RigidTransform(Orientation(way), Vector3d(at.position + height_m_ * Vector3d::UnitZ())),
          velocity, Vector3d::UnitZ().cross(velocity) / radius_m_};
}

}  // namespace cvo::synth
