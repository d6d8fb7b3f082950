// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/bodies/ground_direction.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <optional>
#include <vector>

namespace cvo {
namespace {

constexpr int kHypotheses = 100;
constexpr std::size_t kLeastPoints = 20;
constexpr double kMostTilt_cos = 0.766;  // 40 degrees from the camera's y axis
// As a fraction of a point's distance; allows for triangulation errors and uneven ground.
constexpr double kTolerance = 0.01;
constexpr double kBelow = 3.0;  // in tolerances
// Points below the ground are outliers unless they exceed this fraction of the points on it.
constexpr double kMostBelow = 0.1;
constexpr double kKept = 0.95;  // decay factor of the sum of normals, per frame

struct Plane {
  Eigen::Vector3d down;     // unit vector
  double distance_m = 0.0;  // down . p of its points
};

struct Support {
  std::vector<std::size_t> on;
  int below = 0;

  double Score() const { return static_cast<double>(on.size()) - below / kMostBelow; }
};

std::optional<Plane> PlaneThrough(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                  const Eigen::Vector3d& c) {
  Eigen::Vector3d normal = (b - a).cross(c - a);
  if (!(normal.norm() > 1e-9)) return std::nullopt;
  normal.normalize();
  if (normal.y() < 0.0) normal = -normal;
  if (normal.y() < kMostTilt_cos) return std::nullopt;
  return Plane{normal, normal.dot(a)};
}

Support SupportOf(const Plane& plane, const std::vector<Eigen::Vector3d>& points) {
  Support support;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double below = (plane.down.dot(points[i]) - plane.distance_m) / points[i].norm();
    if (std::abs(below) <= kTolerance) support.on.push_back(i);
    if (below > kBelow * kTolerance) ++support.below;
  }
  return support;
}

// Returns the least-squares normal of the plane through the chosen points.
Eigen::Vector3d NormalOf(const std::vector<Eigen::Vector3d>& points,
                         const std::vector<std::size_t>& chosen) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const std::size_t i : chosen) mean += points[i] / static_cast<double>(chosen.size());
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
  for (const std::size_t i : chosen) moment += (points[i] - mean) * (points[i] - mean).transpose();
  const Eigen::Vector3d normal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moment).eigenvectors().col(0);
  return normal.y() < 0.0 ? Eigen::Vector3d(-normal) : normal;
}

}  // namespace

void GroundDirection::Update(std::span<const Eigen::Vector3d> points_in_world,
                             const RigidTransform& world_from_camera) {
  sum_ *= kKept;
  if (points_in_world.size() < kLeastPoints) return;
  const RigidTransform camera_from_world = world_from_camera.Inverse();
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3d& p : points_in_world) points.push_back(camera_from_world * p);
  Support best;
  const auto any = [&] { return points[rng_.UniformInt(points.size())]; };
  for (int i = 0; i < kHypotheses; ++i) {
    const Eigen::Vector3d a = any();
    const Eigen::Vector3d b = any();
    const std::optional<Plane> plane = PlaneThrough(a, b, any());
    if (!plane) continue;
    Support support = SupportOf(*plane, points);
    if (best.on.empty() || support.Score() > best.Score()) best = std::move(support);
  }
  if (best.on.size() < kLeastPoints || best.Score() <= 0.0) return;
  sum_ += static_cast<double>(best.on.size()) *
          (world_from_camera.rotation() * NormalOf(points, best.on));
}

Eigen::Vector3d GroundDirection::Down(const RigidTransform& world_from_camera) const {
  constexpr double kForgotten = 1.0;  // in points
  if (sum_.norm() > kForgotten) return sum_.normalized();
  return world_from_camera.rotation() * Eigen::Vector3d::UnitY();
}

}  // namespace cvo
