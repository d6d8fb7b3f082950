// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/stage_times.h"
#include "core/base/task_pool.h"
#include "core/geometry/stereo_camera.h"
#include "core/interface/frame.h"
#include "core/interface/options.h"

namespace cvo {

struct OdometrySetup {
  StereoCamera camera;
  Options options;
  std::uint64_t seed = 0;  // of the estimator's random draws (RANSAC)
};

// A cluster in one frame. Pose and velocity are the latest estimates, everything else is as
// reported when the frame arrived. All of it is relative to the current object frame.
struct ClusterPose : ClusterReport {
  std::int64_t frame = 0;  // index from the first processed frame, counting skipped ones
  std::int64_t timestamp_ns = 0;
};

struct ClusterTrajectory {
  ClusterId id;
  std::string category;
  // Sorted by frame: one pose per frame in which the cluster was live, including frames before it
  // was confirmed and earlier frames to which it was traced back (METHOD.md 6.6).
  std::vector<ClusterPose> poses;
};

// Interface of the estimator. Virtual dispatch occurs only here, once per frame.
class Odometry {
 public:
  virtual ~Odometry() = default;

  // Processes one stereo frame and returns its report. Timestamps must increase strictly: throws
  // Error otherwise.
  virtual FrameReport Process(const StereoFrame& frame, StageTimes& times) = 0;

  // Processes a frame whose images are missing: predicts the camera and leaves the map unchanged.
  virtual FrameReport Skip(std::int64_t timestamp_ns) = 0;

  // Returns world_from_camera of every frame so far, including skipped ones. A frame keeps the pose
  // it had when it left the temporal track, |T_t| frames after it arrived.
  virtual std::vector<RigidTransform> Trajectory() const = 0;

  // Returns every cluster that was ever reported, including archived ones, sorted by id.
  virtual std::vector<ClusterTrajectory> ClusterTrajectories() const = 0;

  // Returns the poses of reported clusters that no later frame changes, sorted by id, and removes
  // them from the estimator: ClusterTrajectories() no longer contains them. This bounds memory in
  // long runs.
  virtual std::vector<ClusterTrajectory> TakeSettledPoses() { return {}; }
};

}  // namespace cvo
