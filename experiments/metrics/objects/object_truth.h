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

// Sets travel_m and mover of every body. Throws Error if the number of frames of the camera or a
// body differs from that of the timestamps, ids do not increase from 1 on, or a body's pose is not
// finite.
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

}  // namespace cvo
