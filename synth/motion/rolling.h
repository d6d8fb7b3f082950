// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "synth/motion/paths.h"

namespace cvo::synth {

// A ball that rolls on a plane along a route without slipping: omega = n x v / r. Its orientation
// depends only on the distance travelled. It is tabulated in steps of at most 1 cm and integrated
// from the nearest one.
class RollingMotion final : public Motion {
 public:
  RollingMotion(RouteTravel travel, double radius_m, double height_m, double duration_s);
  MotionState At(double time_s) const override;

 private:
  // Rotation per distance, rad/m, in world.
  Eigen::Vector3d TurnPerMetre(double way_m) const;
  // Rotation between two distances that are at most one step apart.
  Eigen::Quaterniond Turn(double from_m, double to_m) const;
  Eigen::Quaterniond Orientation(double way_m) const;

  RouteTravel travel_;
  double radius_m_;
  double height_m_;
  double step_m_;
  std::vector<Eigen::Quaterniond> table_;  // world_from_body at distance index * step_m_
};

}  // namespace cvo::synth
