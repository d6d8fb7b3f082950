// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>
#include <optional>

#include "experiments/record/cluster_tables.h"
#include "experiments/record/table_row.h"

namespace cvo {
namespace {

// The cluster's 3D box, upright in the camera frame: its tilt is ignored, because KITTI takes the
// camera's y axis as the vertical.
ObjectBox::Box3d UprightBox(const ClusterRow& cluster, double left_offset_m) {
  const RigidTransform camera_from_box = cluster.CameraFromBox();
  const Eigen::Vector3d forward = camera_from_box.rotation() * Eigen::Vector3d::UnitX();
  const Eigen::Vector3d& size_m = cluster.Last().box.size_m;
  ObjectBox::Box3d box;
  box.length_m = size_m.x();
  box.height_m = size_m.y();
  box.width_m = size_m.z();
  box.bottom_in_camera =
      camera_from_box.translation() + Eigen::Vector3d(-left_offset_m, 0.5 * box.height_m, 0.0);
  box.heading_rad = std::atan2(-forward.z(), forward.x());
  return box;
}

// The box of the associated detection, otherwise the projected 3D box; empty if out of view.
std::optional<ImageBox> Box2d(const ClusterRow& cluster, const StereoCamera& camera) {
  const int detection = cluster.Last().detection;
  if (detection < 0) return ProjectedBox(cluster, camera);
  return cluster.frame.detections.at(static_cast<std::size_t>(detection)).box;
}

}  // namespace

void ForEachTrackBox(const Sequence& sequence, const RunResult& run,
                     const std::function<void(const ObjectBox&)>& take) {
  ForEachClusterRow(run, [&](const ClusterRow& cluster) {
    const std::optional<ImageBox> box2d = Box2d(cluster, sequence.camera);
    if (!box2d) return;
    ObjectBox box;
    box.frame = cluster.frame.frame;
    box.track = static_cast<int>(cluster.id.value);
    box.type = cluster.Last().category.empty() ? "Misc" : cluster.Last().category;
    box.left_px = box2d->left_px;
    box.top_px = box2d->top_px;
    box.right_px = box2d->right_px;
    box.bottom_px = box2d->bottom_px;
    box.box3d = UprightBox(cluster, sequence.left_offset_m);
    box.score = cluster.Last().score;
    take(box);
  });
}

void WriteKittiTracks(const Sequence& sequence, const RunResult& run, const TextSink& sink) {
  ForEachTrackBox(sequence, run, [&sink](const ObjectBox& box) {
    const ObjectBox::Box3d& box3d = *box.box3d;
    const Eigen::Vector3d& bottom = box3d.bottom_in_camera;
    TableRow row(' ');
    row.Integer(box.frame);
    row.Integer(box.track);
    row.Text(box.type);
    row.Integer(-1);  // truncation and occlusion are not estimated
    row.Integer(-1);
    row.Number(std::remainder(box3d.heading_rad - std::atan2(bottom.x(), bottom.z()),
                              2.0 * std::numbers::pi));
    row.Box(ImageBox{box.left_px, box.top_px, box.right_px, box.bottom_px});
    row.Vector({box3d.height_m, box3d.width_m, box3d.length_m});
    row.Vector(bottom);
    row.Number(box3d.heading_rad);
    row.Number(*box.score);
    sink(row.Line());
  });
}

}  // namespace cvo
