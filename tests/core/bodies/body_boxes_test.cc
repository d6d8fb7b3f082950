// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/bodies/body_boxes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/rng.h"
#include "core/bodies/body_place.h"
#include "core/odometry/cluster_update.h"
#include "tests/core/clusters/small_windows.h"

namespace cvo::body_boxes_test {
namespace {

using Eigen::Vector3d;
using test::At;
using test::StateAt;

// A room, seen by a camera 1.2 m above the floor that is tilted down by 0.3 rad. The world frame is
// the camera frame.
struct Room {
  RigidTransform level_from_camera{ExpSo3({-0.3, 0.0, 0.0}), Vector3d(0.0, -1.2, 0.0)};
  Rng rng{1, "room"};
  std::vector<Vector3d> points;

  void Add(int count, const Vector3d& low, const Vector3d& high) {
    for (int i = 0; i < count; ++i) {
      const Vector3d p(rng.Uniform(low.x(), high.x()), rng.Uniform(low.y(), high.y()),
                       rng.Uniform(low.z(), high.z()));
      points.push_back(level_from_camera.Inverse() * p);
    }
  }
  Vector3d Down() const { return level_from_camera.Inverse().rotation() * Vector3d::UnitY(); }
};

TEST(GroundDirection, IsTheNormalOfTheFloorNotOfATable) {
  Room room;
  room.Add(80, {-2.0, -0.005, 2.0}, {2.0, 0.005, 5.0});  // floor
  room.Add(120, {-1.0, -0.75, 2.5}, {1.0, -0.74, 3.5});  // table
  room.Add(150, {-2.5, -2.5, 5.0}, {2.5, 0.0, 5.2});     // wall
  GroundDirection ground(0);
  for (int i = 0; i < 3; ++i) ground.Update(room.points, {});
  EXPECT_GT(ground.Down({}).dot(room.Down()), 0.9998);  // 1 degree
}

TEST(GroundDirection, IsTheCamerasIfNoFloorIsVisible) {
  Room room;
  room.Add(150, {-2.5, -2.5, 5.0}, {2.5, 0.0, 5.2});  // wall
  GroundDirection ground(0);
  const RigidTransform world_from_camera(ExpSo3({0.1, 0.2, 0.0}), Vector3d::Zero());
  EXPECT_EQ(ground.Down(world_from_camera), world_from_camera.rotation() * Vector3d::UnitY());
  ground.Update(room.points, {});
  EXPECT_EQ(ground.Down({}), Vector3d::UnitY());
}

const Vector3d kDown = Vector3d::UnitY();
const Vector3d kCar_m = SizeOfClass("Car");

// A car, or a body of another class, of the size of its class. Provides its detection and points on
// the faces visible to a camera at the origin that looks along z.
struct SeenCar {
  Options options;
  Vector3d size_m;
  StereoFrame frame;
  FeatureGrid grid{{}, test::kCamera};
  ClusterMap map;
  BodyBoxes boxes;
  RigidTransform world_from_car;  // x forward, y down, origin at the centre

  explicit SeenCar(const std::string& category = "Car") : size_m(SizeOfClass(category)) {
    Cluster cluster;
    cluster.id = ClusterId{1};
    cluster.category = category;
    cluster.score = 2.0;
    map.live.push_back(cluster);
  }
  Cluster& cluster() { return map.live.front(); }

  // Simulates frame f, with the car at `pose`. The cluster's frame is rotated and shifted against
  // the car's.
  ClusterReport See(std::int64_t f, const RigidTransform& pose) {
    const RigidTransform car_from_object(ExpSo3({0.3, -0.5, 0.2}), Vector3d(0.4, 0.1, -0.3));
    world_from_car = pose;
    std::vector<ClusterState>& states = cluster().states;
    states.push_back(StateAt(f, pose * car_from_object));
    if (states.size() > 15) states.erase(states.begin());
    cluster().last_observed = cluster().last_detected = FrameId{f};
    cluster().detection = 0;
    ++cluster().detections;
    cluster().landmarks.clear();
    ImageBox box{1e9, 1e9, -1e9, -1e9};
    for (int i = 0; i < 8; ++i) {
      const Vector3d sign((i & 1) - 0.5, ((i >> 1) & 1) - 0.5, ((i >> 2) & 1) - 0.5);
      const Vector3d c = pose * Vector3d(size_m.cwiseProduct(sign));
      const Vector3d z = test::kCamera.Project(c).value();
      box = {std::min(box.left_px, z[0]), std::min(box.top_px, z[1]), std::max(box.right_px, z[0]),
             std::max(box.bottom_px, z[1])};
    }
    // Detectors end the box of a body that the image cuts some way before the border.
    box.right_px = std::min(box.right_px, 0.92 * test::kCamera.width_px + 0.08 * box.left_px);
    frame.detections = {{box, "Car", 2.0}};
    AddFaces(f, pose, car_from_object.Inverse());
    ClusterReport report;
    report.id = ClusterId{1};
    report.world_from_object = cluster().Latest().world_from_object;
    std::vector<ClusterReport> reports = {report};
    const FrameView view{frame, UseDetections::Show(frame), grid, test::kCamera, {}, options};
    boxes.Describe({options, map, &view, FrameId{f}, {}, kDown}, reports);
    return reports.front();
  }

  void AddFaces(std::int64_t f, const RigidTransform& pose, const RigidTransform& object_from_car) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-0.5, 0.5}) {
        const Vector3d outwards = pose.rotation() * Vector3d(side * Vector3d::Unit(axis));
        const Vector3d middle = pose * Vector3d(side * size_m[axis] * Vector3d::Unit(axis));
        if (outwards.dot(middle) >= 0.0) continue;
        for (int i = 0; i < 25; ++i) {
          Vector3d p = size_m.cwiseProduct(
              Vector3d((i % 5) * 0.2 - 0.4, (i / 5) * 0.2 - 0.4, ((i * 3) % 5) * 0.2 - 0.4));
          p[axis] = side * size_m[axis];
          Landmark landmark = test::MakeLandmark(static_cast<std::int64_t>(i), {f});
          landmark.p_in_object = object_from_car * p;
          cluster().landmarks.push_back(landmark);
        }
      }
    }
  }
};

Vector3d Forward(const ClusterReport& report) {
  return (report.world_from_object * report.box.object_from_box).rotation() * Vector3d::UnitX();
}

Vector3d Center(const ClusterReport& report) {
  return (report.world_from_object * report.box.object_from_box).translation();
}

// The pose of a car that drives ahead, along the optical axis.
RigidTransform Ahead(double x, double z) { return At(x, 1.0, z, -std::numbers::pi / 2.0); }

TEST(BodyBoxes, CarsHaveTheSizeOfTheirClassAndLieBehindTheirVisibleFaces) {
  for (const double x : {0.0, 3.0, -5.0}) {
    SeenCar car;
    const ClusterReport report = car.See(0, Ahead(x, 14.0));
    EXPECT_EQ(report.box.size_m, kCar_m);
    EXPECT_LT((Center(report) - Vector3d(x, 1.0, 14.0)).norm(), 0.25) << x;
    EXPECT_GT(Forward(report).z(), 0.999);  // initial heading of a body: away from the camera
  }
}

TEST(BodyBoxes, BodiesOfKittiClassesHaveTheSizeOfTheirClass) {
  for (const char* category : {"Van", "Cyclist"}) {
    SeenCar body(category);
    ASSERT_GT(body.size_m.minCoeff(), 0.0) << category;
    const ClusterReport report = body.See(0, Ahead(3.0, 16.0));
    EXPECT_EQ(report.box.size_m, body.size_m);
    EXPECT_LT((Center(report) - Vector3d(3.0, 1.0, 16.0)).norm(), 0.4) << category;
  }
  EXPECT_TRUE(SizeOfClass("Chair").isZero());
}

TEST(BodyBoxes, TruncatedBoxesArePlacedByTheirVisibleEdge) {
  SeenCar cut;
  const ClusterReport report = cut.See(0, Ahead(6.2, 9.0));  // its right side is outside the image
  EXPECT_GT(cut.frame.detections[0].box.left_px, 0.0);
  EXPECT_LT(cut.frame.detections[0].box.right_px, test::kCamera.width_px - 5);
  EXPECT_LT((Center(report) - Vector3d(6.2, 1.0, 9.0)).norm(), 0.3);
}

TEST(BodyBoxes, HeadAlongTheMotionOnceItExceedsItsUncertainty) {
  SeenCar car;
  const auto across = [](int f, double step_m) { return At(-2.0 + step_m * f, 1.0, 12.0); };
  EXPECT_GT(Forward(car.See(0, across(0, 0.5))).z(), 0.999);
  EXPECT_GT(Forward(car.See(1, across(1, 0.001))).z(), 0.99);
  for (int f = 2; f < 5; ++f) car.See(f, across(f, 0.5));
  EXPECT_GT(Forward(car.See(5, across(5, 0.5))).x(), 0.999);
  // A body that stands still keeps its heading, which rotates with its pose.
  for (int f = 6; f < 30; ++f) car.See(f, At(0.5, 1.0, 12.0));
  const ClusterReport turned = car.See(30, At(0.5, 1.0, 12.0, 0.5));
  EXPECT_LT((Forward(turned) - Vector3d(std::cos(0.5), 0.0, -std::sin(0.5))).norm(), 0.02);
}

TEST(BodyBoxes, RotateTheHeadingAcrossGapsLongerThanTheWindow) {
  SeenCar car;
  for (int f = 0; f < 6; ++f) car.See(f, At(-2.0 + 0.5 * f, 1.0, 12.0));
  car.cluster().states.clear();
  const ClusterReport found = car.See(40, At(2.0, 1.0, 12.0, 0.5));
  EXPECT_LT((Forward(found) - Vector3d(std::cos(0.5), 0.0, -std::sin(0.5))).norm(), 0.05);
}

TEST(BodyScore, RisesWithTheEvidence) {
  SeenCar car;
  car.See(0, Ahead(0.0, 14.0));
  const auto score = [&](std::int64_t newest) {
    return ScoreOf(car.options, nullptr, FrameId{newest}, car.cluster());
  };
  const double known = score(0);
  EXPECT_GT(known, 0.0);
  EXPECT_LT(known, 1.0);
  EXPECT_NEAR(score(2), 0.81 * known, 1e-12);
  car.cluster().score = -1.0;
  EXPECT_LT(score(0), known);
  EXPECT_LT(score(1), score(0));  // also if the detector's score is negative
  car.cluster().score = 2.0;
  ++car.cluster().detections;
  EXPECT_GT(score(0), known);
}

TEST(BodyScore, FallsWithResidualsAndFewLandmarks) {
  SeenCar car;
  car.See(0, Ahead(0.0, 14.0));
  const RigidTransform camera_from_object = car.cluster().Latest().world_from_object;
  const auto with_error = [&](double error_px) {
    for (Landmark& landmark : car.cluster().landmarks) {
      landmark.observations[0].z_px =
          test::kCamera.Project(camera_from_object * landmark.p_in_object).value();
      landmark.observations[0].z_px[0] += error_px;
    }
    const FrameView view{car.frame,  UseDetections::Show(car.frame), car.grid, test::kCamera, {},
                         car.options};
    return ScoreOf(car.options, &view, FrameId{0}, car.cluster());
  };
  const double exact = with_error(0.0);
  EXPECT_LT(with_error(1.0), exact);
  car.cluster().landmarks.resize(5);
  EXPECT_LT(with_error(0.0), exact);
}

// Returns points on the sides of a table of 1.2 x 0.7 x 0.5 m, rotated about the vertical.
Eigen::Matrix3Xd Table(double yaw_rad) {
  Rng rng(3, "table");
  const RigidTransform pose(ExpSo3({0.0, yaw_rad, 0.0}), Vector3d(0.5, 0.2, 4.0));
  Eigen::Matrix3Xd points(3, 600);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    Vector3d p(rng.Uniform(-0.6, 0.6), rng.Uniform(-0.35, 0.35), rng.Uniform(-0.25, 0.25));
    const int axis = i % 2 == 0 ? 0 : 2;
    p[axis] = std::copysign(axis == 0 ? 0.6 : 0.25, p[axis]);
    points.col(i) = pose * p;
  }
  return points;
}

TEST(BodyFootprint, AlignsWithTheSideNearestToTheHeading) {
  for (const double yaw_rad : {0.0, 0.3, -0.5}) {
    const Eigen::Matrix3d axes = FootprintAxes(Table(yaw_rad), Vector3d::UnitX(), kDown);
    const Vector3d side(std::cos(yaw_rad), 0.0, -std::sin(yaw_rad));
    EXPECT_GT(axes.col(0).dot(side), std::cos(0.06)) << yaw_rad;  // half a step
    EXPECT_EQ(Vector3d(axes.col(1)), kDown);
    const Eigen::Matrix3d turned = FootprintAxes(Table(yaw_rad), Vector3d::UnitZ(), kDown);
    EXPECT_LT(std::abs(turned.col(0).dot(side)), std::sin(0.06)) << yaw_rad;
  }
  const Eigen::Matrix3Xd few = Table(0.4).leftCols(10);
  EXPECT_EQ(FootprintAxes(few, Vector3d::UnitX(), kDown), BoxAxes(Vector3d::UnitX(), kDown));
}

TEST(BodyFootprint, SidesReachToTheOutermostInliers) {
  Eigen::Matrix3Xd points = Table(0.0);
  points.col(7).setConstant(30.0);
  const LandmarkSides sides = SidesAlong(BoxAxes(Vector3d::UnitX(), kDown), points);
  EXPECT_LT((sides.size_m - Vector3d(1.2, 0.7, 0.5)).cwiseAbs().maxCoeff(), 0.05);
}

TEST(BodyFootprint, ImagesCorrectTheSizeFromLandmarks) {
  const Vector3d told(2.0, 0.6, 0.4);
  EXPECT_EQ(WithPictures(told, {}), told);
  const Vector3d sides = WithPictures(told, {.height_m = 0.8, .square_m = 1.0});
  EXPECT_LT((sides - Vector3d(1.2, 0.8, 1.0 / 1.2)).norm(), 1e-12);
}

TEST(BodyFootprint, SidesOfABallAreItsDiameter) {
  // Landmarks are on the near side only, and a single image may show only part of the ball.
  const Vector3d told(0.5, 0.55, 0.3);
  EXPECT_EQ(SidesOfBall(told, {.height_m = 0.4, .square_m = 0.6}), Vector3d::Constant(0.6));
  EXPECT_EQ(SidesOfBall(told, {.height_m = 0.6, .square_m = 0.0}), Vector3d::Constant(0.6));
  EXPECT_EQ(SidesOfBall(told, {}), Vector3d::Constant(0.55));
}

TEST(BodyFootprint, MissingDepthIsAddedOnTheFarSide) {
  LandmarkSides sides{{-0.5, -0.3, 3.0}, {0.5, 0.3, 3.2}, {1.0, 0.6, 0.2}};
  const BoxShape shape{Eigen::Matrix3d::Identity(), {1.0, 0.6, 1.0}};
  for (const auto& [camera_z, center_z] : {std::pair(0.0, 3.5), {9.0, 2.7}}) {
    const Vector3d center = CenterBehindNearSides(sides, shape, {0.0, 0.0, camera_z});
    EXPECT_LT((center - Vector3d(0.0, 0.0, center_z)).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace cvo::body_boxes_test
