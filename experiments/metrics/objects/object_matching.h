// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "core/record/contract.h"
#include "experiments/metrics/pose_errors.h"

namespace cvo {

// A body in one frame. Its body frame is that of the ground truth, the same at all times.
struct BodyFrame {
  RigidTransform world_from_object;
  bool visible = false;  // enough of it is seen to be judged (METHOD.md 10.3)
};

struct TruthBody {
  int id = 0;  // 1, 2, ...
  std::string name;
  std::string category;
  // Diagonal of the box around the body, the largest over all frames.
  double diagonal_m = 0.0;
  std::vector<std::optional<BodyFrame>> frames;  // empty for a frame without truth
  double travel_m = 0.0;                         // FarthestApart_m of its frames
  bool mover = false;                            // travel_m > ObjectTruth::mover_travel_m
};

// Ground truth of the bodies of a sequence. The world is that of the camera truth, the left camera
// of frame 0 of the folder. Frames are counted from the first one that is run.
struct ObjectTruth {
  reports::Contract contract;   // truth, camera_truth and the meaning of `visible`
  double mover_travel_m = 0.0;  // 0.2 m indoors, 2 m outdoors
  int first_frame = 0;          // first frame run, as numbered in the folder; for contracts
  // Whether the truth gives the body that each pixel shows. If not, clusters are matched by
  // nearness.
  bool tells_pixels = true;
  // The true poses jitter, so a body that is no mover is taken never to move.
  bool movers_alone_move = false;
  std::vector<std::int64_t> timestamps_ns;
  OptionalPoses world_from_camera;
  std::vector<TruthBody> bodies;  // sorted by id

  std::size_t frame_count() const { return timestamps_ns.size(); }
};

// Returns the body with this id; nullptr if there is none.
const TruthBody* FindBody(const ObjectTruth& truth, int id);

// Largest distance between any two positions of a body, m. The path length would add up the jitter
// of labels: within 100 frames, a parked car would travel metres.
double FarthestApart_m(const std::vector<std::optional<BodyFrame>>& frames);

// Sets travel_m and mover of every body. Requires as many frames of the camera and each body as
// timestamps, and ids that increase from 1 on.
void FinishTruth(ObjectTruth& truth);

// Velocity, in world, of a point of the body, from differences of its positions, m/s: central if
// both neighbouring frames have truth, one-sided if only one has. Empty if neither has, or if the
// frame itself has none.
[[nodiscard]] std::optional<Eigen::Vector3d> PointVelocity(const ObjectTruth& truth,
                                                           const TruthBody& body, int frame,
                                                           const Eigen::Vector3d& p_in_object);

// How a point of a body has moved up to a frame.
enum class PointMotion : std::int16_t {
  kStill,    // has not moved yet
  kMoving,   // more than kMovedPoint_m from its position in one of the last kMovedFrames frames
  kStopped,  // moved earlier, but no longer
};
constexpr double kMovedPoint_m = 0.02;
constexpr int kMovedFrames = 15;
PointMotion MotionOfPoint(const ObjectTruth& truth, const TruthBody& body, int frame,
                          const Eigen::Vector3d& p_in_object);

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

// Requires as many frames as the truth has, and ids and frames that increase.
void CheckEstimate(const ObjectTruth& truth, const ObjectEstimate& estimate);

// A body and the cluster that it is scored with.
struct ObjectMatch {
  std::size_t body = 0;     // index into ObjectTruth::bodies
  std::size_t cluster = 0;  // index into ObjectEstimate::clusters
  double shared = 0.0;  // sum over frames of the cluster's landmarks on the body, or of nearness
};

// Matches bodies and clusters one-to-one so as to maximise the total that the pairs share,
// landmarks or nearness (ObjectEstimate::match_by). Pairs that share nothing are not matched.
// Sorted by body.
std::vector<ObjectMatch> MatchObjects(const ObjectTruth& truth, const ObjectEstimate& estimate);

// How continuously a body is tracked over its visible frames. Its cluster in a frame is the one
// with the most landmarks on it, at least kMinObservedLandmarks; ties are broken in favour of its
// last cluster, then of the lowest id. With matching by nearness, it is the body's cluster in the
// one-to-one matching that maximises total nearness in the frame.
struct Continuity {
  int id_switches = 0;  // a cluster other than its last one, also across occlusions
  int fragments = 0;    // a cluster again after visible frames without one
};
std::vector<Continuity> MeasureContinuity(const ObjectTruth& truth,
                                          const ObjectEstimate& estimate);  // [body]

// Nearness [body, cluster] of each cluster to each body in a frame: 1 - d / r, where d is the
// distance between their centres and r the diagonal of the body's box. r is large enough for
// estimates whose body frame is at the edge of the body. 0 if d exceeds r, or if the body, its box,
// the cluster or a camera pose is missing. Each centre is expressed in its own camera frame, so
// that drift has no effect.
Eigen::MatrixXd NearnessInFrame(const ObjectTruth& truth, const ObjectEstimate& estimate,
                                std::size_t frame);

}  // namespace cvo
