// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>

#include "core/base/options.h"
#include "core/geometry/rigid_transform.h"

namespace cvo {

struct MotionPriorOptions {
  double q_m2_s3 = 1.0;
  double q_m2_frame3 = 0.01;
  double turn_q_rad2_s3 = 0.03;
  double turn_rate_rad_s = 0.5;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("q_m2_s3", self.q_m2_s3,
                {"m^2/s^3", 1e-6, 1e6,
                 "power density of a body's acceleration: smaller smooths more and follows turns "
                 "and braking later; one value for every frame rate",
                 "METHOD.md 8.2: chosen from 0.01 ... 300 on 10 Hz and 30 Hz data"});
    visit.Field("q_m2_frame3", self.q_m2_frame3,
                {"m^2/frame^3", 1e-9, 1e6,
                 "power density of a body's acceleration with the frame as the unit of time; used "
                 "by variants that read the paper's value this way",
                 "paper, section 4.1"});
    visit.Field(
        "turn_q_rad2_s3", self.turn_q_rad2_s3,
        {"rad^2/s^3", 1e-6, 1e6,
         "power density of a body's angular acceleration: smaller smooths rotation more",
         "chosen from 0.01 ... 0.3 on 10 Hz and 30 Hz data: little changes between 0.1 and 0.01"});
    visit.Field("turn_rate_rad_s", self.turn_rate_rad_s,
                {"rad/s", 1e-3, 1e6,
                 "angular velocity at which that density is doubled: the axis of a body that rolls "
                 "turns with its path; larger smooths fast turns more",
                 "METHOD.md 8.3: chosen from 0.25 ... 2 on rooms with bodies at 1.6 m/s"});
  }
};

// Returns the power density, in rad^2/s^3, of the angular acceleration of a body that turns at
// `rate_rad_s` (METHOD.md 8.3).
inline double TurnDensity(const MotionPriorOptions& options, double rate_rad_s) {
  const double relative = rate_rad_s / options.turn_rate_rad_s;
  return options.turn_q_rad2_s3 * (1.0 + relative * relative);
}

// Ties the states of a body together in time. kLinksFrames: the solver applies a motion prior on
// positions and estimates velocities. kLinksOrientations: it applies one on the change of angular
// velocity. PowerDensity: q in m^2/s^3 for a step of dt_s, also used for predictions.
template <typename Policy>
concept MotionPriorPolicy = requires(const MotionPriorOptions& options, double dt_s) {
  { Policy::kLinksFrames } -> std::convertible_to<bool>;
  { Policy::kLinksOrientations } -> std::convertible_to<bool>;
  { Policy::PowerDensity(options, dt_s) } -> std::same_as<double>;
};

// Policy: white noise on the acceleration of the origin (section 3.3 of the paper), with q in
// seconds.
struct WhiteNoiseOnTranslation {
  static constexpr bool kLinksFrames = true;
  static constexpr bool kLinksOrientations = false;
  static double PowerDensity(const MotionPriorOptions& options, double) { return options.q_m2_s3; }
};
// Policy: the same, with q per frame, as the paper's 0.01, which has no unit, can be read
// (METHOD.md 8.2).
struct WhiteNoiseOnAccelerationFrameUnits {
  static constexpr bool kLinksFrames = true;
  static constexpr bool kLinksOrientations = false;
  static double PowerDensity(const MotionPriorOptions& options, double dt_s) {
    return options.q_m2_frame3 / (dt_s * dt_s * dt_s);
  }
};
// Policy: no prior, frames are independent; velocities are differences of the solved positions.
struct NoMotionPrior {
  static constexpr bool kLinksFrames = false;
  static constexpr bool kLinksOrientations = false;
  static double PowerDensity(const MotionPriorOptions& options, double) { return options.q_m2_s3; }
};
// Policy: `Prior`, with white noise on the angular acceleration in addition (METHOD.md 8.3).
template <MotionPriorPolicy Prior>
struct WithTurnPrior : Prior {
  static constexpr bool kLinksOrientations = true;
};
using WhiteNoiseOnAcceleration = WithTurnPrior<WhiteNoiseOnTranslation>;

// White-noise-on-acceleration prior between two states dt_s apart (Eq. 12 of the paper; METHOD.md
// 8.2): e = (t+ - t - dt v, v+ - v), ||r||^2 = e^T Qhat^-1 e with
//   r = (displacement (t+ - t) - velocity (v+ + v), change (v+ - v)),
// so that these factors make up the Jacobians with respect to t, v, t+ and v+.
struct MotionPriorFactors {
  double displacement = 0.0;  // 1/m
  double velocity = 0.0;      // s/m
  double change = 0.0;        // s/m
};
MotionPriorFactors WhitenMotionPrior(double power_density_m2_s3, double dt_s);

Vector6d EvaluateMotionPrior(const MotionPriorFactors& factors, const Eigen::Vector3d& t,
                             const Eigen::Vector3d& v, const Eigen::Vector3d& next_t,
                             const Eigen::Vector3d& next_v);
// Jacobian for one axis: of (r_k, r_{3+k}) with respect to (t_k, v_k, t+_k, v+_k).
Eigen::Matrix<double, 2, 4> MotionPriorAxisJacobian(const MotionPriorFactors& factors);

// White noise on the angular acceleration, for three consecutive orientations world_from_object:
//   r = (w_b - w_a) / sqrt(q (dt_a + dt_b) / 3),  w = Log(R+ R^-1) / dt in world.
// The variance is that of the change of the mean rate from one step to the next. Jacobians are with
// respect to rotations about world axes, applied from the left.
struct TurnPrior {
  Eigen::Vector3d r;
  std::array<Eigen::Matrix3d, 3> J;
};
TurnPrior EvaluateTurnPrior(double power_density_rad2_s3, const std::array<double, 2>& dt_s,
                            const std::array<Eigen::Quaterniond, 3>& world_from_object);

}  // namespace cvo
