// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "synth/motion/speed_profile.h"

namespace cvo::synth {

// Paths as described in a scene file, with every key checked. synth/README.md gives units and
// meaning. `where` names file and key, for errors that are detected only when a path is built.

struct HeadingDescription {
  bool along = true;  // relative to the route; otherwise to the x axis of the world
  double offset_rad = 0.0;
  double spin_radps = 0.0;
};

struct RouteDescription {
  std::string where;
  std::vector<Eigen::Vector2d> points;
  bool closed = false;
  std::optional<double> corner_m;  // polyline with rounded corners; otherwise a spline
  std::vector<SpeedProfile::Knot> speed;
  double start_m = 0.0;
  double lateral_m = 0.0;  // offset to the left
  double bottom_m = 0.0;   // height of the body's lowest point
  HeadingDescription heading;
};

struct StillDescription {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  std::optional<double> centre_m;  // height of the body's origin; otherwise it stands on the ground
  double heading_rad = 0.0;
};

struct Oscillation {
  double amplitude_rad = 0.0;
  double period_s = 1.0;
  double phase_rad = 0.0;
};

struct SwingDescription {
  Eigen::Vector3d pivot = Eigen::Vector3d::Zero();
  double length_m = 1.0;  // from the pivot to the body's origin
  Oscillation swing;
  double plane_rad = 0.0;  // direction of the swing, from the x axis of the world
  double heading_rad = 0.0;
  Oscillation twist;  // about the body's z axis
};

using PathDescription = std::variant<StillDescription, RouteDescription, SwingDescription>;

struct LookAt {
  std::string where;
  std::vector<Eigen::Vector3d> points;  // traversed at constant speed over the whole sequence
};

struct LookAlong {
  double yaw_rad = 0.0;    // to the left of the route
  double pitch_rad = 0.0;  // up
  Oscillation pan;         // to the left
};

struct ShakeDescription {
  double translation_m = 0.0;
  double rotation_rad = 0.0;
  double frequency_hz = 1.0;
};

struct CameraDescription {
  RouteDescription route;
  double height_m = 1.3;
  std::variant<LookAt, LookAlong> look;
  ShakeDescription shake;
};

}  // namespace cvo::synth
