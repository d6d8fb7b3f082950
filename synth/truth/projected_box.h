// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "synth/scene/world.h"
#include "synth/truth/truth.h"

namespace cvo::synth {

// Bounding box of triangles projected into the left image, as far as they are in front of the near
// plane (StereoCamera::kMinDepth_m). It is not clipped to the image.
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

// Returns the part of a box within the image; empty if there is none.
[[nodiscard]] std::optional<PixelBox> ClipToImage(const PixelBox& box, int width_px, int height_px);

inline double Area_px2(const PixelBox& box) {
  return (box.right - box.left) * (box.bottom - box.top);
}

// Area of the intersection of two boxes; 0 if they are disjoint.
double IntersectionArea_px2(const PixelBox& a, const PixelBox& b);

}  // namespace cvo::synth
