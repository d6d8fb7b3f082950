// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/labelling/cluster_birth.h"

#include <algorithm>

#include "core/clustering/point_extent.h"

namespace cvo {
namespace {

// Category of a body that is known from given labels alone, without a detection.
constexpr const char* kUnknownCategory = "object";

Eigen::Matrix3Xd PointsOf(ClusterId id, const FrameView& view,
                          const std::vector<FramePoint>& points, const FrameLabels& labels) {
  std::vector<Eigen::Vector3d> members;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (labels.points[i].assigned.cluster != id) continue;
    const auto p_in_camera = view.camera.BackProject(view.frame.features[points[i].feature].z_px);
    if (p_in_camera) members.push_back(view.world_from_camera * *p_in_camera);
  }
  Eigen::Matrix3Xd columns(3, static_cast<Eigen::Index>(members.size()));
  for (std::size_t k = 0; k < members.size(); ++k) {
    columns.col(static_cast<Eigen::Index>(k)) = members[k];
  }
  return columns;
}

Cluster CreateCluster(const FrameView& view, const BodyCenterOptions& options, FrameId newest,
                      const FrameLabels::Birth& birth, const Eigen::Matrix3Xd& members,
                      BirthOriginFunction birth_origin) {
  Cluster cluster;
  cluster.id = birth.id;
  cluster.given_body = birth.given_body;
  cluster.category = kUnknownCategory;
  const RigidTransform axes = PrincipalAxes(members, options.extent);
  Eigen::Vector3d origin = axes.translation();
  cluster.last_observed = newest;
  if (birth.detection >= 0) {
    const Detection& detection = view.shown.detections[birth.detection];
    cluster.category = detection.category;
    cluster.detections = 1;
    cluster.score = detection.score;
    cluster.last_detected = newest;
    const BoxCenter box =
        CenterFromBox(view, options.box_center, options.birth_depth, birth.detection, origin);
    origin = birth_origin(axes.translation(), box.center_in_world);
    cluster.size.Add(box.size_m, box.is_whole);
  }
  cluster.states.push_back({newest, view.frame.timestamp_ns,
                            RigidTransform(axes.RotationMatrix(), origin),
                            Eigen::Vector3d::Zero()});
  return cluster;
}

}  // namespace

void CreateClusters(const FrameView& view, const BodyCenterOptions& options, FrameId newest,
                    const std::vector<FramePoint>& points, const FrameLabels& labels,
                    BirthOriginFunction origin, ClusterMap& map) {
  for (const FrameLabels::Birth& birth : labels.births) {
    map.live.push_back(CreateCluster(view, options, newest, birth,
                                     PointsOf(birth.id, view, points, labels), origin));
    map.next.value = birth.id.value + 1;
  }
}

}  // namespace cvo
