// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/record/csv_record.h"

// The rows of CSV files. Poses, points and velocities are in the world of the first left camera.
namespace cvo {

// One body in one frame of a synthetic scene: a row of the scene's objects.csv. The object's frame
// is x forward, y left, z up, with its origin at the centre of its box.
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

namespace cvo::reports {

// A live cluster in a frame: a row of a run's objects.csv.
struct ObjectRow {
  int frame = 0;  // number in the folder of the sequence
  std::int64_t timestamp_ns = 0;
  std::int64_t id = 0;
  std::string category;
  // As estimated when the frame was processed, and as last estimated; empty if the run has no such
  // estimate. A status is "tracked", or "predicted" by the motion model alone: hidden or lost.
  std::string causal_status;
  std::optional<RigidTransform> causal_world_from_object;
  std::optional<Eigen::Vector3d> causal_velocity_m_s;
  std::string refined_status;
  std::optional<RigidTransform> refined_world_from_object;
  std::optional<Eigen::Vector3d> refined_velocity_m_s;
  // The inner extent, which the estimator uses.
  Eigen::Vector3d center_in_object = Eigen::Vector3d::Zero();
  Eigen::Vector3d half_size_m = Eigen::Vector3d::Zero();
  // Its box, upright in the frame of the object, x forward, y down (METHOD.md 10.4).
  RigidTransform object_from_box;
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();  // length, height, width
  // The projection of the last estimated box into the left image read; empty out of view.
  std::optional<ImageBox> projected_box;
  int observed_landmarks = 0;
  std::optional<int> detection;  // index among the frame's detections
  double score = 0.0;

  // As last estimated.
  bool predicted() const {
    return (refined_world_from_object ? refined_status : causal_status) == "predicted";
  }
  RigidTransform WorldFromObject() const {
    return refined_world_from_object ? *refined_world_from_object
                                     : causal_world_from_object.value_or(RigidTransform());
  }

  template <typename Self, typename Archive>
  static void VisitColumns(Self& self, Archive& archive) {
    archive.Cells("frame", self.frame);
    archive.Cells("timestamp_ns", self.timestamp_ns);
    archive.Cells("id", self.id);
    archive.Cells("category", self.category);
    archive.Cells("status", self.causal_status);
    archive.Cells("x,y,z,qx,qy,qz,qw", self.causal_world_from_object);
    archive.Cells("vx,vy,vz", self.causal_velocity_m_s);
    archive.Cells("refined_status", self.refined_status);
    archive.Cells("refined_x,refined_y,refined_z,refined_qx,refined_qy,refined_qz,refined_qw",
                  self.refined_world_from_object);
    archive.Cells("refined_vx,refined_vy,refined_vz", self.refined_velocity_m_s);
    archive.Cells("center_x,center_y,center_z", self.center_in_object);
    archive.Cells("half_x_m,half_y_m,half_z_m", self.half_size_m);
    archive.Cells("box_x,box_y,box_z,box_qx,box_qy,box_qz,box_qw", self.object_from_box);
    archive.Cells("length_m,height_m,width_m", self.size_m);
    archive.Cells("left_px,top_px,right_px,bottom_px", self.projected_box);
    archive.Cells("observed_landmarks", self.observed_landmarks);
    archive.Cells("detection", self.detection);
    archive.Cells("score", self.score);
  }
};

// A landmark observed in a frame: a row of landmarks.csv. Labels: 0 is the static scene, empty is
// none (an outlier). Pixels are in the left image read.
struct LandmarkRow {
  int frame = 0;
  std::int64_t id = 0;
  Eigen::Vector3d z_px = Eigen::Vector3d::Zero();  // u, v, u in the right image
  std::optional<std::int64_t> cluster;             // its cluster after the frame was processed
  std::optional<std::int64_t> inferred;            // by the energies of this frame alone
  int confidence = 0;
  Eigen::Vector3d p_in_world = Eigen::Vector3d::Zero();
  std::optional<int> truth_body;  // 0: the static scene; empty: unknown

  template <typename Self, typename Archive>
  static void VisitColumns(Self& self, Archive& archive) {
    archive.Cells("frame", self.frame);
    archive.Cells("id", self.id);
    archive.Cells("u_px,v_px,u_right_px", self.z_px);
    archive.Cells("cluster", self.cluster);
    archive.Cells("inferred", self.inferred);
    archive.Cells("confidence", self.confidence);
    archive.Cells("x,y,z", self.p_in_world);
    archive.Cells("truth_body", self.truth_body);
  }
};

}  // namespace cvo::reports
