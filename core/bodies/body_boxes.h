// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "core/bodies/body_place.h"
#include "core/clustering/point_extent.h"
#include "core/clusters/cluster_map.h"
#include "core/interface/body_box_options.h"

namespace cvo {

// Options for the boxes of bodies.
struct BoxSceneOptions {
  FeatureNoise noise;
  ClusterOptions clusters;
  ExtentOptions extent;
  BodyPlaceOptions place;
  BodyBoxOptions boxes;
};

// Inputs for the boxes of a frame that the estimator has finished.
struct BoxScene {
  BoxSceneOptions options;
  const ClusterMap& clusters;
  const FrameView* view = nullptr;  // with the optimised camera; null: frame without images
  FrameId newest;
  RigidTransform world_from_camera;
  Eigen::Vector3d down = Eigen::Vector3d::UnitY();  // in world
};

struct BodyTrack;

// The upright boxes of bodies (METHOD.md 10.4), which the estimator reports but never uses.
class BodyBoxes {
 public:
  // Sets box and score of every report. There is one report per live cluster, in the same order.
  void Describe(const BoxScene& scene, std::vector<ClusterReport>& reports);

 private:
  // Removes the tracks of clusters that cannot come back.
  void ForgetGone(const ClusterMap& clusters);

  std::map<ClusterId, std::shared_ptr<BodyTrack>> tracks_;
};

}  // namespace cvo
