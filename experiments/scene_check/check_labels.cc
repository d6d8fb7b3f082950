// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "experiments/scene_check/checks.h"
#include "experiments/scene_check/limits.h"

namespace cvo {
namespace {

// Returns KITTI's class of occlusion for the visible fraction of a body.
int OcclusionOf(const SceneBody& body) {
  if (body.visible_px == 0) return 3;
  if (body.visible_fraction >= 0.8) return 0;
  return body.visible_fraction >= 0.3 ? 1 : 2;
}

double Wrapped(double angle_rad) { return std::remainder(angle_rad, 2.0 * std::numbers::pi); }

struct LabelWorst {
  Worst box, size, position, heading, truncation, occlusion;

  void Add(const ObjectBox& label, const SceneBody& body, const RigidTransform& left_from_world,
           const std::string& place) {
    const TruthBox& amodal = *body.amodal_box;
    box.Add(
        std::max({std::abs(label.left_px - amodal.left_px), std::abs(label.top_px - amodal.top_px),
                  std::abs(label.right_px - amodal.right_px),
                  std::abs(label.bottom_px - amodal.bottom_px)}),
        place);
    truncation.Add(std::abs(label.truncation - body.truncation), place);
    occlusion.Add(std::abs(label.occlusion - OcclusionOf(body)), place);
    if (!label.box3d) return size.Add(1e9, place + ": no 3D box");
    const ObjectBox::Box3d& box3d = *label.box3d;
    size.Add((Eigen::Vector3d(box3d.length_m, box3d.width_m, box3d.height_m) - body.size_m)
                 .cwiseAbs()
                 .maxCoeff(),
             place);
    const RigidTransform left_from_object = left_from_world * body.world_from_object;
    const Eigen::Vector3d bottom =
        left_from_object * Eigen::Vector3d(0.0, 0.0, -0.5 * body.size_m.z());
    position.Add((box3d.bottom_in_camera - bottom).norm(), place);
    const Eigen::Matrix3d R = left_from_object.RotationMatrix();
    if (std::acos(std::clamp(-R(1, 2), -1.0, 1.0)) > limits::kMaxTilt_rad) return;
    heading.Add(std::abs(Wrapped(box3d.heading_rad - std::atan2(-R(2, 0), R(0, 0)))), place);
  }
};

// Counts rows that belong to no body in view, and bodies in view without exactly one row.
struct Unmatched {
  int count = 0;
  std::string first;

  void Add(const std::string& what) {
    if (count++ == 0) first = what;
  }
  SceneCheck None(const std::string& name) const {
    return {name, static_cast<double>(count), "rows", Bound::kAtMost, 0.0, first};
  }
};

}  // namespace

std::vector<SceneCheck> CheckLabels(const SceneFolder& scene, TaskPool&) {
  std::vector<RigidTransform> left_from_world;
  std::vector<std::vector<int>> rows;  // [frame][id - 1]
  for (const RigidTransform& pose : scene.world_from_left)
    left_from_world.push_back(pose.Inverse());
  for (const auto& bodies : scene.bodies) rows.emplace_back(bodies.size(), 0);
  LabelWorst worst;
  Unmatched unmatched;
  for (const ObjectBox& label : scene.sequence.labels) {
    const auto frame = static_cast<std::size_t>(label.frame);
    const std::string place = StrCat("frame ", label.frame, ", track ", label.track);
    const bool known =
        label.track >= 1 && label.track <= static_cast<int>(scene.bodies[frame].size());
    const SceneBody* body =
        known ? &scene.bodies[frame][static_cast<std::size_t>(label.track) - 1] : nullptr;
    if (body == nullptr || !body->amodal_box || body->category != label.type) {
      unmatched.Add(place + ", " + label.type);
      continue;
    }
    ++rows[frame][static_cast<std::size_t>(label.track) - 1];
    worst.Add(label, *body, left_from_world[frame], place);
  }
  for (std::size_t frame = 0; frame < rows.size(); ++frame) {
    for (std::size_t i = 0; i < rows[frame].size(); ++i) {
      const int expected = scene.bodies[frame][i].amodal_box ? 1 : 0;
      if (rows[frame][i] != expected) {
        unmatched.Add(StrCat("frame ", frame, ", ", scene.bodies[frame][i].name, ": ",
                             rows[frame][i], " rows"));
      }
    }
  }
  return {unmatched.None("labels_unmatched"),
          worst.box.AtMost("label_box", "px", limits::kBoxText_px),
          worst.size.AtMost("label_size", "m", limits::kLabelText_m),
          worst.position.AtMost("label_position", "m", limits::kLabelText_m),
          worst.heading.AtMost("label_heading", "rad", limits::kLabelText_rad),
          worst.truncation.AtMost("label_truncation", "1", limits::kLabelText_fraction),
          worst.occlusion.AtMost("label_occlusion", "classes", 0.0)};
}

}  // namespace cvo
