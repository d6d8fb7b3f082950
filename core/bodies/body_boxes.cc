// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/bodies/body_boxes.h"

#include <algorithm>

#include "core/bodies/body_direction.h"
#include "core/bodies/body_footprint.h"
#include "core/bodies/body_score.h"

namespace cvo {

// What is known of a body's box, in world, at the time of a state of its cluster.
struct BodyTrack {
  FrameId frame;
  RigidTransform world_from_object;                    // then; the window may no longer hold it
  Eigen::Vector3d forward = Eigen::Vector3d::UnitZ();  // level
  BoxShape shape;
  CenterEstimate center;  // in the body's frame, by the views so far
  Eigen::Vector3d landmark_center = Eigen::Vector3d::Zero();
  ViewedSides viewed;  // as far as pictures told
};

namespace {

// In world, at the time of the cluster's latest state; the origin of a cluster that has none.
Eigen::Matrix3Xd PointsOf(const Cluster& cluster) {
  const RigidTransform& world_from_object = cluster.Latest().world_from_object;
  if (cluster.landmarks.empty()) return world_from_object.translation();
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(cluster.landmarks.size()));
  for (std::size_t i = 0; i < cluster.landmarks.size(); ++i) {
    points.col(static_cast<Eigen::Index>(i)) = world_from_object * cluster.landmarks[i].p_in_object;
  }
  return points;
}

// Takes the track from the state it is of to the latest one.
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

// Axes and sides; `known_m` is 0 where the landmarks and the pictures have to tell.
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

// What the frame's picture of the body tells of its place, and of its sides for later frames.
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

// Where the body is reported to be, which is where it is predicted if it was not found.
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
