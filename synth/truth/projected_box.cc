// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/truth/projected_box.h"

#include <algorithm>

namespace cvo::synth {
namespace {

constexpr double kNear_m = StereoCamera::kMinDepth_m;

// Intersection of the line from a to b with the near plane.
Eigen::Vector3d AtNearPlane(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const double s = (kNear_m - a.z()) / (b.z() - a.z());
  Eigen::Vector3d p = a + s * (b - a);
  p.z() = kNear_m;
  return p;
}

}  // namespace

void ProjectedBox::AddPoint(const Eigen::Vector3d& p) {
  const double u = rig_.fx * p.x() / p.z() + rig_.cx;
  const double v = rig_.fy * p.y() / p.z() + rig_.cy;
  if (!box_) box_ = PixelBox{u, v, u, v};
  box_->left = std::min(box_->left, u);
  box_->right = std::max(box_->right, u);
  box_->top = std::min(box_->top, v);
  box_->bottom = std::max(box_->bottom, v);
}

void ProjectedBox::Add(const Mesh& mesh, const RigidTransform& camera_from_mesh) {
  const Eigen::Matrix3d R = camera_from_mesh.RotationMatrix();
  const Eigen::Vector3d t = camera_from_mesh.translation();
  std::vector<Eigen::Vector3d> points;
  points.reserve(mesh.vertices.size());
  bool all_in_front = true;
  for (const Vertex& vertex : mesh.vertices) {
    points.emplace_back(R * vertex.position.cast<double>() + t);
    if (points.back().z() >= kNear_m) {
      AddPoint(points.back());
    } else {
      all_in_front = false;
    }
  }
  if (all_in_front) return;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3d& a = points[mesh.indices[i + k]];
      const Eigen::Vector3d& b = points[mesh.indices[i + (k + 1) % 3]];
      if ((a.z() >= kNear_m) != (b.z() >= kNear_m)) AddPoint(AtNearPlane(a, b));
    }
  }
}

std::optional<PixelBox> ClipToImage(const PixelBox& box, int width_px, int height_px) {
  const PixelBox clipped = {std::max(box.left, 0.0), std::max(box.top, 0.0),
                            std::min(box.right, width_px - 1.0),
                            std::min(box.bottom, height_px - 1.0)};
  if (clipped.left > clipped.right || clipped.top > clipped.bottom) return std::nullopt;
  return clipped;
}

double IntersectionArea_px2(const PixelBox& a, const PixelBox& b) {
  const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  return width > 0.0 && height > 0.0 ? width * height : 0.0;
}

}  // namespace cvo::synth
