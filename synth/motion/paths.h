// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "synth/motion/curve.h"
#include "synth/motion/motion.h"
#include "synth/motion/path_description.h"

namespace cvo::synth {

// What a path needs to know about its body.
struct BodyShape {
  double half_height_m = 0.0;
  double rolling_radius_m = 0.0;  // > 0: rolls on its route without slipping
};

// Throws Error where the path cannot be taken: a route shorter than the way travelled in
// `duration_s`.
std::shared_ptr<const Motion> MakeMotion(const PathDescription& path, const BodyShape& body,
                                         double duration_s);

// Along a route in the plane: the curve, moved to the left, with its derivative by the time.
class RouteTravel {
 public:
  RouteTravel(const RouteDescription& route, double duration_s);

  struct State {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();   // z is zero
    Eigen::Vector3d per_metre = Eigen::Vector3d::Zero();  // d position / d way
    double yaw_rad = 0.0;                                 // of the route's direction
    double yaw_per_metre = 0.0;                           // rad/m
  };
  double Way_m(double time_s) const { return speed_.Way_m(time_s); }  // since time zero
  double Speed_mps(double time_s) const { return speed_.Speed_mps(time_s); }
  State At(double way_m) const;

 private:
  Curve curve_;
  SpeedProfile speed_;
  double start_m_;
  double lateral_m_;
};

// Angle and rate of amplitude * sin(2 pi t / period + phase).
struct Swinging {
  double angle_rad = 0.0;
  double rate_radps = 0.0;
};
Swinging At(const Oscillation& oscillation, double time_s);

}  // namespace cvo::synth
