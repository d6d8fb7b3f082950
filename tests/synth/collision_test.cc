// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "synth/motion/motion.h"
#include "synth/scene/description.h"
#include "synth/scene/world.h"
#include "tests/support/error_message.h"
#include "tests/synth/worlds.h"

namespace cvo::synth {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

CollisionShape BallShape(double radius_m) { return {{}, Vector3d::Zero(), radius_m}; }
CollisionShape BoxShape(const Vector3d& half) { return {{}, half, 0.0}; }

RigidTransform At(const Vector3d& place, double yaw_rad = 0.0) {
  return {ExpSo3({0, 0, yaw_rad}), place};
}

TEST(Separation, OfBallsAndBoxes) {
  const CollisionShape ball = BallShape(0.5);
  const CollisionShape cube = BoxShape({0.5, 0.5, 0.5});
  EXPECT_NEAR(Separation(ball, At({0, 0, 0}), ball, At({1.25, 0, 0})), 0.25, 1e-12);
  EXPECT_NEAR(Separation(ball, At({0, 0, 0}), ball, At({0.75, 0, 0})), -0.25, 1e-12);
  EXPECT_NEAR(Separation(ball, At({1.25, 0, 0}), cube, At({0, 0, 0})), 0.25, 1e-12);
  EXPECT_NEAR(Separation(cube, At({0, 0, 0}), ball, At({0.9, 0.9, 0})), std::sqrt(0.32) - 0.5,
              1e-12);
  EXPECT_NEAR(Separation(cube, At({0, 0, 0}), ball, At({0.4, 0, 0})), -0.6, 1e-12);
  EXPECT_NEAR(Separation(cube, At({0, 0, 0}), cube, At({1.25, 0, 0})), 0.25, 1e-12);
  // Rotated by 45 degrees, the corner reaches sqrt(0.5).
  EXPECT_NEAR(Separation(cube, At({0, 0, 0}), cube, At({1.25, 0, 0}, std::numbers::pi / 4)),
              0.75 - std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(Separation(cube, At({0, 0, 0}), cube, At({1.1, 0, 0}, std::numbers::pi / 4)),
              0.6 - std::sqrt(0.5), 1e-12);
}

// Two crossed bars, each rotated by 45 degrees about its own axis: only the cross product of two
// edges is a separating axis.
TEST(Separation, EdgeAgainstEdge) {
  const CollisionShape bar = BoxShape({1.0, 0.1, 0.1});
  const RigidTransform low(ExpSo3({std::numbers::pi / 4, 0, 0}), Vector3d::Zero());
  const RigidTransform high(
      ExpSo3({0, 0, std::numbers::pi / 2}) * ExpSo3({std::numbers::pi / 4, 0, 0}),
      Vector3d(0, 0, 0.3));
  EXPECT_NEAR(Separation(bar, low, bar, high), 0.3 - 0.2 * std::sqrt(2.0), 1e-9);
}

TEST(Separation, OfPlanes) {
  const Eigen::Vector4d floor(0, 0, 1, 0);
  EXPECT_NEAR(PlaneSeparation(BallShape(0.5), At({0, 0, 0.6}), floor), 0.1, 1e-12);
  const Eigen::Vector4d wall(-1, 0, 0, 2);
  EXPECT_NEAR(PlaneSeparation(BoxShape({0.5, 0.1, 0.1}), At({1.6, 0, 0}), wall), -0.1, 1e-12);
}

Solid Mover(const std::string& name, const std::string& path, const CollisionShape& shape) {
  const Json json = ParseJson(path, name);
  const PathDescription parsed = ParsePath(ObjectReader(json, name, "path"));
  const double half = shape.radius_m > 0 ? shape.radius_m : shape.half_size_m.z();
  return {name, {shape}, MakeMotion(parsed, {half, shape.radius_m}, 4.0), {}};
}

std::string Straight(double x0, double y0, double x1, double y1, double speed_mps) {
  return StrCat(R"({"route": {"points": [[)", x0, ",", y0, "],[", x1, ",", y1,
                R"(]], "speed_mps": )", speed_mps, "}}");
}

std::string Check(const std::vector<Solid>& solids, int threads = 1) {
  const std::vector<Eigen::Vector4d> walls = {{0, 0, 1, 0}, {-1, 0, 0, 5}, {0, 0, -1, 2.5}};
  return ErrorMessage([&] { CheckCollisions(solids, walls, 4.0, threads, "scene x"); });
}

TEST(Collisions, ReportsTheFirstWithItsTime) {
  // Centres 2 m apart closing at 1 m/s: balls of 0.25 m touch at 1.5 s.
  const std::vector<Solid> solids = {Mover("ball_1", Straight(-1, 0, 3, 0, 0.5), BallShape(0.25)),
                                     Mover("ball_2", Straight(1, 0, -3, 0, 0.5), BallShape(0.25)),
                                     Mover("ball_3", Straight(0, 3, 0, -3, 1.0), BallShape(0.25))};
  const std::string message = Check(solids);
  EXPECT_THAT(message, HasSubstr("scene x: found ball_1 and ball_2 overlap by 0.0"));
  EXPECT_THAT(message, HasSubstr(" m at 1.5"));
  EXPECT_EQ(message, Check(solids, 4));
}

TEST(Collisions, PassingCloseIsAllowed) {
  EXPECT_EQ(Check({Mover("ball_1", Straight(-1, 0, 3, 0, 0.5), BallShape(0.25)),
                   Mover("ball_2", Straight(1, 0.502, -3, 0.502, 0.5), BallShape(0.25))}),
            "");
  EXPECT_THAT(Check({Mover("ball_1", Straight(-1, 0, 3, 0, 0.5), BallShape(0.25)),
                     Mover("ball_2", Straight(1, 0.49, -3, 0.49, 0.5), BallShape(0.25))}),
              HasSubstr("ball_1 and ball_2 overlap"));
}

TEST(Collisions, FastBodiesDoNotTunnel) {
  EXPECT_THAT(Check({Mover("dart", Straight(-100, 0, 100, 0, 49), BallShape(0.02)),
                     Mover("pane", R"({"still": {"at": [4, 0]}})", BoxShape({0.02, 0.5, 0.5}))}),
              HasSubstr("dart and pane overlap"));
}

TEST(Collisions, IncludeFurnitureWallsFloorAndCeiling) {
  const Solid shelf{"furniture", {BoxShape({0.3, 0.3, 1.0})}, nullptr, At({0, 0, 1})};
  EXPECT_EQ(Check({shelf, shelf}), "");
  EXPECT_THAT(Check({Mover("ball_1", Straight(-2, 0.4, 3, 0.4, 1), BallShape(0.25)), shelf}),
              HasSubstr("ball_1 and furniture overlap"));
  EXPECT_THAT(Check({Mover("ball_1", Straight(2, 0, 6, 0, 1), BallShape(0.25))}),
              HasSubstr("ball_1 and a wall overlap by 0.0"));
  EXPECT_THAT(Check({Mover("ball_1", R"({"still": {"at": [1, 1, 0.2]}})", BallShape(0.25))}),
              HasSubstr("ball_1 and the floor overlap by 0.050 m at 0.00 s"));
  EXPECT_THAT(Check({Mover("ball_1", R"({"still": {"at": [1, 1, 2.4]}})", BallShape(0.25))}),
              HasSubstr("ball_1 and the ceiling overlap"));
}

TEST(InView, ABodyBehindTheCameraIsAnError) {
  World world;
  world.rig = {450, 450, 319.5, 239.5, 0.12, 640, 480};
  world.frames = 30;
  world.rate_hz = 30;
  const Json camera = EmptyScene()["camera"];
  world.camera = MakeCameraMotion(ParseCamera(ObjectReader(camera, "test", "camera")), 1.0, 0);
  const auto body = [](const std::string& name, const std::string& path) {
    return Body{1, name, "Ball", Vector3d::Constant(0.5),
                Mover(name, path, BallShape(0.25)).motion};
  };
  world.bodies = {body("ball_1", R"({"still": {"at": [0, 0]}})")};
  EXPECT_EQ(ErrorMessage([&] { CheckInView(world, "scene x"); }), "");
  world.bodies.push_back(body("ball_2", R"({"still": {"at": [-3.6, 0]}})"));
  EXPECT_THAT(ErrorMessage([&] { CheckInView(world, "scene x"); }),
              HasSubstr("scene x: found ball_2 never in front of the camera"));
}

}  // namespace
}  // namespace cvo::synth
