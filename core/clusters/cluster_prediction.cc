// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/cluster_prediction.h"

#include <algorithm>
#include <cmath>

#include "core/clusters/cluster_association.h"
#include "core/clusters/cluster_optimization.h"
#include "core/clusters/trace_back.h"
#include "core/estimation/camera_solver.h"

namespace cvo {

bool IsAllowed(const FrameView& view, const Cluster& cluster, int feature) {
  const std::span<const BodyId> given = view.shown.feature_body;
  return given.empty() || !given[feature].valid() || given[feature] == cluster.given_body;
}

std::optional<CameraSolution> SolvePose(const FrameView& view, const Cluster& cluster,
                                        const RigidTransform& world_from_object,
                                        const std::vector<Match>& matches, int min_inliers,
                                        bool is_predicted, Rng& rng) {
  if (static_cast<int>(matches.size()) < min_inliers) return std::nullopt;
  const std::vector<PointMeasurement> measurements = MeasurementsOf(
      view.options.NoiseOfFeatures(), cluster.landmarks, view.frame.features, matches);
  if (is_predicted) {
    const RigidTransform object_from_camera = world_from_object.Inverse() * view.world_from_camera;
    CameraSolution solution =
        SolveCamera(view.camera, measurements, object_from_camera, view.options.noise);
    if (solution.inliers >= min_inliers && solution.HalfAgrees()) return solution;
  }
  return SolveCameraRansac(view.camera, measurements, view.options.noise, {}, kRansacIterations,
                           min_inliers, rng);
}

void AcceptPose(const FrameView& view, const std::vector<Match>& matches,
                const CameraSolution& solution, TakenFeatures& taken, ClusterTrack& track) {
  track.world_from_object = view.world_from_camera * solution.world_from_camera.Inverse();
  track.is_tracked = true;
  track.matches.clear();
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (!solution.is_inlier[i]) continue;
    track.matches.push_back(matches[i]);
    taken[matches[i].feature] = 1;
  }
}

void PlaceFeatures(const FrameView& view, const Cluster& cluster, const ClusterTrack& track,
                   std::span<StereoFeature> features) {
  const RigidTransform camera_from_object =
      view.world_from_camera.Inverse() * track.world_from_object;
  if (view.options.tracking.align_patches) {
    AlignToLandmarks(view.options.orb.scale_factor, camera_from_object, cluster.landmarks,
                     track.matches, features);
  }
  PlaceLeftOnly(view.camera, camera_from_object, cluster.landmarks, track.matches, features);
}

namespace {

// Standard deviation of a new cluster's velocity; falls with 1/n^2 (between walking and driving;
// the search radius is bounded anyway).
constexpr double kFirstSpeed_m_s = 5.0;
// Standard deviation of a tracked cluster's velocity (residuals of predictions on the indoor
// scenes).
constexpr double kSpeedDeviation_m_s = 0.2;
// Standard deviation of a new cluster's angular velocity; falls with 1/n^2 (a rolling ball).
constexpr double kFirstTurn_rad_s = 2.0;
// Standard deviation of a tracked cluster's angular velocity (residuals of predictions on the
// indoor scenes).
constexpr double kTurnDeviation_rad_s = 0.5;

// Standard deviation of a velocity: large for a new cluster, whose motion is unknown, and falling
// with the square of the number of frames.
double FallingDeviation(double first, double settled, int frames) {
  const double n = frames;
  return std::max(first / (n * n), settled);
}

// World covariance that the uncertain motion gives to a point of the predicted body at distance
// lever_m from its origin.
Eigen::Matrix3d RideCovariance(const PredictedCluster& predicted, double lever_m) {
  const double variance =
      predicted.translation_variance_m2 + lever_m * lever_m * predicted.rotation_variance_rad2;
  return variance * Eigen::Matrix3d::Identity();
}

}  // namespace

PredictedCluster PredictCluster(const Cluster& cluster, std::int64_t timestamp_ns,
                                Extrapolation& extrapolate, const MotionPriorOptions& motion) {
  const std::int64_t origin_ns = cluster.Latest().timestamp_ns;
  const double dt_s = SecondsBetween(origin_ns, timestamp_ns);
  std::vector<MotionState> states;
  for (const ClusterState& state : cluster.states) {
    states.push_back({SecondsBetween(origin_ns, state.timestamp_ns), state.world_from_object,
                      state.velocity_m_s});
  }
  const double speed = FallingDeviation(kFirstSpeed_m_s, kSpeedDeviation_m_s, cluster.frames);
  const double turn =
      dt_s * FallingDeviation(kFirstTurn_rad_s, kTurnDeviation_rad_s, cluster.frames);
  const PredictedMotion extrapolated = extrapolate(motion, states, dt_s);
  return {extrapolated.state.world_from_object, extrapolated.state.velocity_m_s,
          AddedVariance(extrapolated.power_density_m2_s3, speed, dt_s), turn * turn};
}

bool AgreesWithPrediction(const PredictedCluster& predicted,
                          const RigidTransform& world_from_object, double gate) {
  const RigidTransform off = predicted.world_from_object.Inverse() * world_from_object;
  const double angle_rad = RotationAngle(off.rotation());
  return off.translation().squaredNorm() <= gate * predicted.translation_variance_m2 &&
         angle_rad * angle_rad <= gate * predicted.rotation_variance_rad2;
}

std::optional<PredictedLandmark> PredictLandmark(const FrameView& view,
                                                 const PredictedCluster& predicted,
                                                 const Landmark& landmark) {
  const Eigen::Matrix3d R_camera_from_world = view.world_from_camera.RotationMatrix().transpose();
  const Eigen::Vector3d p_in_world = predicted.world_from_object * landmark.p_in_object;
  const Eigen::Vector3d c =
      R_camera_from_world * (p_in_world - view.world_from_camera.translation());
  const auto zeta = view.camera.Project(c);
  if (!zeta || !view.camera.InImage((*zeta)[0], (*zeta)[1])) return std::nullopt;

  const double log_scale = std::log(view.options.orb.scale_factor);
  const int octave =
      std::clamp(landmark.last_octave +
                     static_cast<int>(std::lround(std::log(landmark.depth_m / c.z()) / log_scale)),
                 0, view.options.orb.levels - 1);
  const Eigen::Matrix3d J = view.camera.ProjectionJacobian(c) * R_camera_from_world;
  const Eigen::Matrix3d JR = J * predicted.world_from_object.RotationMatrix();
  const double lever_m = landmark.p_in_object.norm();
  PredictedLandmark result;
  result.zeta_px = *zeta;
  result.position_px2 = JR * landmark.covariance.in_object_m2 * JR.transpose();
  result.measurement_px2 = view.options.NoiseOfFeatures().Covariance(octave);
  result.innovation_px2 = result.position_px2 +
                          J * RideCovariance(predicted, lever_m) * J.transpose() +
                          result.measurement_px2;
  result.octave = octave;
  result.descriptor = landmark.descriptor;
  return result;
}

}  // namespace cvo
