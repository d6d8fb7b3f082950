// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/motion/paths.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/error.h"
#include "synth/motion/rolling.h"

namespace cvo::synth {
namespace {

using Eigen::Vector3d;

Eigen::Quaterniond Yaw(double angle_rad) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, Vector3d::UnitZ()));
}

class StillMotion final : public Motion {
 public:
  explicit StillMotion(const RigidTransform& world_from_body)
      : state_{world_from_body, Vector3d::Zero(), Vector3d::Zero()} {}
  MotionState At(double) const override { return state_; }

 private:
  MotionState state_;
};

class DrivingMotion final : public Motion {
 public:
  DrivingMotion(RouteTravel travel, double height_m, HeadingDescription heading)
      : travel_(std::move(travel)), height_m_(height_m), heading_(heading) {}

  MotionState At(double time_s) const override {
    const RouteTravel::State at = travel_.At(travel_.Way_m(time_s));
    const double speed = travel_.Speed_mps(time_s);
    double yaw = heading_.offset_rad + heading_.spin_radps * time_s;
    double rate = heading_.spin_radps;
    if (heading_.along) {
      yaw += at.yaw_rad;
      rate += at.yaw_per_metre * speed;
    }
    return {RigidTransform(Yaw(yaw), Vector3d(at.position + height_m_ * Vector3d::UnitZ())),
            speed * at.per_metre, rate * Vector3d::UnitZ()};
  }

 private:
  RouteTravel travel_;
  double height_m_;
  HeadingDescription heading_;
};

class SwingMotion final : public Motion {
 public:
  explicit SwingMotion(const SwingDescription& swing) : swing_(swing) {}

  MotionState At(double time_s) const override {
    const Swinging out = synth::At(swing_.swing, time_s);
    const Swinging twist = synth::At(swing_.twist, time_s);
    // A positive angle lifts the body towards the direction `plane_rad`.
    const Vector3d axis(std::sin(swing_.plane_rad), -std::cos(swing_.plane_rad), 0.0);
    const Eigen::Quaterniond tilt(Eigen::AngleAxisd(out.angle_rad, axis));
    const Vector3d arm = tilt * Vector3d(0.0, 0.0, -swing_.length_m);
    const Vector3d tilt_rate = out.rate_radps * axis;
    return {RigidTransform(tilt * Yaw(swing_.heading_rad + twist.angle_rad),
                           Vector3d(swing_.pivot + arm)),
            tilt_rate.cross(arm), tilt_rate + twist.rate_radps * (tilt * Vector3d::UnitZ())};
  }

 private:
  SwingDescription swing_;
};

Curve MakeCurve(const RouteDescription& route) {
  std::vector<Vector3d> points;
  for (const Eigen::Vector2d& point : route.points) points.emplace_back(point.x(), point.y(), 0.0);
  if (route.corner_m) return Curve::Rounded(points, route.closed, *route.corner_m, route.where);
  return Curve::Through(points, route.closed, route.where);
}

struct MakeMotionVisitor {
  const BodyShape& body;
  double duration_s;

  std::shared_ptr<const Motion> operator()(const StillDescription& still) const {
    const double height_m = still.centre_m.value_or(body.half_height_m);
    return std::make_shared<StillMotion>(
        RigidTransform(Yaw(still.heading_rad), Vector3d(still.at.x(), still.at.y(), height_m)));
  }
  std::shared_ptr<const Motion> operator()(const RouteDescription& route) const {
    RouteTravel travel(route, duration_s);
    const double height_m = route.bottom_m + body.half_height_m;
    if (body.rolling_radius_m > 0.0) {
      return std::make_shared<RollingMotion>(std::move(travel), body.rolling_radius_m, height_m,
                                             duration_s);
    }
    return std::make_shared<DrivingMotion>(std::move(travel), height_m, route.heading);
  }
  std::shared_ptr<const Motion> operator()(const SwingDescription& swing) const {
    return std::make_shared<SwingMotion>(swing);
  }
};

}  // namespace

RouteTravel::RouteTravel(const RouteDescription& route, double duration_s)
    : curve_(MakeCurve(route)),
      speed_(route.speed),
      start_m_(route.start_m),
      lateral_m_(route.lateral_m) {
  const double end_m = start_m_ + Way_m(duration_s);
  if (!curve_.closed() && end_m > curve_.length_m()) {
    ThrowError(route.where,
               StrCat("a route of ", curve_.length_m(), " m for a way up to ", end_m, " m at ",
                      duration_s, " s"),
               "a route that is long enough, or a speed that comes to 0 before its end");
  }
}

RouteTravel::State RouteTravel::At(double way_m) const {
  const CurvePoint at = curve_.At(start_m_ + way_m);
  const Vector3d left = Vector3d::UnitZ().cross(at.tangent);
  return {at.position + lateral_m_ * left,
          at.tangent + lateral_m_ * Vector3d::UnitZ().cross(at.curvature),
          std::atan2(at.tangent.y(), at.tangent.x()), left.dot(at.curvature)};
}

Swinging At(const Oscillation& oscillation, double time_s) {
  const double frequency = 2.0 * std::numbers::pi / oscillation.period_s;
  const double phase = frequency * time_s + oscillation.phase_rad;
  return {oscillation.amplitude_rad * std::sin(phase),
          oscillation.amplitude_rad * frequency * std::cos(phase)};
}

std::shared_ptr<const Motion> MakeMotion(const PathDescription& path, const BodyShape& body,
                                         double duration_s) {
  return std::visit(MakeMotionVisitor{body, duration_s}, path);
}

}  // namespace cvo::synth
