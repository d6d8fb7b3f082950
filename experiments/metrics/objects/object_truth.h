// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/metrics/pose_errors.h"
#include "reports/results/contract.h"

namespace cvo {

// A body in one frame. The frame of the body is that of its truth, the same at all times.
struct BodyFrame {
  RigidTransform world_from_object;
  bool visible = false;  // enough of it to be judged (METHOD.md 10.3)
};

struct TruthBody {
  int id = 0;  // 1, 2, ...
  std::string name;
  std::string category;
  double diagonal_m = 0.0;                       // of the box around it, the largest there is
  std::vector<std::optional<BodyFrame>> frames;  // empty where the truth says nothing
  double travel_m = 0.0;                         // FarthestApart_m of its positions
  bool mover = false;                            // travel_m > ObjectTruth::mover_travel_m
};

// What is true of the bodies of a sequence. World is that of its camera truth, the left camera of
// frame 0 of the folder; frames are counted from the first one that is run.
struct ObjectTruth {
  reports::Contract contract;      // truth, camera_truth and what `visible` means
  double mover_travel_m = 0.0;     // 0.2 indoors, 2 outdoors
  int first_frame = 0;             // of those run, in the folder; for contracts
  bool tells_pixels = true;        // which body a pixel shows; else nearness tells bodies apart
  bool movers_alone_move = false;  // poses jitter: a body that is no mover never moves
  std::vector<std::int64_t> timestamps_ns;
  OptionalPoses world_from_camera;
  std::vector<TruthBody> bodies;  // by id

  std::size_t frame_count() const { return timestamps_ns.size(); }
};

// nullptr where no body has this id.
const TruthBody* FindBody(const ObjectTruth& truth, int id);

// The largest distance between two of a body's positions, m. The length of its path would add up
// the jitter of labels: a parked car of 100 frames would travel metres.
double FarthestApart_m(const std::vector<std::optional<BodyFrame>>& frames);

// Fills in travel and mover of every body. Throws Error where a body has another number of frames
// than the truth, ids do not increase from 1 on, or a pose is not finite.
void FinishTruth(ObjectTruth& truth);

// Velocity in world of a point of the body by differences of its positions, m/s: central where both
// neighbours have truth, else one-sided; empty where none has.
[[nodiscard]] std::optional<Eigen::Vector3d> PointVelocity(const ObjectTruth& truth,
                                                           const TruthBody& body, int frame,
                                                           const Eigen::Vector3d& p_in_object);

// How a point of a body has moved up to a frame.
enum class PointMotion : std::int16_t {
  kStill,    // not yet
  kMoving,   // by more than kMovedPoint_m from where it was in one of the last kMovedFrames
  kStopped,  // earlier, and no longer
};
constexpr double kMovedPoint_m = 0.02;
constexpr int kMovedFrames = 15;
PointMotion MotionOfPoint(const ObjectTruth& truth, const TruthBody& body, int frame,
                          const Eigen::Vector3d& p_in_object);

}  // namespace cvo
