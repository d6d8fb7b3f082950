// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/bodies/body_boxes.h"

#include <algorithm>

#include "core/bodies/body_direction.h"
#include "core/bodies/body_footprint.h"
#include "core/bodies/body_score.h"

namespace cvo {

// What is known of a body's box at the time of one state of its cluster, in world.
struct BodyTrack {
  FrameId frame;
  RigidTransform world_from_object;                    // at `frame`, which may have left the window
  Eigen::Vector3d forward = Eigen::Vector3d::UnitZ();  // level
  BoxShape shape;
  CenterEstimate center;  // in the object frame, averaged over the views
  Eigen::Vector3d landmark_center = Eigen::Vector3d::Zero();
  ViewedSides viewed;
};

namespace {

// Returns the cluster's landmarks in world, at the time of its latest state; its origin if it has
// no landmarks.
Eigen::Matrix3Xd PointsOf(const Cluster& cluster) {
  const RigidTransform& world_from_object = cluster.Latest().world_from_object;
  if (cluster.landmarks.empty()) return world_from_object.translation();
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(cluster.landmarks.size()));
  for (std::size_t i = 0; i < cluster.landmarks.size(); ++i) {
    points.col(static_cast<Eigen::Index>(i)) = world_from_object * cluster.landmarks[i].p_in_object;
  }
  return points;
}

// Advances the track to the cluster's latest state.
void Follow(const BoxScene& scene, const Cluster& cluster, BodyTrack& track) {
  const ClusterState& latest = cluster.Latest();
  if (!track.frame.valid()) {
    track.forward =
        Levelled(scene.world_from_camera.rotation() * Eigen::Vector3d::UnitZ(), scene.down);
  } else {
    const ClusterState* before = FindState(cluster, track.frame);
    const RigidTransform& then = before ? before->world_from_object : track.world_from_object;
    track.forward = TurnedBy(latest.world_from_object * then.Inverse(), scene.down, track.forward);
  }
  track.frame = latest.frame;
  track.world_from_object = latest.world_from_object;
}

void TurnToMotion(const BoxScene& scene, const Cluster& cluster, BodyTrack& track) {
  const Eigen::Vector3d at = cluster.Latest().world_from_object * cluster.center_in_object;
  const double least_m = scene.options.boxes.heading_deviations *
                         DepthDeviation(scene.view->camera, scene.options.place.disparity_px,
                                        scene.world_from_camera.Inverse() * at);
  const auto direction = DirectionOfMotion(cluster, cluster.center_in_object, scene.down, least_m);
  if (direction) track.forward = *direction;
}

// Sets axes and sides. `known_m` is 0 for sides that are estimated from landmarks and images.
void ShapeBox(const BoxScene& scene, const Cluster& cluster, const Eigen::Vector3d& known_m,
              BodyTrack& track) {
  const BodyBoxOptions& options = scene.options.boxes;
  const Eigen::Matrix3Xd points = PointsOf(cluster);
  const bool is_known = known_m.minCoeff() > 0.0;
  track.shape.axes = is_known ? BoxAxes(track.forward, scene.down)
                              : FootprintAxes(points, track.forward, scene.down, options);
  const LandmarkSides sides = SidesAlong(track.shape.axes, points, options, scene.options.extent);
  track.shape.is_round = IsRound(cluster.category);
  const Eigen::Vector3d size_m = track.shape.is_round
                                     ? SidesOfBall(sides.size_m, track.viewed)
                                     : WithPictures(sides.size_m, track.viewed, options);
  track.shape.size_m = (known_m.array() > 0.0).select(known_m, size_m);
  const Eigen::Vector3d camera = scene.world_from_camera.translation();
  track.landmark_center = CenterBehindNearSides(sides, track.shape, camera);
}

// Updates the body's place, and for later frames its sides, from its view in this frame.
void LookAt(const BoxScene& scene, const Cluster& cluster, bool is_known, BodyTrack& track) {
  const BoxSceneOptions& options = scene.options;
  const std::optional<BoxPlace> place =
      is_known ? PlaceBySurface(*scene.view, options.place, scene.newest, cluster, track.shape)
               : PlaceByPicture(*scene.view, options.place, scene.newest, cluster, track.shape,
                                track.landmark_center);
  if (!place) return;
  const double kept = 1.0 - 1.0 / options.boxes.max_views;
  track.center.information *= kept;
  track.center.weighted *= kept;
  track.center.Add(cluster.Latest().world_from_object.Inverse(), place->center_in_world,
                   place->information);
  if (!is_known) {
    AddPicture(*scene.view, options.place.box_center.border_px, cluster.detection, track.shape,
               place->center_in_world, track.viewed);
  }
}

// Returns the box at the reported pose of the body, which is predicted if the body was not found.
BodyBox BoxAt(const BoxScene& scene, const Cluster& cluster, const BodyTrack& track,
              const RigidTransform& world_from_object) {
  const RigidTransform& latest = cluster.Latest().world_from_object;
  const RigidTransform motion = world_from_object * latest.Inverse();
  const Eigen::Vector3d center =
      track.center.boxes > 0 ? latest * track.center.InObject() : track.landmark_center;
  const Eigen::Matrix3d axes =
      BoxAxes(TurnedBy(motion, scene.down, track.shape.axes.col(0)), scene.down);
  return {world_from_object.Inverse() * RigidTransform(axes, motion * center), track.shape.size_m};
}

}  // namespace

void BodyBoxes::Describe(const BoxScene& scene, std::vector<ClusterReport>& reports) {
  for (std::size_t q = 0; q < scene.clusters.live.size(); ++q) {
    const Cluster& cluster = scene.clusters.live[q];
    std::shared_ptr<BodyTrack>& kept = tracks_[cluster.id];
    if (!kept) kept = std::make_shared<BodyTrack>();
    BodyTrack& track = *kept;
    const Eigen::Vector3d known_m = scene.options.boxes.SizeOf(cluster.category);
    Follow(scene, cluster, track);
    const bool is_seen = scene.view != nullptr && cluster.Latest().frame == scene.newest;
    if (is_seen) {
      TurnToMotion(scene, cluster, track);
      ShapeBox(scene, cluster, known_m, track);
      LookAt(scene, cluster, known_m.minCoeff() > 0.0, track);
    }
    reports[q].box = BoxAt(scene, cluster, track, reports[q].world_from_object);
    reports[q].score =
        ScoreOf(scene.options.noise, scene.options.clusters, scene.view, scene.newest, cluster);
  }
  ForgetGone(scene.clusters);
}

void BodyBoxes::ForgetGone(const ClusterMap& clusters) {
  if (tracks_.size() <= 2 * (clusters.live.size() + clusters.archived.size())) return;
  std::erase_if(tracks_,
                [&](const auto& track) { return FindCluster(clusters, track.first) == nullptr; });
}

}  // namespace cvo
