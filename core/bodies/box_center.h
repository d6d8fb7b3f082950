// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/clustering/point_extent.h"
#include "core/clusters/frame_view.h"
#include "core/interface/box_center_options.h"

namespace cvo {

// What the steps that judge a body's centre by its box read.
struct BodyCenterOptions {
  BoxCenterOptions box_center;
  ExtentOptions extent;
  double birth_depth = 0.0;  // clusters.birth_depth
};

// Which edges of a box the image's border may cut: those closer to it than `border_px`.
struct CutEdges {
  bool left = false;
  bool top = false;
  bool right = false;
  bool bottom = false;
};
CutEdges CutBy(const StereoCamera& camera, double border_px, const ImageBox& box);

// Where a body's centre is, judged by its box and the nearest points in it alone.
struct BoxCenter {
  Eigen::Vector3d center_in_world = Eigen::Vector3d::Zero();
  double size_m = 0.0;    // smaller side of the box at the body's depth
  bool is_whole = false;  // neither cut by the image's border nor overlapped
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  // of the centre, in world, 1/m^2
};

// On the ray through the middle of the detection's box, `birth_depth` of the box's smaller
// side behind the surface points seen in it. Where the surface lies in the box says nothing of the
// centre: texture may be on one side. A box says little where it shows a part of the body only: cut
// by the image's border, or overlapped by another box.
BoxCenter CenterFromBox(const FrameView& view, const BoxCenterOptions& options, double birth_depth,
                        int detection, const Eigen::Vector3d& surface_in_world);

// Standard deviations of a body's centre that its detection's box gives, across the line of sight
// (right, down) and along it; `size_m`: smaller side of the box at the body's depth.
Eigen::Vector3d CenterDeviations(const FrameView& view, const BoxCenterOptions& options,
                                 int detection, double size_m);

// Information in world of a point at `ray` in the camera, by deviations across and along the ray.
Eigen::Matrix3d InformationAlong(const RigidTransform& world_from_camera,
                                 const Eigen::Vector3d& ray, const Eigen::Vector3d& deviations_m);

}  // namespace cvo
