// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "core/base/ids.h"
#include "core/clustering/label_confidence.h"
#include "core/features/stereo_feature.h"

namespace cvo {

// A landmark seen in a frame of the window.
struct Observation {
  FrameId frame;
  Eigen::Vector3d z_px = Eigen::Vector3d::Zero();  // (u_left, v, u_right)
  int octave = 0;
  bool is_aligned = false;       // to the landmark's reference
  float disagreement_px = 0.0F;  // of its stereo patch, px of the level
};

// What later features of a landmark are aligned with: how it looked when it was first seen, or when
// it had changed much since (METHOD.md 3.4).
struct LandmarkReference {
  FeaturePatch patch;
  double size_m =
      0.0;  // depth times the scale of the level: what a pixel is times the focal length
};

// The best single triangulation of a landmark, the one of the smallest determinant (Eq. 1 of the
// paper, kept in the body's frame so that it turns with the body: METHOD.md 4.1).
struct LandmarkCovariance {
  Eigen::Matrix3d in_object_m2 = Eigen::Matrix3d::Identity();
  double determinant = std::numeric_limits<double>::infinity();
};

// A point of a rigid body: of the static scene (q = 0 in the paper), whose frame is the world, or
// of a cluster.
struct Landmark {
  LandmarkId id;
  Eigen::Vector3d p_in_object = Eigen::Vector3d::Zero();
  std::vector<Observation> observations;  // in frames of the window, oldest first
  Descriptor descriptor{};                // of the last observation
  LandmarkReference reference;
  double depth_m = 0.0;  // at the last observation; with its octave it predicts the next
  int last_octave = 0;
  FrameId last_seen;
  LabelState label;  // q^i and w^i

  LandmarkCovariance covariance;
  // From the point to the camera that saw it last, unit length: a body hides its own far side.
  Eigen::Vector3d view_in_object = Eigen::Vector3d::Zero();
  // What a cluster's observations that left the window said of p_in_object (METHOD.md 8.4): its
  // information, and the position that they agree on.
  Eigen::Matrix3d past_information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d past_mean_in_object = Eigen::Vector3d::Zero();
};

// The landmark's observation in the frame; null where there is none.
const Observation* FindObservation(const Landmark& landmark, FrameId frame);

}  // namespace cvo
