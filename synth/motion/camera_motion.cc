// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/motion/camera_motion.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "synth/motion/paths.h"

namespace cvo::synth {
namespace {

using Eigen::Vector3d;

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

std::shared_ptr<const Motion> MakeCameraMotion(const CameraDescription& camera, double duration_s,
                                               std::uint64_t look_seed) {
  const LookAt* target = std::get_if<LookAt>(&camera.look);
  Gaze gaze =
      target != nullptr ? Gaze(*target, duration_s) : Gaze(std::get<LookAlong>(camera.look));
  return std::make_shared<CameraMotion>(camera, std::move(gaze), duration_s,
                                        Rng(look_seed, "camera/shake"));
}

}  // namespace cvo::synth
