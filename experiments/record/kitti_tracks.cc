// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "experiments/record/cluster_rows.h"
#include "experiments/record/cluster_tables.h"
#include "experiments/record/table_row.h"

namespace cvo {
namespace {

// About the camera's y axis, 0 along its x axis.
double Heading(const ClusterRow& cluster) {
  constexpr double kSlowest_m_s = 1.0;
  const Eigen::Vector3d& velocity = cluster.velocity_in_camera;
  if (velocity.norm() <= kSlowest_m_s) return -std::numbers::pi / 2.0;
  return std::atan2(-velocity.z(), velocity.x());
}

ObjectBox::Box3d UprightBox(const ClusterRow& cluster, double left_offset_m) {
  const double heading_rad = Heading(cluster);
  const Eigen::Vector3d forward(std::cos(heading_rad), 0.0, -std::sin(heading_rad));
  const Eigen::Vector3d across(std::sin(heading_rad), 0.0, std::cos(heading_rad));
  const Eigen::Matrix3d sides =
      cluster.camera_from_object.RotationMatrix() * (2.0 * cluster.report.half_size_m).asDiagonal();
  const auto extent_m = [&](const Eigen::Vector3d& axis) {
    return (axis.transpose() * sides).cwiseAbs().sum();
  };
  ObjectBox::Box3d box;
  box.height_m = extent_m(Eigen::Vector3d::UnitY());
  box.width_m = extent_m(across);
  box.length_m = extent_m(forward);
  box.bottom_in_camera = cluster.camera_from_object * cluster.report.center_in_object +
                         Eigen::Vector3d(-left_offset_m, 0.5 * box.height_m, 0.0);
  box.heading_rad = heading_rad;
  return box;
}

// Of the associated detection, else of the 3D box; empty out of view.
std::optional<ImageBox> Box2d(const ClusterRow& cluster, const StereoCamera& camera) {
  const int detection = cluster.report.detection;
  if (detection < 0) return ProjectedBox(cluster, camera);
  return cluster.frame.detections.at(static_cast<std::size_t>(detection)).box;
}

}  // namespace

std::string KittiTracks(const Sequence& sequence, const RunResult& run) {
  std::string rows;
  for (const ClusterRow& cluster : ClusterRows(run)) {
    const std::optional<ImageBox> box2d = Box2d(cluster, sequence.camera);
    if (!box2d) continue;
    const ObjectBox::Box3d box3d = UprightBox(cluster, sequence.left_offset_m);
    const Eigen::Vector3d& bottom = box3d.bottom_in_camera;
    TableRow row(' ');
    row.Integer(cluster.frame.frame);
    row.Integer(cluster.report.id.value);
    row.Text(cluster.report.category.empty() ? "Misc" : cluster.report.category);
    row.Integer(-1);  // truncation and occlusion are not estimated
    row.Integer(-1);
    row.Number(std::remainder(box3d.heading_rad - std::atan2(bottom.x(), bottom.z()),
                              2.0 * std::numbers::pi));
    row.Box(box2d);
    row.Vector({box3d.height_m, box3d.width_m, box3d.length_m});
    row.Vector(bottom);
    row.Number(box3d.heading_rad);
    row.Number(cluster.report.score);
    rows += row.Line();
  }
  return rows;
}

}  // namespace cvo
