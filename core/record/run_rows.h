// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/record/csv_record.h"

// The rows of a run's tables. Poses, points and velocities are in the world of the first left
// camera.
namespace cvo::reports {

// A live cluster in a frame: a row of objects.csv.
struct ObjectRow {
  int frame = 0;  // number in the folder of the sequence
  std::int64_t timestamp_ns = 0;
  std::int64_t id = 0;
  std::string category;
  std::string status;  // "tracked"; "predicted" by the motion model alone: hidden or lost
  // As estimated when the frame was processed, and as last estimated; empty if the run has no such
  // estimate.
  std::optional<RigidTransform> causal_world_from_object;
  std::optional<Eigen::Vector3d> causal_velocity_m_s;
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

  bool predicted() const { return status == "predicted"; }
  // As last estimated.
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
    archive.Cells("status", self.status);
    archive.Cells("x,y,z,qx,qy,qz,qw", self.causal_world_from_object);
    archive.Cells("vx,vy,vz", self.causal_velocity_m_s);
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
// none (an outlier). Pixels are in the left image read, energies in nats.
struct LandmarkRow {
  int frame = 0;
  std::int64_t id = 0;
  Eigen::Vector3d z_px = Eigen::Vector3d::Zero();  // u, v, u in the right image
  std::optional<std::int64_t> cluster;             // its cluster after the frame was processed
  std::optional<std::int64_t> inferred;            // by the energies of this frame alone
  int confidence = 0;
  Eigen::Vector3d energies = Eigen::Vector3d::Zero();  // 2D, 3D, motion
  Eigen::Vector3d p_in_world = Eigen::Vector3d::Zero();
  std::optional<int> truth_body;       // 0: the static scene; empty: unknown
  std::optional<std::int64_t> second;  // the label with the second lowest energy
  Eigen::Vector3d second_energies = Eigen::Vector3d::Zero();

  template <typename Self, typename Archive>
  static void VisitColumns(Self& self, Archive& archive) {
    archive.Cells("frame", self.frame);
    archive.Cells("id", self.id);
    archive.Cells("u_px,v_px,u_right_px", self.z_px);
    archive.Cells("cluster", self.cluster);
    archive.Cells("inferred", self.inferred);
    archive.Cells("confidence", self.confidence);
    archive.Cells("energy_2d,energy_3d,energy_motion", self.energies);
    archive.Cells("x,y,z", self.p_in_world);
    archive.Cells("truth_body", self.truth_body);
    archive.Cells("second", self.second);
    archive.Cells("second_2d,second_3d,second_motion", self.second_energies);
  }
};

}  // namespace cvo::reports
