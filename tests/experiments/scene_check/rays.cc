// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/experiments/scene_check/rays.h"

#include <cmath>
#include <optional>

#include "core/base/rng.h"

namespace cvo::test {
namespace {

constexpr double kWallDistance_m = 4.0;
constexpr double kFloor_m = 0.9;  // below the camera
constexpr double kSpeed_mps = 0.5;

// Distance to the nearest hit in front, as a multiple of `along`, whose depth is 1; none if the ray
// misses.
std::optional<double> HitBall(const Eigen::Vector3d& from, const Eigen::Vector3d& along,
                              double radius_m) {
  const double a = along.squaredNorm(), b = from.dot(along);
  const double c = from.squaredNorm() - radius_m * radius_m;
  const double root = b * b - a * c;
  if (root < 0.0 || -b - std::sqrt(root) <= 0.0) return std::nullopt;
  return (-b - std::sqrt(root)) / a;
}

std::optional<double> HitBox(const Eigen::Vector3d& from, const Eigen::Vector3d& along,
                             const Eigen::Vector3d& half_m) {
  double enter = 0.0, leave = 1e9;
  for (int i = 0; i < 3; ++i) {
    const double inverse = 1.0 / (std::abs(along[i]) < 1e-12 ? 1e-12 : along[i]);
    const double a = (-half_m[i] - from[i]) * inverse, b = (half_m[i] - from[i]) * inverse;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (enter > leave || enter <= 0.0) return std::nullopt;
  return enter;
}

}  // namespace

RayScene::RayScene()
    : camera_{.fx = 280.0,
              .fy = 280.0,
              .cx = 199.5,
              .cy = 149.5,
              .baseline_m = 0.12,
              .width_px = 400,
              .height_px = 300} {
  // Wavelengths of 9 to 20 cm, which is 8 to 20 px.
  Rng rng(7, "texture");
  for (int i = 0; i < waves_.cols(); ++i) {
    const Eigen::Vector3d direction(rng.Normal(), rng.Normal(), rng.Normal());
    waves_.col(i) = direction.normalized() * 2.0 * M_PI / rng.Uniform(0.09, 0.2);
    phases_[i] = rng.Uniform(0.0, 2.0 * M_PI);
  }
}

double RayScene::Texture(const Eigen::Vector3d& p, int body) const {
  const double scale = body == 0 ? 1.0 : 1.7;  // finer on bodies, for many corners
  double sum = 0.0;
  for (int i = 0; i < waves_.cols(); ++i) {
    sum += std::sin(scale * waves_.col(i).dot(p) + phases_[i] + 2.0 * body);
  }
  return std::clamp(128.0 + 18.0 * sum, 0.0, 255.0);
}

RayScene::Hit RayScene::Cast(const RigidTransform& world_from_camera, double u, double v,
                             int frame) const {
  const Eigen::Vector3d along((u - camera_.cx) / camera_.fx, (v - camera_.cy) / camera_.fy, 1.0);
  const Eigen::Vector3d from = world_from_camera.translation();
  const Eigen::Vector3d ray = world_from_camera.rotation() * along;
  Hit hit{(kWallDistance_m - from.z()) / ray.z(), 0, 0.0};
  if (ray.y() > 0.0) hit.depth_m = std::min(hit.depth_m, (kFloor_m - from.y()) / ray.y());
  Eigen::Vector3d p = from + hit.depth_m * ray;
  for (int body = 1; body <= kBodies; ++body) {
    const RigidTransform object_from_world = WorldFromObject(body, frame).Inverse();
    const Eigen::Vector3d o = object_from_world * from, d = object_from_world.rotation() * ray;
    const auto distance =
        body == 1 ? HitBall(o, d, kBallRadius_m) : HitBox(o, d, 0.5 * Size_m(body));
    if (!distance || *distance >= hit.depth_m) continue;
    hit = {*distance, body, 0.0};
    p = o + *distance * d;
  }
  hit.grey = Texture(p, hit.body);
  return hit;
}

RigidTransform RayScene::WorldFromLeft(int frame) const {
  return {ExpSo3({0.0, 0.01 * frame, 0.002 * frame}), Eigen::Vector3d(0.03, 0.004, 0.02) * frame};
}

RigidTransform RayScene::WorldFromRight(int frame) const {
  return WorldFromLeft(frame) *
         RigidTransform(Eigen::Quaterniond::Identity(), {camera_.baseline_m, 0.0, 0.0});
}

RigidTransform RayScene::WorldFromObject(int body, int frame) const {
  Eigen::Matrix3d R;  // forward is world z, left -x, up -y
  R << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  const Eigen::Quaterniond upright(R);
  if (body == 2) return {upright, Eigen::Vector3d(0.7, 0.45, 2.6)};
  const double time_s = frame / kRate_hz;
  return {ExpSo3(AngularVelocity(1) * time_s) * upright,
          Eigen::Vector3d(-0.6, 0.3, 2.2) + Velocity(1) * time_s};
}

Eigen::Vector3d RayScene::Velocity(int body) const {
  return body == 1 ? Eigen::Vector3d(kSpeed_mps, 0.0, 0.0) : Eigen::Vector3d::Zero();
}

Eigen::Vector3d RayScene::AngularVelocity(int body) const {
  return body == 1 ? Eigen::Vector3d(0.0, 0.0, kSpeed_mps / kBallRadius_m)
                   : Eigen::Vector3d::Zero();
}

Eigen::Vector3d RayScene::Size_m(int body) const {
  return Eigen::Vector3d::Constant(body == 1 ? 2.0 * kBallRadius_m : 0.5);
}

}  // namespace cvo::test
