// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/association/cluster_association_options.h"
#include "core/association/feature_grid.h"
#include "core/features/options.h"
#include "core/geometry/stereo_camera.h"
#include "core/interface/cluster_options.h"
#include "core/interface/frame.h"
#include "core/solvers/measurement_noise.h"

namespace cvo {

// What is known of the current frame when clusters are associated.
struct FrameView {
  const StereoFrame& frame;
  ShownBodies shown;
  const FeatureGrid& grid;
  StereoCamera camera;
  RigidTransform world_from_camera;
};

// Options of the search for clusters.
struct ClusterSearchOptions {
  FeatureNoise noise;
  OrbOptions orb;
  ClusterAssociationOptions association;
  ClusterOptions clusters;
  bool align_patches = true;  // tracking.align_patches
};

// A frame to be searched for clusters.
struct ClusterSearch : FrameView {
  ClusterSearchOptions options;
};

// By feature: nonzero if it is already matched.
using TakenFeatures = std::vector<char>;

}  // namespace cvo
