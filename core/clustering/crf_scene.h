// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/association/image_box.h"
#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// A landmark seen in the current frame (section 3.2 of the paper).
struct CrfNode {
  Eigen::Vector3d z_px = Eigen::Vector3d::Zero();         // z_t^i
  Eigen::Vector3d p_in_camera = Eigen::Vector3d::Zero();  // Z_t^i, triangulated from z_t^i alone
  Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Identity();  // of p_in_camera
  // Its observation in an earlier frame, z_{t'}^i.
  struct Past {
    int frame = 0;  // index of the earlier frame, as in CrfLabel::past_from_now
    Eigen::Vector3d z_px = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance_px2 = Eigen::Matrix3d::Identity();
  };
  std::optional<Past> past;  // empty: its motion is unknown
  // Position of the landmark in the current camera frame, for the motion and pairwise terms.
  struct Place {
    Eigen::Vector3d p_in_camera = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Zero();
  };
  std::optional<Place> estimate;  // p_t^i of the landmark; empty: Z_t^i is used
  Place MovingPlace() const { return estimate.value_or(Place{p_in_camera, covariance_m2}); }
};

// Kinds of the M classes, in the order of the labels: the static scene, live clusters, boxes that
// belong to no cluster, and the outlier class.
enum class LabelKind { kStatic, kCluster, kNewBox, kOutlier };

struct CrfLabel {
  LabelKind kind = LabelKind::kStatic;
  std::optional<ImageBox> box;  // of the associated detection, or of the new box itself
  // Where the cluster is expected in the image, if no detection is associated with it.
  std::optional<ImageBox> predicted_box;
  // Centre and size of a cluster or new box: half sides along the columns of camera_from_axes.
  struct Extent {
    Eigen::Vector3d center_in_camera = Eigen::Vector3d::Zero();
    Eigen::Matrix3d camera_from_axes = Eigen::Matrix3d::Identity();
    Eigen::Vector3d half_size_m = Eigen::Vector3d::Ones();
  };
  std::optional<Extent> extent;
  // For each earlier frame, maps points p of this body from the current camera frame to the camera
  // frame of that time, past_from_now[frame] * p: T_{t'}^{cq} (P_t^q)^-1 P_t^c of the paper. Empty
  // if the body had no pose then.
  std::vector<std::optional<RigidTransform>> past_from_now;
};

struct CrfScene {
  StereoCamera camera;
  std::vector<CrfNode> nodes;
  std::vector<CrfLabel> labels;
};

}  // namespace cvo
