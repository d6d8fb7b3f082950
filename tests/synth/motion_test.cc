// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/motion/motion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "synth/scene/description.h"
#include "tests/support/error_message.h"
#include "tests/synth/worlds.h"

namespace cvo::synth {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

std::vector<Vector3d> Bent() { return {{0, 0, 0}, {2, 0.5, 0}, {3, 2, 0}, {2.5, 4, 0}, {0, 5, 0}}; }
std::vector<Vector3d> Square() { return {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}; }

std::vector<Curve> Curves() {
  return {Curve::Through(Bent(), false, ""), Curve::Through(Square(), true, ""),
          Curve::Rounded(Bent(), false, 0.6, ""), Curve::Rounded(Square(), true, 1.0, "")};
}

// Curves are parametrised by arc length: the tangent is the derivative of the position, of unit
// length, and the curvature that of the tangent. Both are continuous across pieces.
TEST(Curve, HasDerivativesByArcLength) {
  for (const Curve& curve : Curves()) {
    const double h = 1e-5;
    for (double s = 2 * h; s < curve.length_m() - 2 * h; s += 0.0371) {
      const CurvePoint before = curve.At(s - h), at = curve.At(s), behind = curve.At(s + h);
      EXPECT_NEAR(at.tangent.norm(), 1.0, 1e-12);
      EXPECT_LT(((behind.position - before.position) / (2 * h) - at.tangent).norm(), 1e-7);
      EXPECT_LT(((behind.tangent - before.tangent) / (2 * h) - at.curvature).norm(), 1e-5);
      EXPECT_LT((behind.curvature - before.curvature).norm(), 1e-2);
    }
  }
}

TEST(Curve, ApproximatesACircle) {
  std::vector<Vector3d> points;
  for (int i = 0; i < 24; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 24;
    points.emplace_back(2.0 * std::cos(angle), 2.0 * std::sin(angle), 1.0);
  }
  const Curve circle = Curve::Through(points, true, "");
  EXPECT_NEAR(circle.length_m(), 4.0 * std::numbers::pi, 1e-5);
  EXPECT_NEAR(circle.At(1.234).curvature.norm(), 0.5, 1e-4);
}

TEST(Curve, RoundedCornersKeepToTheLegs) {
  const Curve curve = Curve::Rounded(Square(), true, 1.0, "");
  EXPECT_LT(curve.length_m(), 16.0);
  EXPECT_GT(curve.length_m(), 14.0);
  for (double s = 0.0; s < curve.length_m(); s += 0.05) {
    const Vector3d p = curve.At(s).position;
    const bool on_a_leg = std::min({std::abs(p.x()), std::abs(p.x() - 4), std::abs(p.y()),
                                    std::abs(p.y() - 4)}) < 1e-9;
    const bool at_a_corner = (Vector3d(2, 2, 0) - p).cwiseAbs().head<2>().minCoeff() > 1.0 - 1e-9;
    EXPECT_TRUE(on_a_leg || at_a_corner) << p.transpose();
    EXPECT_LT(curve.At(s).curvature.norm(), 1.4);  // 1 on a circular arc
  }
}

TEST(Curve, RefusesInvalidCurves) {
  EXPECT_THAT(ErrorMessage([] {
                Curve::Through({{0, 0, 0}, {0, 0, 0}}, false, "here");
              }),
              HasSubstr("here: found points 0 and 1 at the same place"));
  EXPECT_THAT(ErrorMessage([] {
                Curve::Through({{0, 0, 0}, {1, 0, 0}}, true, "here");
              }),
              HasSubstr("at least 3"));
  EXPECT_THAT(ErrorMessage([] {
                Curve::Rounded({{0, 0, 0}, {1, 0, 0}, {0, 0.01, 0}}, false, 0.1, "here");
              }),
              HasSubstr("turn back at point 1"));
}

TEST(SpeedProfile, EasesBetweenKnots) {
  const SpeedProfile profile({{1.0, 0.5}, {2.0, 0.0}, {3.0, 0.0}, {5.0, 1.0}});
  EXPECT_DOUBLE_EQ(profile.Speed_mps(0.0), 0.5);
  EXPECT_DOUBLE_EQ(profile.Speed_mps(1.5), 0.25);
  EXPECT_DOUBLE_EQ(profile.Speed_mps(2.5), 0.0);
  EXPECT_DOUBLE_EQ(profile.Speed_mps(9.0), 1.0);
  EXPECT_DOUBLE_EQ(profile.Way_m(0.0), 0.0);
  EXPECT_DOUBLE_EQ(profile.Way_m(1.0), 0.5);
  EXPECT_DOUBLE_EQ(profile.Way_m(3.0), 0.75);
  EXPECT_DOUBLE_EQ(profile.Way_m(6.0), 2.75);
  EXPECT_DOUBLE_EQ(profile.Way_m(-1.0), -0.5);
}

constexpr BodyShape kChair = {0.45, 0.0};
constexpr BodyShape kBall = {0.25, 0.25};

constexpr char kRoute[] = R"({"route": {"points": [[0, 0], [1, 0.3], [1.5, 1.5], [0.5, 2.5]],
    "speed_mps": [[0, 0.2], [1, 0.8], [2, 0], [3, 0], [4, 0.6]]}})";
constexpr char kLoop[] = R"({"route": {"points": [[1, 0], [0, 1], [-1, 0], [0, -1]],
    "closed": true, "speed_mps": 0.9, "lateral_m": 0.3}})";
constexpr char kSwing[] = R"({"swing": {"pivot": [1, 2, 2.5], "length_m": 1.2, "amplitude_deg": 25,
    "period_s": 2.2, "phase_deg": 30, "plane_deg": 40, "heading_deg": 10,
    "twist": {"amplitude_deg": 50, "period_s": 3.1}}})";

std::shared_ptr<const Motion> Make(const std::string& path, const BodyShape& body,
                                   double duration_s = 4.0) {
  const Json json = ParseJson(path, "path");
  return MakeMotion(ParsePath(ObjectReader(json, "test", "path")), body, duration_s);
}

std::shared_ptr<const Motion> MakeCamera(const std::string& look) {
  const Json json = ParseJson(R"({"route": {"points": [[0, 0], [1, 0.3], [1.5, 1.5]],
      "speed_mps": 0.4}, "height_m": 1.3, "shake": {"translation_m": 0.01, "rotation_deg": 3},)" +
                                  look + "}",
                              "camera");
  return MakeCameraMotion(ParseCamera(ObjectReader(json, "test", "camera")), 4.0, 7);
}

// Expects the velocities to be the derivatives of the pose, and differentiable themselves.
void ExpectTwiceDifferentiable(const Motion& motion) {
  const double h = 1e-5;
  for (double t = 0.1; t < 3.9; t += 0.0171) {
    const MotionState before = motion.At(t - h), at = motion.At(t), behind = motion.At(t + h);
    const Vector3d velocity =
        (behind.world_from_body.translation() - before.world_from_body.translation()) / (2 * h);
    EXPECT_LT((velocity - at.velocity_in_world).norm(), 1e-6) << t;
    const Vector3d turning =
        LogSo3(behind.world_from_body.rotation() * before.world_from_body.rotation().conjugate()) /
        (2 * h);
    EXPECT_LT((turning - at.angular_velocity_in_world).norm(), 1e-5) << t;
    const auto change = [h](const Vector3d& from, const Vector3d& to) -> Vector3d {
      return (to - from) / h;
    };
    EXPECT_LT((change(before.velocity_in_world, at.velocity_in_world) -
               change(at.velocity_in_world, behind.velocity_in_world))
                  .norm(),
              1e-2)
        << t;
    EXPECT_LT((change(before.angular_velocity_in_world, at.angular_velocity_in_world) -
               change(at.angular_velocity_in_world, behind.angular_velocity_in_world))
                  .norm(),
              5e-2)
        << t;
  }
}

TEST(Motion, VelocitiesAreDerivatives) {
  ExpectTwiceDifferentiable(*Make(kRoute, kChair));
  ExpectTwiceDifferentiable(*Make(kRoute, kBall));
  ExpectTwiceDifferentiable(*Make(kLoop, kChair));
  ExpectTwiceDifferentiable(*Make(kLoop, kBall));
  ExpectTwiceDifferentiable(*Make(kSwing, kChair));
  ExpectTwiceDifferentiable(
      *MakeCamera(R"("look_at": {"points": [[3, 0, 1], [3, 2, 0.5], [2, 3, 1]]})"));
  ExpectTwiceDifferentiable(*MakeCamera(
      R"("look_along": {"pitch_deg": -10, "pan": {"amplitude_deg": 20, "period_s": 3}})"));
}

TEST(Motion, StandsOnTheGroundByDefault) {
  const auto ground = Make(R"({"still": {"at": [1, 2], "heading_deg": 90}})", kChair);
  EXPECT_TRUE(ground->At(1).world_from_body.translation().isApprox(Vector3d(1, 2, 0.45)));
  EXPECT_TRUE((ground->At(1).world_from_body.rotation() * Vector3d::UnitX())
                  .isApprox(Vector3d::UnitY(), 1e-12));
  const auto above = Make(R"({"still": {"at": [1, 2, 3]}})", kChair);
  EXPECT_EQ(above->At(1).world_from_body.translation().z(), 3.0);
}

TEST(Motion, HeadsAlongItsRoute) {
  const auto car = Make(R"({"route": {"points": [[0, 0], [0, 50]], "speed_mps": 10, "start_m": 5,
                            "lateral_m": 2}})",
                        kChair);
  const MotionState state = car->At(1.0);
  EXPECT_TRUE(state.world_from_body.translation().isApprox(Vector3d(-2, 15, 0.45), 1e-9));
  EXPECT_TRUE(state.velocity_in_world.isApprox(Vector3d(0, 10, 0), 1e-9));
  EXPECT_TRUE(
      (state.world_from_body.rotation() * Vector3d::UnitX()).isApprox(Vector3d::UnitY(), 1e-9));
}

// The point where the ball touches the floor has zero velocity.
TEST(Rolling, DoesNotSlip) {
  const auto ball = Make(kLoop, kBall);
  for (double t = 0.0; t < 4.0; t += 0.1) {
    const MotionState state = ball->At(t);
    const Vector3d contact =
        state.velocity_in_world + state.angular_velocity_in_world.cross(Vector3d(0, 0, -0.25));
    EXPECT_LT(contact.norm(), 1e-12);
  }
}

TEST(Swing, HangsFromItsPivot) {
  const auto block = Make(kSwing, kChair);
  const RigidTransform start = block->At(0.0).world_from_body;
  const RigidTransform later = block->At(0.7).world_from_body;
  const Vector3d pivot(1, 2, 2.5);
  EXPECT_NEAR((start.translation() - pivot).norm(), 1.2, 1e-12);
  // The string is always along the z axis of the body.
  EXPECT_LT((later.Inverse() * pivot - Vector3d(0, 0, 1.2)).norm(), 1e-12);
  const Vector3d out = start.translation() - pivot;
  EXPECT_NEAR(std::atan2(out.y(), out.x()), 40.0 * std::numbers::pi / 180.0, 1e-9);
}

TEST(CameraMotion, LooksAtItsTargetWithoutRoll) {
  const Json json = ParseJson(R"({"route": {"points": [[0, 0], [1, 0.3], [1.5, 1.5]],
      "speed_mps": 0.4}, "height_m": 1.3, "look_at": {"points": [[3, 1, 0.4]]}})",
                              "camera");
  const auto camera = MakeCameraMotion(ParseCamera(ObjectReader(json, "test", "camera")), 4.0, 7);
  for (double t = 0.0; t < 4.0; t += 0.5) {
    const RigidTransform world_from_left = camera->At(t).world_from_body;
    const Vector3d target = world_from_left.Inverse() * Vector3d(3, 1, 0.4);
    EXPECT_LT(target.head<2>().norm(), 1e-9);
    EXPECT_GT(target.z(), 1.0);
    EXPECT_NEAR((world_from_left.rotation() * Vector3d::UnitX()).z(), 0.0, 1e-12);
    EXPECT_LT((world_from_left.rotation() * Vector3d::UnitY()).z(), 0.0);
    EXPECT_EQ(world_from_left.translation().z(), 1.3);
  }
}

TEST(Motion, RefusesARouteThatIsTooShort) {
  EXPECT_THAT(ErrorMessage([] {
                Make(R"({"route": {"points": [[0, 0], [3, 0]], "speed_mps": 1}})", kChair);
              }),
              HasSubstr("test, path.route: found a route of 3 m for a way up to 4 m at 4 s"));
}

}  // namespace
}  // namespace cvo::synth
