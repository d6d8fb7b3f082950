// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "core/record/csv_record.h"

namespace cvo {

// One body in one frame of a synthetic scene: a row of the scene's objects.csv. The world is the
// first left camera. The object's frame is x forward, y left, z up, with its origin at the centre
// of its box.
struct SceneBody {
  int frame = 0;
  int id = 0;  // 1, 2, ...: the value in instance masks
  std::string name;
  std::string category;
  RigidTransform world_from_object;
  Eigen::Vector3d velocity_in_world = Eigen::Vector3d::Zero();          // of its origin, m/s
  Eigen::Vector3d angular_velocity_in_world = Eigen::Vector3d::Zero();  // rad/s
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();                     // along x, y, z
  int visible_px = 0;             // in the mask of the left image
  int alone_px = 0;               // if nothing occluded it
  double visible_fraction = 0.0;  // visible_px / alone_px; 0 if out of view
  double truncation = 0.0;        // fraction of its projected box outside the image
  // A box around the single pixel (u, v) has all four sides on it.
  std::optional<ImageBox> visible_box;  // around the mask; empty if the mask is
  std::optional<ImageBox> amodal_box;   // around the whole body, clipped to the image

  template <typename Self, typename Archive>
  static void VisitColumns(Self& self, Archive& archive) {
    archive.Cells("frame", self.frame);
    archive.Cells("id", self.id);
    archive.Cells("name", self.name);
    archive.Cells("category", self.category);
    archive.Cells("x,y,z,qx,qy,qz,qw", self.world_from_object);
    archive.Cells("vx,vy,vz", self.velocity_in_world);
    archive.Cells("wx,wy,wz", self.angular_velocity_in_world);
    archive.Cells("length_m,width_m,height_m", self.size_m);
    archive.Cells("visible_px", self.visible_px);
    archive.Cells("alone_px", self.alone_px);
    archive.Cells("visible_fraction", self.visible_fraction);
    archive.Cells("truncation", self.truncation);
    archive.Cells("visible_left,visible_top,visible_right,visible_bottom", self.visible_box);
    archive.Cells("amodal_left,amodal_top,amodal_right,amodal_bottom", self.amodal_box);
  }
};

}  // namespace cvo
