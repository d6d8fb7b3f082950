// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "core/base/ids.h"
#include "core/clustering/label_confidence.h"
#include "core/features/stereo_feature.h"

namespace cvo {

// Observation of a landmark in a frame of the window.
struct Observation {
  FrameId frame;
  Eigen::Vector3d z_px = Eigen::Vector3d::Zero();  // (u_left, v, u_right)
  int octave = 0;
  bool is_aligned = false;       // to the reference patch of the landmark
  float disagreement_px = 0.0F;  // between the quarters of its stereo patch, px of the level
};

// The patch that later features of a landmark are aligned with: its appearance when it was first
// seen, renewed when its scale in the image has changed by too much or alignment has failed
// (METHOD.md 3.4).
struct LandmarkReference {
  FeaturePatch patch;
  // Depth times the scale of the pyramid level: the size of a pixel of the patch at the landmark,
  // times the focal length.
  double size_m = 0.0;
};

// Covariance of the best single triangulation of a landmark, the one with the smallest determinant
// (Eq. 1 of the paper; kept in the body frame so that it turns with the body: METHOD.md 4.1).
struct LandmarkCovariance {
  Eigen::Matrix3d in_object_m2 = Eigen::Matrix3d::Identity();
  double determinant = std::numeric_limits<double>::infinity();
};

// A point of a rigid body: of the static scene (q = 0 in the paper), whose body frame is the world,
// or of a cluster.
struct Landmark {
  LandmarkId id;
  Eigen::Vector3d p_in_object = Eigen::Vector3d::Zero();
  std::vector<Observation> observations;  // in frames of the window, oldest first
  Descriptor descriptor{};                // of the last observation
  LandmarkReference reference;
  double depth_m = 0.0;  // at the last observation; with last_octave it predicts the next octave
  int last_octave = 0;
  FrameId last_seen;
  LabelState label;  // q^i and w^i

  LandmarkCovariance covariance;
  // Unit vector from the point to the camera that saw it last. Used because a body hides its own
  // far side.
  Eigen::Vector3d view_in_object = Eigen::Vector3d::Zero();
  // Information on p_in_object from a cluster's observations that have left the window (METHOD.md
  // 8.4), and the position on which they agree.
  Eigen::Matrix3d past_information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d past_mean_in_object = Eigen::Vector3d::Zero();
};

// Returns the landmark's observation in the frame; null if there is none.
const Observation* FindObservation(const Landmark& landmark, FrameId frame);

}  // namespace cvo
