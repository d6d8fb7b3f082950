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

// Ground truth of a landmark in the frame in which it is observed.
struct LandmarkTruth {
  std::int16_t body = -1;  // 0: static scene, k: body k, -1: unknown or not judged
  PointMotion motion = PointMotion::kStill;

  bool operator==(const LandmarkTruth&) const = default;
};

// Landmarks observed in a frame that share their assignment by the run and their truth. They are
// counted together because a run observes millions.
struct LandmarkObservation {
  std::int32_t cluster = -1;  // 0: static scene, k: cluster k, -1: none
  LandmarkTruth truth;
  std::int32_t count = 1;
};
// Logs store its bytes as they are in memory, so there must be no padding.
static_assert(std::has_unique_object_representations_v<LandmarkObservation>);

// A cluster in one frame. The world is that of the estimated camera.
struct ClusterFrame {
  int frame = 0;
  RigidTransform world_from_object;
  // The reference point of the body: velocity_m_s is its velocity, and nearness is measured from
  // it.
  Eigen::Vector3d point_in_object = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector3d> velocity_m_s;  // of point_in_object, in world; empty: unknown
  std::optional<int> observed_landmarks = 0;    // empty: the source reports no landmarks
  bool predicted = false;                       // by the motion model alone
};

struct ClusterEstimate {
  std::int64_t id = 0;  // from 1 on; without landmarks, from 0 on
  std::string category;
  std::vector<ClusterFrame> frames;  // increasing in frame; gaps are allowed
};

// The criterion that matches clusters to bodies: the landmarks that they share or, for an estimate
// without landmarks, how near the cluster's poses are to the body (NearnessInFrame).
using MatchBy = reports::Matching;

// Estimate of the bodies by a run; frames as in the truth it is compared with.
struct ObjectEstimate {
  MatchBy match_by = MatchBy::kLandmarks;
  bool differentiated = false;  // velocities are differences of positions, not estimates
  OptionalPoses world_from_camera;
  std::vector<ClusterEstimate> clusters;                    // increasing in id
  std::vector<std::vector<LandmarkObservation>> landmarks;  // [frame]: those observed in it
};

// An estimate counts in a frame if it is not a prediction and at least this many of its landmarks
// are observed. If the source reports no landmarks, every estimate that is not a prediction counts.
constexpr int kMinObservedLandmarks = 3;
inline bool Counts(const ClusterFrame& frame) {
  return !frame.predicted &&
         frame.observed_landmarks.value_or(kMinObservedLandmarks) >= kMinObservedLandmarks;
}

// Throws Error if lengths differ from those of the truth, ids or frames do not increase or are out
// of range, or a pose, velocity or point is not finite.
void CheckEstimate(const ObjectTruth& truth, const ObjectEstimate& estimate);

}  // namespace cvo
