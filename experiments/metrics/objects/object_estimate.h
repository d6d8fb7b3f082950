// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "experiments/metrics/objects/object_truth.h"
#include "reports/results/contract.h"

namespace cvo {

// What is true of a landmark in the frame it is observed in.
struct LandmarkTruth {
  std::int16_t body = -1;  // 0 the static scene, k a body, -1 not known or not judged
  PointMotion motion = PointMotion::kStill;

  bool operator==(const LandmarkTruth&) const = default;
};

// Landmarks observed in a frame that are alike: what the run takes them for, and what they are. A
// run observes millions.
struct LandmarkObservation {
  std::int32_t cluster = -1;  // 0 the static scene, k a cluster, -1 none
  LandmarkTruth truth;
  std::int32_t count = 1;
};
// It is packed as it lies in memory: padding would be bytes of no value.
static_assert(std::has_unique_object_representations_v<LandmarkObservation>);

// A cluster in a frame. World is that of the estimated camera.
struct ClusterFrame {
  int frame = 0;
  RigidTransform world_from_object;
  // The point that stands for the body: its velocity is given, its nearness tells bodies apart.
  Eigen::Vector3d point_in_object = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector3d> velocity_m_s;  // of that point, in world; empty: not known
  std::optional<int> observed_landmarks = 0;    // empty: whoever made the estimate tells of none
  bool predicted = false;                       // by the motion model alone
};

struct ClusterEstimate {
  std::int64_t id = 0;  // from 1 on, without landmarks from 0 on
  std::string category;
  std::vector<ClusterFrame> frames;  // increasing in frame; gaps are allowed
};

// What tells which body a cluster is: the landmarks that the two share, or, of an estimate without
// landmarks, how near its poses are to the body (NearnessInFrame).
using MatchBy = reports::Matching;

// What a run says of the bodies; frames as in the truth it is compared with.
struct ObjectEstimate {
  MatchBy match_by = MatchBy::kLandmarks;
  bool differentiated = false;  // velocities are differences of positions, not estimates
  OptionalPoses world_from_camera;
  std::vector<ClusterEstimate> clusters;                    // increasing in id
  std::vector<std::vector<LandmarkObservation>> landmarks;  // [frame]: observed in it
};

// An estimate counts where at least this many of its landmarks are observed in the frame, and
// wherever there is one if none are told of.
constexpr int kMinObservedLandmarks = 3;
inline bool Counts(const ClusterFrame& frame) {
  return !frame.predicted &&
         frame.observed_landmarks.value_or(kMinObservedLandmarks) >= kMinObservedLandmarks;
}

// Throws Error where lengths differ from the truth's, ids or frames do not increase or lie outside
// of it, or a pose is not finite.
void CheckEstimate(const ObjectTruth& truth, const ObjectEstimate& estimate);

}  // namespace cvo
