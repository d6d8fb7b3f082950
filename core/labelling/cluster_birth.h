// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>

#include "core/bodies/box_center.h"
#include "core/labelling/cluster_labels.h"

namespace cvo {

// Where the frame of a new cluster begins: `centroid` of its points, or what its box says.
template <typename Policy>
concept BirthOriginPolicy = requires(const Eigen::Vector3d& point) {
  { Policy::Origin(point, point) } -> std::same_as<Eigen::Vector3d>;
};

// Policy: on the ray through the middle of the box, behind the surface (METHOD.md 6.1,
// clusters.birth_depth).
struct OriginBehindBox {
  static Eigen::Vector3d Origin(const Eigen::Vector3d&, const Eigen::Vector3d& box_center) {
    return box_center;
  }
};
// Policy: at the centroid of the points, on the visible surface, the paper's.
struct OriginAtCentroid {
  static Eigen::Vector3d Origin(const Eigen::Vector3d& centroid, const Eigen::Vector3d&) {
    return centroid;
  }
};

using BirthOriginFunction = Eigen::Vector3d (*)(const Eigen::Vector3d& centroid,
                                                const Eigen::Vector3d& box_center);

// Makes the clusters that the frame's labels found, without landmarks yet: at rest, axes from the
// principal axes of their points.
void CreateClusters(const FrameView& view, const BodyCenterOptions& options, FrameId newest,
                    const std::vector<FramePoint>& points, const FrameLabels& labels,
                    BirthOriginFunction origin, ClusterMap& map);

}  // namespace cvo
