// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/scene/separation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace cvo::synth {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Box {
  Vector3d centre;
  Matrix3d axes;  // columns
  Vector3d half_m;
};

double BallToBall(const Vector3d& a, double radius_a, const Vector3d& b, double radius_b) {
  return (b - a).norm() - radius_a - radius_b;
}

double BallToBox(const Vector3d& ball, double radius, const Box& box) {
  const Vector3d local = box.axes.transpose() * (ball - box.centre);
  const Vector3d outside = local.cwiseAbs() - box.half_m;
  if (outside.maxCoeff() <= 0.0) return outside.maxCoeff() - radius;
  return outside.cwiseMax(0.0).norm() - radius;
}

// Separating axis test: returns the greatest gap along the 15 axes that can separate two boxes.
double BoxToBox(const Box& a, const Box& b) {
  const Vector3d apart = b.centre - a.centre;
  double widest = -1e300;
  const auto try_axis = [&](const Vector3d& axis) {
    const double gap = std::abs(axis.dot(apart)) -
                       (a.axes.transpose() * axis).cwiseAbs().dot(a.half_m) -
                       (b.axes.transpose() * axis).cwiseAbs().dot(b.half_m);
    widest = std::max(widest, gap);
  };
  for (int i = 0; i < 3; ++i) {
    try_axis(a.axes.col(i));
    try_axis(b.axes.col(i));
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vector3d edge = a.axes.col(i).cross(b.axes.col(j));
      const double length = edge.norm();
      if (length > 1e-6) try_axis(edge / length);  // parallel edges add no direction
    }
  }
  return widest;
}

Box MakeBox(const CollisionShape& shape, const RigidTransform& world_from_shape) {
  return {world_from_shape.translation(), world_from_shape.RotationMatrix(), shape.half_size_m};
}

double Radius_m(const CollisionShape& shape) {
  return shape.radius_m > 0.0 ? shape.radius_m : shape.half_size_m.norm();
}

}  // namespace

double Separation(const CollisionShape& a, const RigidTransform& world_from_a,
                  const CollisionShape& b, const RigidTransform& world_from_b) {
  const RigidTransform at_a = world_from_a * a.model_from_shape;
  const RigidTransform at_b = world_from_b * b.model_from_shape;
  const double around =
      BallToBall(at_a.translation(), Radius_m(a), at_b.translation(), Radius_m(b));
  const bool a_is_ball = a.radius_m > 0.0;
  const bool b_is_ball = b.radius_m > 0.0;
  if (around > 0.5 || (a_is_ball && b_is_ball)) return around;
  if (a_is_ball) return BallToBox(at_a.translation(), a.radius_m, MakeBox(b, at_b));
  if (b_is_ball) return BallToBox(at_b.translation(), b.radius_m, MakeBox(a, at_a));
  return BoxToBox(MakeBox(a, at_a), MakeBox(b, at_b));
}

double PlaneSeparation(const CollisionShape& shape, const RigidTransform& world_from_model,
                       const Eigen::Vector4d& plane) {
  const RigidTransform at = world_from_model * shape.model_from_shape;
  const Vector3d normal = plane.head<3>();
  const double centre = normal.dot(at.translation()) + plane[3];
  if (shape.radius_m > 0.0) return centre - shape.radius_m;
  return centre - (at.RotationMatrix().transpose() * normal).cwiseAbs().dot(shape.half_size_m);
}

double BoundingRadius_m(const std::vector<CollisionShape>& shapes) {
  double radius = 0.0;
  for (const CollisionShape& shape : shapes) {
    radius = std::max(radius, shape.model_from_shape.translation().norm() + Radius_m(shape));
  }
  return radius;
}

}  // namespace cvo::synth
