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
  // Where an earlier frame saw it: z_{t'}^i.
  struct Past {
    int frame = 0;  // index of the earlier frame, as in CrfLabel::past_from_now
    Eigen::Vector3d z_px = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance_px2 = Eigen::Matrix3d::Identity();
  };
  std::optional<Past> past;  // empty: nothing can be said of its motion
  // Where the landmark is in the current camera, for the motion and the pairwise term.
  struct Place {
    Eigen::Vector3d p_in_camera = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Zero();
  };
  std::optional<Place> estimate;  // p_t^i of the landmark; empty: Z_t^i stands for it
  Place MovingPlace() const { return estimate.value_or(Place{p_in_camera, covariance_m2}); }
};

// One of the M classes. The order is: the static scene first, live clusters, boxes that belong to
// no cluster, the outlier class last.
enum class LabelKind { kStatic, kCluster, kNewBox, kOutlier };

struct CrfLabel {
  LabelKind kind = LabelKind::kStatic;
  std::optional<ImageBox> box;  // of the detection associated with it or represented by it
  // Where the cluster is expected in the image though no detection was associated with it.
  std::optional<ImageBox> predicted_box;
  // Centre and size of a cluster or new box: half sides along the columns of camera_from_axes.
  struct Extent {
    Eigen::Vector3d center_in_camera = Eigen::Vector3d::Zero();
    Eigen::Matrix3d camera_from_axes = Eigen::Matrix3d::Identity();
    Eigen::Vector3d half_size_m = Eigen::Vector3d::Ones();
  };
  std::optional<Extent> extent;
  // Where a point of this body that is now at p in the current camera was in an earlier frame's
  // camera: past_from_now[frame] * p, T_{t'}^{cq} (P_t^q)^-1 P_t^c of the paper. Empty where the
  // body had no pose then.
  std::vector<std::optional<RigidTransform>> past_from_now;
};

struct CrfScene {
  StereoCamera camera;
  std::vector<CrfNode> nodes;
  std::vector<CrfLabel> labels;
};

}  // namespace cvo
