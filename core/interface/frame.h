// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/ids.h"
#include "core/base/stage_times.h"
#include "core/base/task_pool.h"
#include "core/clustering/dense_crf.h"
#include "core/features/stereo_feature.h"
#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"
#include "core/interface/options.h"
#include "core/solvers/window_solver.h"

namespace cvo {

// A detection: the 2D box that a detector found around a body in the left image (B_t^m of the
// paper).
struct Detection {
  ImageBox box;
  std::string category;  // class under which the body is reported, such as "Car" or "chair"
  double score = 1.0;
};

// External knowledge about a frame that replaces estimates and is taken as true: a camera pose from
// another odometry, an instance segmentation, a box tracker. All of it is optional. A body has the
// same id in all frames.
struct GivenKnowledge {
  std::optional<RigidTransform> world_from_camera;  // world = left camera of the first frame
  std::vector<BodyId> feature_body;                 // by feature; empty if not given
  std::vector<BodyId> detection_body;               // by detection; empty if not given
};

// The output of the front end for one stereo pair, which is the input of the estimator.
struct StereoFrame {
  std::int64_t timestamp_ns = 0;  // strictly increasing from frame to frame
  std::vector<StereoFeature> features;
  std::vector<Detection> detections;
  GivenKnowledge given;
};

// The information on bodies in a frame that the estimator may use. Holds views into the frame,
// which must outlive them.
struct ShownBodies {
  std::span<const Detection> detections;
  std::span<const BodyId> feature_body;    // as in GivenKnowledge
  std::span<const BodyId> detection_body;  // as in GivenKnowledge
};

// Throws Error if a list of bodies in `frame.given` is neither empty nor as long as the list of
// features or detections that it labels.
void CheckGiven(const StereoFrame& frame);

enum class FrameStatus {
  kFirst,      // starts the map: the pose is the identity or, after a restart, the prediction
  kTracked,    // pose from at least min_inliers landmarks
  kRecovered,  // tracked again after at least one lost frame
  kLost,       // too few landmarks: the pose is predicted
  kSkipped,    // no image: the pose is predicted
};
const char* ToString(FrameStatus status);

enum class ClusterStatus {
  kTracked,    // at least three of its landmarks are seen in the frame
  kPredicted,  // fewer: the pose is predicted by the motion model
};
const char* ToString(ClusterStatus status);

// Upright box around a body as a person would draw it (METHOD.md 10.4), in the object frame. The
// box frame has its origin at the centre of the box, x forward and y down.
struct BodyBox {
  RigidTransform object_from_box;
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();  // length, height, width: along x, y, z
};

// Report on a cluster, a moving or movable rigid body, in one frame. The object frame is arbitrary
// (METHOD.md 6.1) but the same in all frames.
struct ClusterReport {
  ClusterId id;
  std::string category;  // class of its detections
  ClusterStatus status = ClusterStatus::kTracked;
  RigidTransform world_from_object;
  Eigen::Vector3d velocity_m_s = Eigen::Vector3d::Zero();  // of its origin, in the world frame
  // Extent used by the estimator: centre and half sides of the range between the 30 and 70 %
  // quantiles of its landmarks, along the axes of the object frame.
  Eigen::Vector3d center_in_object = Eigen::Vector3d::Zero();
  Eigen::Vector3d half_size_m = Eigen::Vector3d::Zero();
  BodyBox box;
  int observed_landmarks = 0;
  int detection = -1;  // index of the associated detection; -1 if there is none
  double score = 0.0;  // for ranking, in (0, 1) (METHOD.md 10.1)
};

// Report on a landmark observed in the frame, static or not.
struct LandmarkReport {
  LandmarkId id;
  int feature = 0;     // index into StereoFrame::features
  ClusterId cluster;   // assigned cluster q^i; invalid if there is none
  ClusterId inferred;  // cluster inferred by the CRF in this frame; invalid for an outlier
  int confidence = 0;  // confidence w^i in the assignment
  Eigen::Vector3d p_in_world = Eigen::Vector3d::Zero();
};

// Current estimate of the stereo calibration: StereoCamera::right_field_px and the information on
// it in 1/px^2, for landmarks instead of disparities that err independently (METHOD.md 7.6); zero
// if it was not estimated.
struct CalibrationReport {
  Vector6d right_field_px = Vector6d::Zero();
  Matrix6d information = Matrix6d::Zero();

  bool IsEstimated() const { return !information.isZero(0.0); }
  Matrix6d Covariance_px2() const;
};

// Report of the estimator on one frame.
struct FrameReport {
  FrameStatus status = FrameStatus::kFirst;
  RigidTransform world_from_camera;  // world = left camera of the first frame
  int features = 0;                  // stereo features in the frame
  int matches = 0;                   // landmarks matched in the frame
  int inliers = 0;                   // matches that are consistent with the camera pose
  int new_landmarks = 0;
  int window_frames = 0;          // frames of the spatial and temporal track, including this one
  std::vector<int> spatial_ages;  // age of each frame of the spatial track, in frames; oldest first
  int window_landmarks = 0;       // landmarks optimised in the window
  int window_iterations = 0;      // of the bundle adjustment
  SolverEndings window_endings;   // of the bundle adjustment
  SolverEndings cluster_endings;  // of the windows of the clusters, one per solve
  CalibrationReport calibration;
  // RMS whitened reprojection error, dimensionless, of the inlier observations in the window after
  // bundle adjustment.
  double mean_error_px = 0.0;
  std::vector<ClusterReport> clusters;    // live clusters, sorted by id
  std::vector<LandmarkReport> landmarks;  // observed in the frame, static ones included, by feature
  CrfScene crf;  // a node per landmark, in their order; empty if there is nothing to label
};

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
  // was confirmed and earlier frames to which it was traced back (METHOD.md 6.5).
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

  // Returns every cluster that was ever reported, including past ones, sorted by id.
  virtual std::vector<ClusterTrajectory> ClusterTrajectories() const = 0;
};

}  // namespace cvo
