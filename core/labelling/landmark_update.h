// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>

#include "core/bodies/body_boxes.h"
#include "core/labelling/cluster_labels.h"

namespace cvo {

// Where the object frame of a new cluster has its origin, given the centre (median) of its points
// and the centre estimated from its box, both in world.
template <typename Policy>
concept BirthOriginPolicy = requires(const Eigen::Vector3d& point) {
  { Policy::Origin(point, point) } -> std::same_as<Eigen::Vector3d>;
};

// Policy: on the ray through the centre of the box, behind the visible surface (METHOD.md 6.1,
// clusters.birth_depth).
struct OriginBehindBox {
  static Eigen::Vector3d Origin(const Eigen::Vector3d&, const Eigen::Vector3d& box_center) {
    return box_center;
  }
};
// Policy: at the centre of the points, on the visible surface, as in the paper.
struct OriginAtCentroid {
  static Eigen::Vector3d Origin(const Eigen::Vector3d& centroid, const Eigen::Vector3d&) {
    return centroid;
  }
};

// Policies for which points in a new box are its body, and where that body's origin is.
struct BodiesByDepth : NearestDepths, OriginBehindBox {};   // ours
struct BodiesOfAllPoints : AllDepths, OriginAtCentroid {};  // the paper's

using BirthOriginFunction = Eigen::Vector3d (*)(const Eigen::Vector3d& centroid,
                                                const Eigen::Vector3d& box_center);

// Creates the clusters that are born from the frame's labels. They are at rest, their axes are the
// principal axes of their points, and they have no landmarks yet.
void CreateClusters(const FrameView& view, const BodyCenterOptions& options, FrameId newest,
                    const std::vector<FramePoint>& points, const FrameLabels& labels,
                    BirthOriginFunction origin, ClusterMap& map);

// Options of UpdateLandmarks.
struct LandmarkUpdateOptions {
  FeatureNoise noise;
  bool align_patches = true;  // tracking.align_patches
};

// Adds the observation and label of every landmark seen in the frame `entering`. A landmark whose
// label changes moves to its new body, together with the observations that agree with that body's
// motion; one that is assigned to no body is removed. Features without a landmark become landmarks,
// with ids from next_id on. A cluster without a pose in the frame receives no landmarks. Writes the
// ids of the landmarks to `labels` and returns the number of new landmarks.
int UpdateLandmarks(const FrameView& view, const LandmarkUpdateOptions& options,
                    const WindowFrame& entering, const std::vector<ClusterTrack>& tracks,
                    const std::vector<FramePoint>& points, FrameLabels& labels, LandmarkId& next_id,
                    Window& window, ClusterMap& map);

// Removes landmarks that have one observation, no past information, and were not seen in the latest
// `frames` frames.
void RemoveUnconfirmed(FrameId newest, int frames, std::vector<Landmark>& landmarks);

}  // namespace cvo
