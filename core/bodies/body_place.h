// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/clusters/frame_view.h"
#include "core/estimation/cluster.h"
#include "core/interface/box_center_options.h"

namespace cvo {

// Orientation and size of a box in world, without a position. The axes are columns.
struct BoxShape {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();
  bool is_round = false;  // the body in it is a ball
};

struct BoxPlace {
  Eigen::Vector3d center_in_world = Eigen::Vector3d::Zero();
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  // of the centre, in world, 1/m^2
};

// Options for placing bodies.
struct BodyPlaceOptions {
  BoxCenterOptions box_center;
  double disparity_px = 0.0;  // noise.disparity_px
};

// Standard deviation of the depth of a single triangulated point p in the camera frame, m.
double DepthDeviation(const StereoCamera& camera, double disparity_px, const Eigen::Vector3d& p);

// Places a box of this shape such that its projection is centred in the cluster's detection,
// between those edges that the image does not cut, and the foremost of the landmarks seen lie on
// the faces turned to the camera. Empty if frame `newest` has no detection or no landmarks of the
// cluster.
std::optional<BoxPlace> PlaceBySurface(const FrameView& view, const BodyPlaceOptions& options,
                                       FrameId newest, const Cluster& cluster,
                                       const BoxShape& shape);

// The same for a body that is not a solid box: the depth is that of `center_in_world`. Empty
// without a detection, or if that depth is below 0.5 m.
std::optional<BoxPlace> PlaceByPicture(const FrameView& view, const BodyPlaceOptions& options,
                                       FrameId newest, const Cluster& cluster,
                                       const BoxShape& shape,
                                       const Eigen::Vector3d& center_in_world);

// The sides of a body as seen in images so far; 0: not yet seen. Occlusion only makes a body look
// smaller, so larger measurements have more weight.
struct ViewedSides {
  double height_m = 0.0;
  double square_m = 0.0;  // side of the square footprint that looks as wide

  static void Add(double measured_m, double& side_m);
};

// Adds the sides with which a body at `center_in_world` would fill the detection: those of a ball,
// or otherwise midway between those of a box and of an ellipsoid. Height and width are measured
// only where both edges are at least `border_px` from the image border, which may cut the
// detection.
void AddPicture(const FrameView& view, double border_px, int detection, const BoxShape& shape,
                const Eigen::Vector3d& center_in_world, ViewedSides& viewed);

}  // namespace cvo
