// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "synth/motion/paths.h"

namespace cvo::synth {

// A ball that rolls on a plane along a route without slipping: omega = n x v / r. Its orientation
// depends on the way alone; it is tabulated every few millimetres of it and integrated from there.
class RollingMotion final : public Motion {
 public:
  RollingMotion(RouteTravel travel, double radius_m, double height_m, double duration_s);
  MotionState At(double time_s) const override;

 private:
  // Turning per metre of way, rad/m, in world.
  Eigen::Vector3d TurnPerMetre(double way_m) const;
  // Rotation from one place of the way to another that is at most a step away.
  Eigen::Quaterniond Turn(double from_m, double to_m) const;
  Eigen::Quaterniond Orientation(double way_m) const;

  RouteTravel travel_;
  double radius_m_;
  double height_m_;
  double step_m_;
  std::vector<Eigen::Quaterniond> table_;  // world_from_body at way index * step
};

}  // namespace cvo::synth
