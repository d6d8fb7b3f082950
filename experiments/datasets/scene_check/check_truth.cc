// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Poses, velocities, boxes and masks against each other, without images.

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "experiments/datasets/scene_check/checks.h"
#include "experiments/metrics/trajectory.h"

namespace cvo {

namespace {

constexpr double kBaseline_m = 1e-6;
constexpr double kBaselineRotation_rad = 1e-6;
// Velocities against central differences of poses, whose own error is jerk dt^2 / 6: 2 mm/s for a
// block that swings once in 2 s at 30 Hz.
constexpr double kVelocity_mps = 0.05;
constexpr double kAngularVelocity_radps = 0.1;
constexpr double kVelocityShare = 0.02;

// Points of a mask against the body's box: tessellated surfaces stay inside it, but depth buffers
// are quantised.
constexpr double kBoxTolerance_m = 0.02;
constexpr double kBoxTolerancePerDepth = 5e-4;
// Boxes of whole pixels, as text.
constexpr double kBoxText_px = 1e-6;

double Time_s(const SceneFolder& scene, std::size_t frame) {
  return 1e-9 * static_cast<double>(scene.sequence.timestamps_ns[frame]);
}

// Returns the difference as a fraction of what is allowed at this speed.
double ShareOfLimit(double difference, double speed, double limit) {
  return difference / (limit + kVelocityShare * speed);
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
  linear.Add(
      ShareOfLimit((velocity - now.velocity_in_world).norm(), velocity.norm(), kVelocity_mps),
      place);
  angular.Add(ShareOfLimit((rotation - now.angular_velocity_in_world).norm(), rotation.norm(),
                           kAngularVelocity_radps),
              place);
}

// The pixels of a body in one frame.
struct Mask {
  int pixels = 0;
  ImageBox box = {1e9, 1e9, -1e9, -1e9};
  double outside_box_m = 0.0;  // largest distance outside the 3D box, less that allowed by depth
};

// What the pixels of a body are checked against.
struct Shape {
  RigidTransform object_from_camera;
  Eigen::Vector3d half_size_m;
};

struct FrameMasks {
  std::vector<Mask> masks;  // [id - 1]
  int strangers = 0;        // pixels whose id is that of no body
};

void AddPixel(const StereoCamera& camera, const cv::Mat& depth, int u, int v, const Shape& shape,
              Mask& mask) {
  ++mask.pixels;
  mask.box.left_px = std::min<double>(mask.box.left_px, u);
  mask.box.right_px = std::max<double>(mask.box.right_px, u);
  mask.box.top_px = std::min<double>(mask.box.top_px, v);
  mask.box.bottom_px = std::max<double>(mask.box.bottom_px, v);
  const double z_m = depth.at<float>(v, u);
  if (!(z_m > 0.0)) {
    mask.outside_box_m = std::numeric_limits<double>::infinity();
    return;
  }
  const Eigen::Vector3d p_in_object = shape.object_from_camera * PointAt(camera, depth, u, v);
  const double outside_m = (p_in_object.cwiseAbs() - shape.half_size_m).maxCoeff();
  mask.outside_box_m = std::max(mask.outside_box_m, outside_m - kBoxTolerancePerDepth * z_m);
}

FrameMasks MeasureMasks(const SceneFolder& scene, int frame) {
  const auto index = static_cast<std::size_t>(frame);
  const StereoCamera& camera = scene.sequence.camera;
  const cv::Mat depth = scene.Depth(frame);
  const cv::Mat instances = scene.Instances(frame);
  const RigidTransform camera_from_world = scene.world_from_left[index].Inverse();
  std::vector<Shape> shapes;
  for (const SceneBody& body : scene.bodies[index]) {
    shapes.push_back({(camera_from_world * body.world_from_object).Inverse(), 0.5 * body.size_m});
  }
  FrameMasks result;
  result.masks.resize(shapes.size());
  for (int v = 0; v < instances.rows; ++v) {
    const auto* row = instances.ptr<std::uint16_t>(v);
    for (int u = 0; u < instances.cols; ++u) {
      if (row[u] == 0) continue;
      const std::size_t body = row[u] - 1U;
      if (body >= shapes.size()) {
        ++result.strangers;
      } else {
        AddPixel(camera, depth, u, v, shapes[body], result.masks[body]);
      }
    }
  }
  return result;
}

double BoxDifference_px(const ImageBox& a, const ImageBox& b) {
  return std::max({std::abs(a.left_px - b.left_px), std::abs(a.top_px - b.top_px),
                   std::abs(a.right_px - b.right_px), std::abs(a.bottom_px - b.bottom_px)});
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
           kBaseline_m, "frame 0: not the origin"},
          position.AtMost("baseline_error", "m", kBaseline_m),
          rotation.AtMost("baseline_rotation", "rad", kBaselineRotation_rad),
          linear.AtMost("velocity_error", "of allowed", 1.0),
          angular.AtMost("angular_velocity_error", "of allowed", 1.0)};
}

std::vector<SceneCheck> CheckMasks(const SceneFolder& scene, TaskPool& pool) {
  const std::vector<FrameMasks> results = ForAll<FrameMasks>(
      scene.frame_count(), pool, [&](int frame) { return MeasureMasks(scene, frame); });
  Worst strangers, pixels, boxes, outside;
  for (std::size_t i = 0; i < results.size(); ++i) {
    strangers.Add(results[i].strangers, StrCat("frame ", i));
    for (std::size_t k = 0; k < results[i].masks.size(); ++k) {
      const SceneBody& body = scene.bodies[i][k];
      const Mask& mask = results[i].masks[k];
      const std::string place = StrCat(body.name, ", frame ", i);
      pixels.Add(std::abs(body.visible_px - mask.pixels), place);
      outside.Add(mask.outside_box_m, place);
      if (mask.pixels == 0 || !body.visible_box) continue;
      boxes.Add(BoxDifference_px(mask.box, *body.visible_box), place);
    }
  }
  return {strangers.AtMost("mask_unknown_ids", "px", 0.0),
          pixels.AtMost("mask_visible_px", "px", 0.0),
          boxes.AtMost("mask_visible_box", "px", kBoxText_px),
          outside.AtMost("mask_point_out_of_box", "m", kBoxTolerance_m)};
}

}  // namespace cvo
