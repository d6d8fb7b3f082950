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
  std::uint64_t seed = 0;  // of the estimator's own draws (RANSAC)
};

// A cluster in one frame: pose and velocity as last estimated, all else as when the frame came, in
// the body's frame as it is now.
struct ClusterPose : ClusterReport {
  std::int64_t frame = 0;  // counted from the first one processed, skipped ones included
  std::int64_t timestamp_ns = 0;
};

struct ClusterTrajectory {
  ClusterId id;
  std::string category;
  // By frame, one per frame in which the cluster was live, those before it was confirmed included,
  // and those before it was found in which it was traced back (METHOD.md 6.6).
  std::vector<ClusterPose> poses;
};

// The estimator seen from outside; the only virtual call, once per frame.
class Odometry {
 public:
  virtual ~Odometry() = default;

  // One stereo frame in, its report out. Timestamps must increase strictly: throws Error otherwise.
  virtual FrameReport Process(const StereoFrame& frame, StageTimes& times) = 0;

  // A frame whose images are missing: the camera is predicted, the map is left alone.
  virtual FrameReport Skip(std::int64_t timestamp_ns) = 0;

  // world_from_camera of every frame so far, skipped ones included: a frame keeps the
  // pose it had when it left the temporal track, |T_t| frames after it came.
  virtual std::vector<RigidTransform> Trajectory() const = 0;

  // Every cluster that was ever reported, archived ones included, by id.
  virtual std::vector<ClusterTrajectory> ClusterTrajectories() const = 0;

  // Poses of reported clusters that no later frame changes, by id. They leave the estimator:
  // ClusterTrajectories() is without them from then on. For runs of any length.
  virtual std::vector<ClusterTrajectory> TakeSettledPoses() { return {}; }
};

}  // namespace cvo
