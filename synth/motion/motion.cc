// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/motion/motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/rng.h"

namespace cvo::synth {
namespace {

using Eigen::Vector3d;

// A step from 0 to 1 whose first two derivatives vanish at both ends, and its integral from 0.
double Ease(double x) { return x * x * x * (10.0 + x * (-15.0 + 6.0 * x)); }
double EaseIntegral(double x) { return x * x * x * x * (2.5 + x * (-3.0 + x)); }

// A ball that rolls on a plane along a route without slipping: omega = n x v / r. Its orientation
// depends only on the distance travelled. It is tabulated in steps of at most 1 cm and integrated
// from the nearest one.
class RollingMotion final : public Motion {
 public:
  RollingMotion(RouteTravel travel, double radius_m, double height_m, double duration_s)
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

  MotionState At(double time_s) const override {
    const double way = travel_.Way_m(time_s);
    const RouteTravel::State at = travel_.At(way);
    const Vector3d velocity = travel_.Speed_mps(time_s) * at.per_metre;
    return {RigidTransform(Orientation(way), Vector3d(at.position + height_m_ * Vector3d::UnitZ())),
            velocity, Vector3d::UnitZ().cross(velocity) / radius_m_};
  }

 private:
  // Rotation per distance, rad/m, in world.
  Vector3d TurnPerMetre(double way_m) const {
    return Vector3d::UnitZ().cross(travel_.At(way_m).per_metre) / radius_m_;
  }

  // Rotation between two distances that are at most one step apart: fourth-order Magnus expansion
  // at the two Gauss-Legendre nodes.
  Eigen::Quaterniond Turn(double from_m, double to_m) const {
    const double h = to_m - from_m;
    const double middle = 0.5 * (from_m + to_m);
    const double offset = h * std::sqrt(3.0) / 6.0;
    const Vector3d w1 = TurnPerMetre(middle - offset);
    const Vector3d w2 = TurnPerMetre(middle + offset);
    return ExpSo3(0.5 * h * (w1 + w2) - std::sqrt(3.0) / 12.0 * h * h * w1.cross(w2));
  }

  Eigen::Quaterniond Orientation(double way_m) const {
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

  RouteTravel travel_;
  double radius_m_;
  double height_m_;
  double step_m_;
  std::vector<Eigen::Quaterniond> table_;  // world_from_body at distance index * step_m_
};

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

// Viewing direction as angles, with their rates.
struct ViewAngles {
  double yaw_rad = 0.0;
  double yaw_rate_radps = 0.0;
  double pitch_rad = 0.0;  // up
  double pitch_rate_radps = 0.0;
};

// An offset of at most 1 per axis: the sum of three sines whose frequencies have no common period.
class Shaking {
 public:
  Shaking(double frequency_hz, Rng& rng) {
    constexpr std::array<double, kSines> kRatios = {0.61803, 1.0, 1.5275};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t k = 0; k < kSines; ++k) {
        const double ratio = kRatios[k] * rng.Uniform(0.9, 1.1);
        sines_[axis][k] = {kAmplitudes[k], 1.0 / (frequency_hz * ratio),
                           rng.Uniform(0.0, 2.0 * std::numbers::pi)};
      }
    }
  }

  struct Offset {
    Vector3d value = Vector3d::Zero();
    Vector3d rate = Vector3d::Zero();
  };
  Offset At(double time_s) const {
    Offset offset;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const Oscillation& sine : sines_[axis]) {
        const Swinging at = synth::At(sine, time_s);
        offset.value[static_cast<Eigen::Index>(axis)] += at.angle_rad;
        offset.rate[static_cast<Eigen::Index>(axis)] += at.rate_radps;
      }
    }
    return offset;
  }

 private:
  static constexpr std::size_t kSines = 3;
  static constexpr std::array<double, kSines> kAmplitudes = {0.3, 0.5, 0.2};
  std::array<std::array<Oscillation, kSines>, 3> sines_;
};

// Viewing direction of the camera: at a moving target, or along its route.
class Gaze {
 public:
  Gaze(const LookAt& look, double duration_s)
      : target_(Curve::Through(look.points, false, look.where)),
        target_mps_(target_->length_m() / duration_s) {}
  explicit Gaze(const LookAlong& look) : along_(look) {}

  // `position` and `velocity` are those of the camera, `route` is its state on the route.
  ViewAngles At(double time_s, const Vector3d& position, const Vector3d& velocity,
                const RouteTravel::State& route, double speed_mps) const {
    if (target_) return Towards(time_s, position, velocity);
    const Swinging pan = synth::At(along_.pan, time_s);
    return {route.yaw_rad + along_.yaw_rad + pan.angle_rad,
            route.yaw_per_metre * speed_mps + pan.rate_radps, along_.pitch_rad, 0.0};
  }

 private:
  ViewAngles Towards(double time_s, const Vector3d& position, const Vector3d& velocity) const {
    const CurvePoint target = target_->At(target_mps_ * time_s);
    const Vector3d way = target.position - position;
    const Vector3d rate = target_mps_ * target.tangent - velocity;
    const double level = way.head<2>().norm();
    Require(level > 1e-3, "a camera does not look straight up or down");
    const double level_rate = way.head<2>().dot(rate.head<2>()) / level;
    return {std::atan2(way.y(), way.x()),
            (way.x() * rate.y() - way.y() * rate.x()) / (level * level), std::atan2(way.z(), level),
            (rate.z() * level - way.z() * level_rate) / way.squaredNorm()};
  }

  std::optional<Curve> target_;
  double target_mps_ = 0.0;
  LookAlong along_;
};

// Returns world_from_camera without roll; the camera axes are x right, y down, z forward.
Eigen::Matrix3d LevelRotation(double yaw_rad, double pitch_rad) {
  const double cy = std::cos(yaw_rad), sy = std::sin(yaw_rad);
  const double cp = std::cos(pitch_rad), sp = std::sin(pitch_rad);
  Eigen::Matrix3d world_from_camera;
  world_from_camera << sy, sp * cy, cp * cy, -cy, sp * sy, cp * sy, 0.0, -cp, sp;
  return world_from_camera;
}

class CameraMotion final : public Motion {
 public:
  CameraMotion(const CameraDescription& camera, Gaze gaze, double duration_s, Rng rng)
      : travel_(camera.route, duration_s),
        height_m_(camera.height_m),
        gaze_(std::move(gaze)),
        shake_(camera.shake),
        translation_(shake_.frequency_hz, rng),
        rotation_(shake_.frequency_hz, rng) {}

  MotionState At(double time_s) const override {
    const RouteTravel::State route = travel_.At(travel_.Way_m(time_s));
    const double speed = travel_.Speed_mps(time_s);
    const Vector3d position = route.position + height_m_ * Vector3d::UnitZ();
    const Vector3d velocity = speed * route.per_metre;
    const ViewAngles view = gaze_.At(time_s, position, velocity, route, speed);
    const Eigen::Matrix3d level = LevelRotation(view.yaw_rad, view.pitch_rad);
    const Shaking::Offset moved = translation_.At(time_s);
    const Shaking::Offset turned = rotation_.At(time_s);
    const Vector3d turn = shake_.rotation_rad * turned.value;
    // The left Jacobian of SO(3) is the right Jacobian of the inverse rotation.
    const Vector3d turn_rate = RightJacobianSo3(-turn) * (shake_.rotation_rad * turned.rate);
    return {RigidTransform(Eigen::Quaterniond(level) * ExpSo3(turn),
                           Vector3d(position + shake_.translation_m * moved.value)),
            velocity + shake_.translation_m * moved.rate,
            view.yaw_rate_radps * Vector3d::UnitZ() + view.pitch_rate_radps * level.col(0) +
                level * turn_rate};
  }

 private:
  RouteTravel travel_;
  double height_m_;
  Gaze gaze_;
  ShakeDescription shake_;
  Shaking translation_;
  Shaking rotation_;
};

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
  if (const auto* still = std::get_if<StillDescription>(&path)) {
    const double height_m = still->centre_m.value_or(body.half_height_m);
    return std::make_shared<StillMotion>(
        RigidTransform(Yaw(still->heading_rad), Vector3d(still->at.x(), still->at.y(), height_m)));
  }
  if (const auto* swing = std::get_if<SwingDescription>(&path)) {
    return std::make_shared<SwingMotion>(*swing);
  }
  const auto& route = std::get<RouteDescription>(path);
  RouteTravel travel(route, duration_s);
  const double height_m = route.bottom_m + body.half_height_m;
  if (body.rolling_radius_m > 0.0) {
    return std::make_shared<RollingMotion>(std::move(travel), body.rolling_radius_m, height_m,
                                           duration_s);
  }
  return std::make_shared<DrivingMotion>(std::move(travel), height_m, route.heading);
}

std::shared_ptr<const Motion> MakeCameraMotion(const CameraDescription& camera, double duration_s,
                                               std::uint64_t look_seed) {
  const LookAt* target = std::get_if<LookAt>(&camera.look);
  Gaze gaze =
      target != nullptr ? Gaze(*target, duration_s) : Gaze(std::get<LookAlong>(camera.look));
  return std::make_shared<CameraMotion>(camera, std::move(gaze), duration_s,
                                        Rng(look_seed, "camera/shake"));
}

}  // namespace cvo::synth
