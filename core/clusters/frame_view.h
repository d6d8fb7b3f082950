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

// The current frame, as far as it is known when clusters are associated.
struct FrameView {
  const StereoFrame& frame;
  ShownBodies shown;
  const FeatureGrid& grid;
  StereoCamera camera;
  RigidTransform world_from_camera;
};

// What clusters are looked for with.
struct ClusterSearchOptions {
  FeatureNoise noise;
  OrbOptions orb;
  ClusterAssociationOptions association;
  ClusterOptions clusters;
  bool align_patches = true;  // tracking.align_patches
};

// A frame in which clusters are looked for.
struct ClusterSearch : FrameView {
  ClusterSearchOptions options;
};

// Features that are matched already, by index.
using TakenFeatures = std::vector<char>;

}  // namespace cvo
