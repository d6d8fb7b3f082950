// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/odometry/camera_tracking.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/association/matching.h"
#include "core/clusters/cluster_optimization.h"
#include "core/clusters/trace_back.h"
#include "core/estimation/camera_solver.h"

namespace cvo {

void MotionModel::Update(std::int64_t timestamp_ns, const RigidTransform& world_from_camera) {
  if (updates_++ > 0) {
    const double interval_s = 1e-9 * static_cast<double>(timestamp_ns - timestamp_ns_);
    const RigidTransform motion = world_from_camera_.Inverse() * world_from_camera;
    velocity_ << LogSo3(Eigen::Quaterniond(motion.rotation())), motion.translation();
    velocity_ /= interval_s;
  }
  timestamp_ns_ = timestamp_ns;
  world_from_camera_ = world_from_camera;
}

RigidTransform MotionModel::Predict(std::int64_t timestamp_ns) const {
  const double elapsed_s = 1e-9 * static_cast<double>(timestamp_ns - timestamp_ns_);
  const Vector6d motion = elapsed_s * velocity_;
  return world_from_camera_ *
         RigidTransform(ExpSo3(motion.head<3>()), Eigen::Vector3d(motion.tail<3>()));
}

namespace {

// Search radius with the solved camera pose, at level 0: 4 standard deviations of a corner
// (METHOD.md 3.2).
constexpr double kNarrowRadius_px = 4.0;

struct Visible {
  std::vector<ProjectedLandmark> projected;
  std::vector<int> landmark;  // index into window.landmarks, per projected landmark
};

Visible ProjectLandmarks(const OrbOptions& options, const Window& window,
                         const RigidTransform& world_from_camera) {
  const RigidTransform camera_from_world = world_from_camera.Inverse();
  const double log_scale = std::log(options.scale_factor);
  Visible visible;
  for (int i = 0; i < static_cast<int>(window.landmarks.size()); ++i) {
    const Landmark& landmark = window.landmarks[i];
    const Eigen::Vector3d p_in_camera = camera_from_world * landmark.p_in_object;
    const auto zeta = window.camera.Project(p_in_camera);
    if (!zeta || !window.camera.InImage((*zeta)[0], (*zeta)[1])) continue;
    const int octave =
        landmark.last_octave +
        static_cast<int>(std::lround(std::log(landmark.depth_m / p_in_camera.z()) / log_scale));
    visible.projected.push_back(
        {*zeta, std::clamp(octave, 0, options.levels - 1), landmark.descriptor});
    visible.landmark.push_back(i);
  }
  return visible;
}

// Projects the landmarks with this camera pose and matches them with features nearby. Landmark
// indices of the matches are into window.landmarks.
std::vector<Match> SearchAround(const Options& options, const Window& window,
                                const FeatureGrid& grid, const RigidTransform& world_from_camera,
                                double radius_px) {
  const Visible visible = ProjectLandmarks(options.orb, window, world_from_camera);
  std::vector<Match> matches = MatchProjected(visible.projected, grid, radius_px,
                                              options.orb.scale_factor, options.matching);
  for (Match& match : matches) match.landmark = visible.landmark[match.landmark];
  return matches;
}

// If more than half of the matches are outliers, the search was in the wrong place.
bool IsInDoubt(const Options& options, const std::vector<Match>& matches,
               const CameraSolution& solution, const ExpectedCamera& expected) {
  return !expected.has_motion || solution.inliers < options.tracking.min_inliers ||
         solution.inliers < static_cast<int>(matches.size()) / 2;
}

// Refines each candidate pose, and returns the one whose inliers cover most of space, weighted by
// the share of inliers among the landmarks matched there.
RigidTransform BestCovering(const Options& options, const Window& window, const FeatureGrid& grid,
                            std::span<const RigidTransform> candidates) {
  RigidTransform best = candidates.front();
  double most = 0.0;
  for (const RigidTransform& candidate : candidates) {
    const std::vector<PointMeasurement> measurements =
        MeasurementsOf(options.NoiseOfFeatures(), window.landmarks, grid.features(),
                       SearchAround(options, window, grid, candidate, kNarrowRadius_px));
    const CameraSolution solution =
        RefineCamera(window.camera, measurements, candidate, options.noise);
    const double share = solution.inliers / std::max(1.0, static_cast<double>(measurements.size()));
    const double covered =
        share * CountCubes(CubesOf(window.camera, measurements), solution.is_inlier);
    if (covered <= most) continue;
    most = covered;
    best = solution.world_from_camera;
  }
  return best;
}

std::optional<RigidTransform> FindWithoutPrediction(const Options& options, const Window& window,
                                                    const FeatureGrid& grid, Rng& rng) {
  std::vector<Descriptor> descriptors;
  std::vector<int> landmark;
  const FrameId newest = window.temporal.back().id;
  for (int i = 0; i < static_cast<int>(window.landmarks.size()); ++i) {
    if (window.landmarks[i].last_seen.value <= newest.value - options.tracking.kRecoveryFrames)
      continue;
    descriptors.push_back(window.landmarks[i].descriptor);
    landmark.push_back(i);
  }
  std::vector<Match> matches = MatchDescriptors(
      descriptors, grid.features(), [](int) { return true; }, options.tracking.kRecoveryHamming,
      options.tracking.kRecoveryRatio);
  for (Match& match : matches) match.landmark = landmark[match.landmark];
  const std::vector<PointMeasurement> measurements =
      MeasurementsOf(options.NoiseOfFeatures(), window.landmarks, grid.features(), matches);
  const auto solution = SolveCameraRansac(
      window.camera, measurements, options.noise, CubesOf(window.camera, measurements),
      options.tracking.kRecoveryIterations, options.tracking.min_inliers, rng);
  if (!solution) return std::nullopt;
  return solution->world_from_camera;
}

std::vector<Match> Inliers(const std::vector<Match>& matches, const CameraSolution& solution) {
  std::vector<Match> inliers;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (solution.is_inlier[i]) inliers.push_back(matches[i]);
  }
  return inliers;
}

// For a given camera pose: matches the landmarks that agree with it.
CameraTrack MatchAround(const Options& options, const Window& window, const FeatureGrid& grid,
                        const RigidTransform& world_from_camera) {
  const std::vector<Match> matches =
      SearchAround(options, window, grid, world_from_camera, kNarrowRadius_px);
  const CameraSolution agreeing = ClassifyMeasurements(
      window.camera,
      MeasurementsOf(options.NoiseOfFeatures(), window.landmarks, grid.features(), matches),
      world_from_camera, options.noise.gate);
  return {world_from_camera, Inliers(matches, agreeing), static_cast<int>(matches.size())};
}

}  // namespace

std::optional<CameraTrack> TrackCamera(const Options& options, const Window& window,
                                       const FeatureGrid& grid, std::span<StereoFeature> features,
                                       const ExpectedCamera& expected, Rng& rng) {
  if (expected.is_given) return MatchAround(options, window, grid, expected.world_from_camera);
  const auto measure = [&](const std::vector<Match>& matches) {
    return MeasurementsOf(options.NoiseOfFeatures(), window.landmarks, grid.features(), matches);
  };
  const std::vector<Match> wide = SearchAround(options, window, grid, expected.world_from_camera,
                                               options.matching.wide_radius_px);
  const CameraSolution first =
      SolveCamera(window.camera, measure(wide), expected.world_from_camera, options.noise);
  std::vector<RigidTransform> candidates = {first.world_from_camera, expected.world_from_camera};
  if (IsInDoubt(options, wide, first, expected)) {
    const auto found = FindWithoutPrediction(options, window, grid, rng);
    if (found) candidates.push_back(*found);
  }
  const RigidTransform around = BestCovering(options, window, grid, candidates);
  const std::vector<Match> narrow = SearchAround(options, window, grid, around, kNarrowRadius_px);
  if (options.tracking.align_patches) {
    AlignToLandmarks(options.orb.scale_factor, around.Inverse(), window.landmarks, narrow,
                     features);
  }
  const CameraSolution second = RefineCamera(window.camera, measure(narrow), around, options.noise);
  if (second.inliers < options.tracking.min_inliers) return std::nullopt;
  return CameraTrack{second.world_from_camera, Inliers(narrow, second),
                     static_cast<int>(narrow.size())};
}

}  // namespace cvo
