// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "synth/motion/curve.h"
#include "synth/motion/motion.h"
#include "synth/motion/path_description.h"

namespace cvo::synth {

// The properties of a body that its path depends on.
struct BodyShape {
  double half_height_m = 0.0;
  double rolling_radius_m = 0.0;  // > 0: rolls on its route without slipping
};

// Throws Error if a route has coincident points or a cusp, or is shorter than the distance
// travelled in `duration_s`.
std::shared_ptr<const Motion> MakeMotion(const PathDescription& path, const BodyShape& body,
                                         double duration_s);

// Travel along a route in the plane: the curve, offset to the left, and the distance over time.
class RouteTravel {
 public:
  RouteTravel(const RouteDescription& route, double duration_s);

  struct State {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();   // z is zero
    Eigen::Vector3d per_metre = Eigen::Vector3d::Zero();  // d position / d distance
    double yaw_rad = 0.0;                                 // of the route's direction
    double yaw_per_metre = 0.0;                           // rad/m
  };
  double Way_m(double time_s) const { return speed_.Way_m(time_s); }  // distance since time zero
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
