// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/association/image_box.h"
#include "core/base/ids.h"
#include "core/features/stereo_feature.h"
#include "core/geometry/rigid_transform.h"
#include "core/solvers/window_solver.h"

namespace cvo {

// A body that a detector found in the left image (B_t^m of the paper).
struct Detection {
  ImageBox box;
  std::string category;  // "Car", "chair": what an object of it is reported as
  double score = 1.0;
};

// What is known of a frame from elsewhere and taken as it is in place of an estimate: a camera from
// another odometry, instance segmentation, a tracker of boxes. All of it is optional. A body has
// the same id in all frames.
struct GivenKnowledge {
  std::optional<RigidTransform> world_from_camera;  // world = left camera of the first frame
  std::vector<BodyId> feature_body;                 // by feature; empty: nothing is given
  std::vector<BodyId> detection_body;               // by detection; empty: nothing is given
};

// What the front end makes of one stereo pair; what the estimator is given.
struct StereoFrame {
  std::int64_t timestamp_ns = 0;  // strictly increasing from frame to frame
  std::vector<StereoFeature> features;
  std::vector<Detection> detections;
  GivenKnowledge given;
};

// What the estimator is shown of a frame's bodies: views into the frame, which must outlive them.
struct ShownBodies {
  std::span<const Detection> detections;
  std::span<const BodyId> feature_body;    // as GivenKnowledge
  std::span<const BodyId> detection_body;  // as GivenKnowledge
};

// Throws Error where what is given of features or detections is not as long as they are.
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
  kTracked,    // at least clusters.min_observed of its landmarks are seen in the frame
  kPredicted,  // fewer: the pose is predicted by the motion model
};
const char* ToString(ClusterStatus status);

// The box that a person would draw around a body (METHOD.md 10.4), in the body's frame: upright, x
// forward, y down. Its centre and sides.
struct BodyBox {
  RigidTransform object_from_box;
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();  // length, height, width: along x, y, z
};

// A moving or movable rigid body in one frame. Its frame is arbitrary (METHOD.md 6.1) and the
// same at all times.
struct ClusterReport {
  ClusterId id;
  std::string category;  // of the detections it was found in
  ClusterStatus status = ClusterStatus::kTracked;
  RigidTransform world_from_object;
  Eigen::Vector3d velocity_m_s = Eigen::Vector3d::Zero();  // of its origin, in world
  // What the estimator uses of its extent: the inner 30 to 70 percentiles of its landmarks along
  // the axes of its frame, centre and half sides.
  Eigen::Vector3d center_in_object = Eigen::Vector3d::Zero();
  Eigen::Vector3d half_size_m = Eigen::Vector3d::Zero();
  BodyBox box;
  int observed_landmarks = 0;
  int detection = -1;  // index of the detection it was associated with; -1: none
  double score = 0.0;  // to rank estimates, in (0, 1): METHOD.md 10.1
};

// A landmark seen in the frame, static or not.
struct LandmarkReport {
  LandmarkId id;
  int feature = 0;     // index into StereoFrame::features
  ClusterId cluster;   // assigned, q^i; invalid: none
  ClusterId inferred;  // by the CRF in this frame; invalid: outlier
  int confidence = 0;  // w^i
  Eigen::Vector3d p_in_world = Eigen::Vector3d::Zero();
  // Unary energies of the inferred label, nats: 2D box, 3D affinity, motion.
  double energy_2d = 0.0;
  double energy_3d = 0.0;
  double energy_motion = 0.0;
  // The best of the other labels by these energies; invalid: outlier.
  ClusterId second;
  double second_2d = 0.0;
  double second_3d = 0.0;
  double second_motion = 0.0;
};

// The rig as estimated so far: StereoCamera::right_field_px and what is known of it, 1/px^2; no
// information: it was not estimated.
struct CalibrationReport {
  Vector6d right_field_px = Vector6d::Zero();
  Matrix6d information = Matrix6d::Zero();

  bool IsEstimated() const { return !information.isZero(0.0); }
  Matrix6d Covariance_px2() const { return information.inverse(); }
};

// What the estimator says of one frame.
struct FrameReport {
  FrameStatus status = FrameStatus::kFirst;
  RigidTransform world_from_camera;  // world = left camera of the first frame
  int features = 0;                  // stereo features in the frame
  int matches = 0;                   // landmarks found in the frame
  int inliers = 0;                   // of these, consistent with the camera pose
  int new_landmarks = 0;
  int window_frames = 0;          // spatial and temporal track together, this frame included
  std::vector<int> spatial_ages;  // of the spatial track, in frames before this one; oldest first
  int window_landmarks = 0;       // optimised with the window
  int window_iterations = 0;      // of the bundle adjustment
  SolverEndings window_endings;   // of the bundle adjustment
  SolverEndings cluster_endings;  // of the clusters' windows, one per solve
  CalibrationReport calibration;
  double mean_error_px = 0.0;             // RMS whitened reprojection error of the inliers after it
  std::vector<ClusterReport> clusters;    // live ones, by id
  std::vector<LandmarkReport> landmarks;  // seen in the frame, static ones included, by feature
};

}  // namespace cvo
