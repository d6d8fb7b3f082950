// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include "core/bodies/body_place.h"
#include "core/clustering/point_extent.h"
#include "core/clusters/cluster_map.h"
#include "core/estimation/cluster.h"
#include "core/interface/body_box_options.h"

namespace cvo {

// Confidence, in (0, 1), that a body is where the cluster is estimated in frame `newest`, for
// ranking estimates (METHOD.md 10.1). `view` is null in a frame without images.
double ScoreOf(const Options& options, const FrameView* view, FrameId newest,
               const Cluster& cluster);

// The sides of bodies as estimated from landmarks, for classes without a known size.

// Returns the level axes (BoxAxes) along which the points (columns, in world) have the smallest
// footprint; of its four directions, the one nearest to `forward` is the first axis. With fewer
// than 20 points, that axis is `forward` itself.
Eigen::Matrix3d FootprintAxes(const Eigen::Matrix3Xd& points, const Eigen::Vector3d& forward,
                              const Eigen::Vector3d& down);

// Range between outer quantiles of the points along the axes.
struct LandmarkSides {
  Eigen::Vector3d low = Eigen::Vector3d::Zero();  // coordinates along the axes
  Eigen::Vector3d high = Eigen::Vector3d::Zero();
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();
};
LandmarkSides SidesAlong(const Eigen::Matrix3d& axes, const Eigen::Matrix3Xd& points);

// Corrects the sides by those seen in images: the height is that in the images, and each side of
// the footprint is kept within the factor kFootprintRatio of the square that looks as wide.
Eigen::Vector3d WithPictures(const Eigen::Vector3d& size_m, const ViewedSides& viewed);

// Returns the sides of a ball: all are its diameter, which is the larger of height and width in the
// images or, without these, the largest side of the landmarks.
Eigen::Vector3d SidesOfBall(const Eigen::Vector3d& size_m, const ViewedSides& viewed);

// Returns the centre of the box in world. Where a side is longer than its landmarks reach, the part
// without landmarks is on the side away from the camera.
Eigen::Vector3d CenterBehindNearSides(const LandmarkSides& sides, const BoxShape& shape,
                                      const Eigen::Vector3d& camera_in_world);

// Edges of a box that the image border may cut: those closer to it than kBorder.
struct CutEdges {
  bool left = false;
  bool top = false;
  bool right = false;
  bool bottom = false;
};
CutEdges CutBy(const StereoCamera& camera, const ImageBox& box);

// Standard deviations (m) of a body's centre as estimated from its detection's box, across the line
// of sight (right, down) and along it. `size_m` is the smaller side of the box at the body's depth.
Eigen::Vector3d CenterDeviations(const FrameView& view, int detection, double size_m);

// Information matrix, in world, of a point in direction `ray` of the camera, given the standard
// deviations across the ray (right, down) and along it.
Eigen::Matrix3d InformationAlong(const RigidTransform& world_from_camera,
                                 const Eigen::Vector3d& ray, const Eigen::Vector3d& deviations_m);

// Inputs for the boxes of a frame that the estimator has finished.
struct BoxScene {
  const Options& options;
  const ClusterMap& clusters;
  const FrameView* view = nullptr;  // with the optimised camera; null: frame without images
  FrameId newest;
  RigidTransform world_from_camera;
  Eigen::Vector3d down = Eigen::Vector3d::UnitY();  // in world
};

// Estimate of a body's centre, in the body frame, from the boxes that show it. A box constrains the
// centre well across the line of sight but poorly along it. Boxes from several sides determine it
// fully.
struct CenterEstimate {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d weighted = Eigen::Vector3d::Zero();  // information * centre
  int boxes = 0;

  // Adds a centre and its information, given in the frame `there`.
  void Add(const RigidTransform& object_from_there, const Eigen::Vector3d& center_there,
           const Eigen::Matrix3d& information_there);
  // Adds the covariance of the body's motion since the last view, in the object frame.
  void Loosen(const Eigen::Matrix3d& covariance_m2);
  // The estimated centre; the origin if there is no box yet.
  Eigen::Vector3d InObject() const;
};

// What is known of a body's box at the time of one state of its cluster, in world.
struct BodyTrack {
  FrameId frame;
  RigidTransform world_from_object;                    // at `frame`, which may have left the window
  Eigen::Vector3d forward = Eigen::Vector3d::UnitZ();  // level
  BoxShape shape;
  CenterEstimate center;  // in the object frame, averaged over the views
  Eigen::Vector3d landmark_center = Eigen::Vector3d::Zero();
  ViewedSides viewed;
};

// The upright boxes of bodies (METHOD.md 10.4), which the estimator reports but never uses.
class BodyBoxes {
 public:
  // Sets box and score of every report. There is one report per live cluster, in the same order.
  void Describe(const BoxScene& scene, std::vector<ClusterReport>& reports);

 private:
  std::map<ClusterId, BodyTrack> tracks_;
};

}  // namespace cvo
