// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/clusters/frame_view.h"
#include "core/estimation/cluster.h"
#include "core/interface/box_center_options.h"

namespace cvo {

// A box in world without a place: its axes are columns.
struct BoxShape {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();
  bool is_round = false;  // the body in it is a ball
};

struct BoxPlace {
  Eigen::Vector3d center_in_world = Eigen::Vector3d::Zero();
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  // of the centre, in world, 1/m^2
};

// What bodies are placed with.
struct BodyPlaceOptions {
  BoxCenterOptions box_center;
  double disparity_px = 0.0;  // noise.disparity_px
};

// Standard deviation of the depth of one triangulated point p in the camera, m.
double DepthDeviation(const StereoCamera& camera, double disparity_px, const Eigen::Vector3d& p);

// Where a box of this shape is in the frame, if its picture is in the middle of the cluster's
// detection, between those edges that are the body's own, and the foremost of the landmarks seen
// lie on the faces turned to the camera. Empty without a detection or landmarks.
std::optional<BoxPlace> PlaceBySurface(const FrameView& view, const BodyPlaceOptions& options,
                                       FrameId newest, const Cluster& cluster,
                                       const BoxShape& shape);

// The same for a body that is no solid box: as far away as `center_in_world`. Empty without a
// detection.
std::optional<BoxPlace> PlaceByPicture(const FrameView& view, const BodyPlaceOptions& options,
                                       FrameId newest, const Cluster& cluster,
                                       const BoxShape& shape,
                                       const Eigen::Vector3d& center_in_world);

// What pictures told so far of a body's sides; 0: nothing. What hides a body only makes its
// pictures smaller: larger ones count for more.
struct ViewedSides {
  double height_m = 0.0;
  double square_m = 0.0;  // side of a square footprint that looks as wide

  static void Add(double measured_m, double& side_m);
};

// The sides with which the body would fill the detection, if it is there and a ball or else between
// a box and an ellipsoid, as far as the image does not cut the detection (`border_px` from its
// border).
void AddPicture(const FrameView& view, double border_px, int detection, const BoxShape& shape,
                const Eigen::Vector3d& center_in_world, ViewedSides& viewed);

}  // namespace cvo
