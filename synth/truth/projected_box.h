// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "synth/scene/world.h"
#include "synth/truth/truth.h"

namespace cvo::synth {

// The box around the left camera's projection of triangles, as far as they are in front of the near
// plane (StereoCamera::kMinDepth_m); not cut at the image's sides.
class ProjectedBox {
 public:
  explicit ProjectedBox(const StereoCamera& rig) : rig_(rig) {}

  void Add(const Mesh& mesh, const RigidTransform& camera_from_mesh);
  [[nodiscard]] const std::optional<PixelBox>& box() const { return box_; }

 private:
  void AddPoint(const Eigen::Vector3d& p_in_camera);

  StereoCamera rig_;
  std::optional<PixelBox> box_;
};

// The part of a box within the image; empty where nothing of it is inside.
[[nodiscard]] std::optional<PixelBox> ClipToImage(const PixelBox& box, int width_px, int height_px);

inline double Area_px2(const PixelBox& box) {
  return (box.right - box.left) * (box.bottom - box.top);
}

// Of two boxes as areas; 0 where they do not meet.
double IntersectionArea_px2(const PixelBox& a, const PixelBox& b);

}  // namespace cvo::synth
