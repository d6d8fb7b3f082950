// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/cluster_pose.h"

#include "core/clusters/landmark_alignment.h"
#include "core/clusters/left_only.h"
#include "core/clusters/point_measurements.h"
#include "core/estimation/camera_ransac.h"

namespace cvo {

bool IsAllowed(const FrameView& view, const Cluster& cluster, int feature) {
  const std::span<const BodyId> given = view.shown.feature_body;
  return given.empty() || !given[feature].valid() || given[feature] == cluster.given_body;
}

std::optional<CameraSolution> SolvePose(const ClusterSearch& search, const Cluster& cluster,
                                        const RigidTransform& world_from_object,
                                        const std::vector<Match>& matches, int min_inliers,
                                        bool is_predicted, Rng& rng) {
  if (static_cast<int>(matches.size()) < min_inliers) return std::nullopt;
  const std::vector<PointMeasurement> measurements =
      MeasurementsOf(search.options.noise, cluster.landmarks, search.frame.features, matches);
  if (is_predicted) {
    const RigidTransform object_from_camera =
        world_from_object.Inverse() * search.world_from_camera;
    CameraSolution solution =
        SolveCamera(search.camera, measurements, object_from_camera, search.options.noise.options);
    if (solution.inliers >= min_inliers && 2 * solution.inliers >= static_cast<int>(matches.size()))
      return solution;
  }
  return SolveCameraRansac(search.camera, measurements, search.options.noise.options, CountInliers,
                           search.options.association.ransac_iterations, min_inliers, rng);
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

void PlaceFeatures(const ClusterSearch& search, const Cluster& cluster, const ClusterTrack& track,
                   std::span<StereoFeature> features) {
  const RigidTransform camera_from_object =
      search.world_from_camera.Inverse() * track.world_from_object;
  if (search.options.align_patches) {
    AlignToLandmarks(search.options.orb.scale_factor, camera_from_object, cluster.landmarks,
                     track.matches, features);
  }
  PlaceLeftOnly(search.camera, camera_from_object, cluster.landmarks, track.matches, features);
}

}  // namespace cvo
