// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/render/view_geometry.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace cvo::synth {
namespace {

// How far beyond the shadow range, along the light, an object still casts its shadow.
constexpr double kShadowDepth_m = 60.0;

Eigen::Matrix4d ClipFromCamera(const StereoCamera& rig, double cx) {
  const double width = rig.width_px;
  const double height = rig.height_px;
  Eigen::Matrix4d clip_from_camera;
  clip_from_camera << 2.0 * rig.fx / width, 0.0, (2.0 * cx + 1.0) / width - 1.0, 0.0,  //
      0.0, 2.0 * rig.fy / height, (2.0 * rig.cy + 1.0) / height - 1.0, 0.0,            //
      0.0, 0.0, 0.0, kNear_m,                                                          //
      0.0, 0.0, 1.0, 0.0;
  return clip_from_camera;
}

}  // namespace

Eigen::Matrix4d ClipFromLeft(const StereoCamera& rig) { return ClipFromCamera(rig, rig.cx); }

Eigen::Matrix4d ClipFromRight(const StereoCamera& rig, const RigError& error) {
  StereoCamera right = rig;
  right.fx *= 1.0 + error.focal;
  right.fy *= 1.0 + error.focal;
  const RigidTransform left_from_right(ExpSo3(error.rotation_deg * std::numbers::pi / 180.0),
                                       Eigen::Vector3d(rig.baseline_m, 0.0, 0.0));
  return ClipFromCamera(right, rig.cx + rig.right_shift_px + error.shift_px) *
         left_from_right.Inverse().Matrix();
}

Eigen::Matrix4d ShadowClipFromWorld(const Light& light, const Eigen::Vector3d& camera_in_world,
                                    int side_px) {
  const Eigen::Vector3d to_light = -light.direction.normalized();
  const Eigen::Vector3d x_axis = to_light.unitOrthogonal();
  const Eigen::Vector3d y_axis = to_light.cross(x_axis);
  const double range = light.shadow_range_m;
  const double texel = 2.0 * range / side_px;
  const auto snapped = [&](const Eigen::Vector3d& axis) {
    return std::round(axis.dot(camera_in_world) / texel) * texel;
  };
  const double depth_range = range + kShadowDepth_m;
  Eigen::Matrix4d clip = Eigen::Matrix4d::Zero();
  clip.row(0) << x_axis.transpose() / range, -snapped(x_axis) / range;
  clip.row(1) << y_axis.transpose() / range, -snapped(y_axis) / range;
  clip.row(2) << to_light.transpose() / (2.0 * depth_range),
      0.5 - to_light.dot(camera_in_world) / (2.0 * depth_range);
  clip(3, 3) = 1.0;
  return clip;
}

Sphere BoundingSphere(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vertex& vertex : mesh.vertices) box.extend(vertex.position.cast<double>());
  if (box.isEmpty()) return {};
  Sphere sphere;
  sphere.centre = box.center();
  for (const Vertex& vertex : mesh.vertices) {
    const double distance = (vertex.position.cast<double>() - sphere.centre).norm();
    sphere.radius = std::max(sphere.radius, distance);
  }
  return sphere;
}

bool MayBeVisible(const Eigen::Matrix4d& clip_from_body, const Sphere& sphere) {
  const auto is_outside = [&](const Eigen::RowVector4d& plane) {
    const double distance = plane.head<3>().dot(sphere.centre) + plane[3];
    return distance < -sphere.radius * plane.head<3>().norm();
  };
  const Eigen::RowVector4d w = clip_from_body.row(3);
  const auto row = [&](int i) -> Eigen::RowVector4d { return clip_from_body.row(i); };
  return !is_outside(w + row(0)) && !is_outside(w - row(0)) && !is_outside(w + row(1)) &&
         !is_outside(w - row(1)) && !is_outside(w - row(2));
}

}  // namespace cvo::synth
