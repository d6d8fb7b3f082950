// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/clustering/point_extent.h"
#include "core/clusters/frame_view.h"
#include "core/interface/box_center_options.h"

namespace cvo {

// Options of the steps that estimate a body's centre from its box.
struct BodyCenterOptions {
  BoxCenterOptions box_center;
  ExtentOptions extent;
  double birth_depth = 0.0;  // clusters.birth_depth
};

// Edges of a box that the image border may cut: those closer to it than `border_px`.
struct CutEdges {
  bool left = false;
  bool top = false;
  bool right = false;
  bool bottom = false;
};
CutEdges CutBy(const StereoCamera& camera, double border_px, const ImageBox& box);

// A body's centre as estimated from a single box and the surface points in it.
struct BoxCenter {
  Eigen::Vector3d center_in_world = Eigen::Vector3d::Zero();
  double size_m = 0.0;    // smaller side of the box at the depth of the surface
  bool is_whole = false;  // neither cut by the image border nor overlapped
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  // of the centre, in world, 1/m^2
};

// Places the centre on the ray through the centre of the detection's box, behind the surface by
// `birth_depth` times the smaller side of the box. Where in the box the surface points lie does not
// matter: the texture may be on one side. The information is low where the box may show only a part
// of the body, because the image border cuts it or another box overlaps it.
BoxCenter CenterFromBox(const FrameView& view, const BoxCenterOptions& options, double birth_depth,
                        int detection, const Eigen::Vector3d& surface_in_world);

// Standard deviations (m) of a body's centre as estimated from its detection's box, across the line
// of sight (right, down) and along it. `size_m` is the smaller side of the box at the body's depth.
Eigen::Vector3d CenterDeviations(const FrameView& view, const BoxCenterOptions& options,
                                 int detection, double size_m);

// Information matrix, in world, of a point in direction `ray` of the camera, given the standard
// deviations across the ray (right, down) and along it.
Eigen::Matrix3d InformationAlong(const RigidTransform& world_from_camera,
                                 const Eigen::Vector3d& ray, const Eigen::Vector3d& deviations_m);

}  // namespace cvo
