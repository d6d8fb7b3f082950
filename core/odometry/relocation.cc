// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/odometry/relocation.h"

#include <cmath>
#include <limits>

#include "core/clustering/point_extent.h"

namespace cvo {
namespace {

// Standard deviation of a fix, in sizes of the body: a surface half in shadow or half hidden.
constexpr double kFixDeviation = 0.2;
// A prediction that is less certain than this, in sizes of the body, could as well be its
// neighbour.
constexpr double kMaxPredictionDeviation = 0.5;

}  // namespace

BoxFix FixFromSurface(const FrameView& view, const Detection& detection,
                      const Eigen::Vector3d& surface_in_world) {
  const Eigen::Vector3d ray = surface_in_world - view.world_from_camera.translation();
  const double range_m = ray.norm();
  const double size_m = range_m * std::min(detection.box.Width() / view.camera.fx,
                                           detection.box.Height() / view.camera.fy);
  return {surface_in_world + view.options.clusters.birth_depth * size_m * ray / range_m, size_m};
}

std::optional<BoxFix> FixInBox(const FrameView& view, const Detection& detection,
                               const std::vector<ClusterTrack>& tracks) {
  std::vector<char> taken(view.frame.features.size(), 0);
  for (const ClusterTrack& track : tracks) {
    for (const Match& match : track.matches) taken[match.feature] = 1;
  }
  const ImageBox inner = detection.box.Shrunk(view.options.unary.box_shrink);
  std::vector<Eigen::Vector3d> inside;
  std::vector<double> depths;
  for (std::size_t i = 0; i < view.frame.features.size(); ++i) {
    const Eigen::Vector3d& z = view.frame.features[i].z_px;
    if (taken[i] || !inner.Contains(z[0], z[1])) continue;
    const auto p = view.camera.BackProject(z);
    if (!p) continue;
    inside.push_back(*p);
    depths.push_back(p->z());
  }
  const double angular_size =
      std::max(detection.box.Width(), detection.box.Height()) / view.camera.fx;
  const std::vector<int> mode = NearestMode(depths, angular_size, view.options.extent);
  if (mode.empty()) return std::nullopt;
  Eigen::Matrix3Xd front(3, static_cast<Eigen::Index>(mode.size()));
  for (std::size_t k = 0; k < mode.size(); ++k) {
    front.col(static_cast<Eigen::Index>(k)) = view.world_from_camera * inside[mode[k]];
  }
  return FixFromSurface(view, detection, PrincipalAxes(front, view.options.extent).translation());
}

double RelocationDistance(const BoxFix& fix, const PredictedCluster& predicted) {
  const double predicted_m = std::sqrt(predicted.translation_variance_m2);
  if (predicted_m > kMaxPredictionDeviation * fix.size_m) {
    return std::numeric_limits<double>::infinity();
  }
  const double deviation = std::hypot(predicted_m, kFixDeviation * fix.size_m);
  return (fix.center_in_world - predicted.world_from_object.translation()).norm() / deviation;
}

void Relocate(const BoxFix& fix, int detection, ClusterTrack& track) {
  const double predicted = track.predicted.translation_variance_m2;
  const double fixed = kFixDeviation * fix.size_m;
  const double gain = predicted / (predicted + fixed * fixed);
  const Eigen::Vector3d origin = track.predicted.world_from_object.translation();
  track.world_from_object =
      RigidTransform(track.predicted.world_from_object.RotationMatrix(),
                     Eigen::Vector3d(origin + gain * (fix.center_in_world - origin)));
  track.is_tracked = true;
  track.matches.clear();
  track.detection = detection;
}

}  // namespace cvo
