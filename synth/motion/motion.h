// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/geometry/rigid_transform.h"

namespace cvo::synth {

// Pose and velocity of something at one instant. In the scene's world, z is up; lengths in metres.
struct MotionState {
  RigidTransform world_from_body;
  Eigen::Vector3d velocity_in_world = Eigen::Vector3d::Zero();          // of the body's origin, m/s
  Eigen::Vector3d angular_velocity_in_world = Eigen::Vector3d::Zero();  // rad/s
};

// A twice-differentiable path. The state depends only on the time, not on earlier calls.
class Motion {
 public:
  virtual ~Motion() = default;
  virtual MotionState At(double time_s) const = 0;
};

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

// A point of a curve, with derivatives by its arc length s.
struct CurvePoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d tangent = Eigen::Vector3d::UnitX();   // d position / ds, unit length
  Eigen::Vector3d curvature = Eigen::Vector3d::Zero();  // d tangent / ds, 1/m
};

// A space curve parametrised by arc length, smooth enough for a differentiable curvature. An open
// curve continues straight beyond its ends; a closed one repeats.
class Curve {
 public:
  // The quintic spline through the points (chord-length parametrisation), four times
  // differentiable. One point gives a curve of length zero. Throws Error for coincident points and
  // for a cusp.
  static Curve Through(const std::vector<Eigen::Vector3d>& points, bool closed,
                       const std::string& where);
  // Straight legs between the points. A bend within the triangle of each corner replaces it from
  // `corner_m` before to `corner_m` after the corner (less if a leg is short).
  static Curve Rounded(const std::vector<Eigen::Vector3d>& points, bool closed, double corner_m,
                       const std::string& where);

  double length_m() const { return arc_m_.back(); }
  bool closed() const { return closed_; }
  CurvePoint At(double s_m) const;

 private:
  // Columns: coefficients of u^0 ... u^7, u from 0 to 1.
  using Piece = Eigen::Matrix<double, 3, 8>;

  Curve(std::vector<Piece> pieces, bool closed, const std::string& where);
  static std::vector<Piece> SplinePieces(const std::vector<Eigen::Vector3d>& points, bool closed);
  static Piece Line(const Eigen::Vector3d& from, const Eigen::Vector3d& to);
  static Piece Bend(const Eigen::Vector3d& corner, const Eigen::Vector3d& from,
                    const Eigen::Vector3d& to);

  std::vector<Piece> pieces_;
  std::vector<double> arc_m_;  // at the start of each cell of each piece, and at the end
  bool closed_ = false;
};

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

// Returns world_from_left along the camera's route, without roll except for the shake, which
// `look_seed` determines. Throws Error if the route is shorter than the distance travelled.
std::shared_ptr<const Motion> MakeCameraMotion(const CameraDescription& camera, double duration_s,
                                               std::uint64_t look_seed);

}  // namespace cvo::synth
