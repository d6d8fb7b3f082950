// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "experiments/metrics/trajectory.h"
#include "experiments/scene_check/checks.h"
#include "experiments/scene_check/limits.h"

namespace cvo {
namespace {

double Time_s(const SceneFolder& scene, std::size_t frame) {
  return 1e-9 * static_cast<double>(scene.sequence.timestamps_ns[frame]);
}

// Returns the difference as a fraction of what is allowed at this speed.
double ShareOfLimit(double difference, double speed, double limit) {
  return difference / (limit + limits::kVelocityShare * speed);
}

void CompareVelocity(const SceneFolder& scene, std::size_t frame, std::size_t body, Worst& linear,
                     Worst& angular) {
  const SceneBody& before = scene.bodies[frame - 1][body];
  const SceneBody& now = scene.bodies[frame][body];
  const SceneBody& after = scene.bodies[frame + 1][body];
  const double dt_s = Time_s(scene, frame + 1) - Time_s(scene, frame - 1);
  const Eigen::Vector3d velocity =
      (after.world_from_object.translation() - before.world_from_object.translation()) / dt_s;
  const Eigen::Vector3d rotation =
      LogSo3(after.world_from_object.rotation() * before.world_from_object.rotation().inverse()) /
      dt_s;
  const std::string place = StrCat(now.name, ", frame ", frame);
  linear.Add(ShareOfLimit((velocity - now.velocity_in_world).norm(), velocity.norm(),
                          limits::kVelocity_mps),
             place);
  angular.Add(ShareOfLimit((rotation - now.angular_velocity_in_world).norm(), rotation.norm(),
                           limits::kAngularVelocity_radps),
              place);
}

}  // namespace

std::vector<SceneCheck> CheckPoses(const SceneFolder& scene, TaskPool&) {
  const std::vector<RigidTransform> right = ReadKittiPoses(scene.path / "poses_right.txt");
  if (right.size() != scene.world_from_left.size()) {
    ThrowError((scene.path / "poses_right.txt").string(), StrCat(right.size(), " poses"),
               StrCat(scene.world_from_left.size(), ", as many as in poses.txt"));
  }
  const Eigen::Vector3d baseline(scene.sequence.camera.baseline_m, 0.0, 0.0);
  Worst position, rotation, linear, angular;
  for (std::size_t i = 0; i < right.size(); ++i) {
    const RigidTransform left_from_right = scene.world_from_left[i].Inverse() * right[i];
    const std::string place = StrCat("frame ", i);
    position.Add((left_from_right.translation() - baseline).norm(), place);
    rotation.Add(RotationAngle(left_from_right.rotation()), place);
  }
  for (std::size_t i = 1; i + 1 < scene.bodies.size(); ++i) {
    for (std::size_t body = 0; body < scene.bodies[i].size(); ++body) {
      CompareVelocity(scene, i, body, linear, angular);
    }
  }
  const RigidTransform& first = scene.world_from_left.front();
  return {{"first_pose", first.Minus(RigidTransform()).norm(), "m and rad", Bound::kAtMost,
           limits::kBaseline_m, "frame 0: not the origin"},
          position.AtMost("baseline_error", "m", limits::kBaseline_m),
          rotation.AtMost("baseline_rotation", "rad", limits::kBaselineRotation_rad),
          linear.AtMost("velocity_error", "of allowed", 1.0),
          angular.AtMost("angular_velocity_error", "of allowed", 1.0)};
}

}  // namespace cvo
