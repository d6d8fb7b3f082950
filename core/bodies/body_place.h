// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/base/rng.h"
#include "core/clusters/cluster_map.h"
#include "core/estimation/cluster.h"
#include "core/geometry/rigid_transform.h"
#include "core/interface/body_box_options.h"

namespace cvo {

// Returns the level component of a direction with unit length; an arbitrary level direction if it
// is vertical.
Eigen::Vector3d Levelled(const Eigen::Vector3d& direction, const Eigen::Vector3d& down);

// Turns a direction about the vertical as the motion does. Roll and pitch do not change it.
Eigen::Vector3d TurnedBy(const RigidTransform& motion, const Eigen::Vector3d& down,
                         const Eigen::Vector3d& direction);

// Returns the axes forward, down, and left of an observer who looks forward, as columns (KITTI's x,
// y and z of a body). `forward` and `down` must be unit vectors at right angles.
Eigen::Matrix3d BoxAxes(const Eigen::Vector3d& forward, const Eigen::Vector3d& down);

// Returns the level direction in which the point of the cluster moved, over the shortest past in
// which it moved by more than `least_m`. Empty if it has not moved that far since the oldest state.
std::optional<Eigen::Vector3d> DirectionOfMotion(const Cluster& cluster,
                                                 const Eigen::Vector3d& p_in_object,
                                                 const Eigen::Vector3d& down, double least_m);

// Estimates which way is down, for boxes of bodies that stand on the ground (METHOD.md 10.4): the
// normal of the plane that carries many static points and has hardly any below it, averaged over
// the frames; the camera's own y axis if there is no such plane.
class GroundDirection {
 public:
  explicit GroundDirection(std::uint64_t seed) : rng_(seed, "ground") {}

  // Adds a frame, with the static points that it shows, in world.
  void Update(std::span<const Eigen::Vector3d> points, const RigidTransform& world_from_camera);

  // Returns the unit vector that points down, in world.
  Eigen::Vector3d Down(const RigidTransform& world_from_camera) const;

 private:
  Rng rng_;
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();  // of normals, weighted by their number of points
};

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

// Standard deviation of the depth of a single triangulated point p in the camera frame, m.
double DepthDeviation(const StereoCamera& camera, double disparity_px, const Eigen::Vector3d& p);

// Places a box of this shape such that its projection is centred in the cluster's detection,
// between those edges that the image does not cut, and the foremost of the landmarks seen lie on
// the faces turned to the camera. Empty if frame `newest` has no detection or no landmarks of the
// cluster.
std::optional<BoxPlace> PlaceBySurface(const FrameView& view, FrameId newest,
                                       const Cluster& cluster, const BoxShape& shape);

// The same for a body that is not a solid box: the depth is that of `center_in_world`. Empty
// without a detection, or if that depth is below 0.5 m.
std::optional<BoxPlace> PlaceByPicture(const FrameView& view, FrameId newest,
                                       const Cluster& cluster, const BoxShape& shape,
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
// only between edges that the image does not cut (CutBy).
void AddPicture(const FrameView& view, int detection, const BoxShape& shape,
                const Eigen::Vector3d& center_in_world, ViewedSides& viewed);

}  // namespace cvo
