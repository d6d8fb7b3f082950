// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/labelling/frame_points.h"

#include <algorithm>

namespace cvo {

namespace {

template <typename Boxes, typename BoxOf>
bool AnyContains(const Boxes& boxes, const StereoFeature& feature, BoxOf box_of) {
  return std::any_of(boxes.begin(), boxes.end(), [&](const auto& it) {
    return box_of(it).Contains(feature.z_px[0], feature.z_px[1]);
  });
}

bool IsDetected(std::span<const Detection> detections, const StereoFeature& feature) {
  return AnyContains(detections, feature, [](const Detection& d) { return d.box; });
}

bool IsExpected(const std::vector<ClusterTrack>& tracks, const StereoFeature& feature) {
  return AnyContains(tracks, feature, [](const ClusterTrack& track) { return track.box; });
}

}  // namespace

std::vector<int> SceneFeatures(const std::vector<StereoFeature>& features,
                               std::span<const Detection> detections) {
  std::vector<int> indices;
  for (int i = 0; i < static_cast<int>(features.size()); ++i) {
    if (IsLeftOnly(features[i])) continue;
    if (!features[i].is_reserve || IsDetected(detections, features[i])) indices.push_back(i);
  }
  return indices;
}

std::vector<FramePoint> CollectPoints(const FrameView& view, double min_disparity_px,
                                      const std::vector<Match>& static_matches,
                                      const std::vector<ClusterTrack>& tracks) {
  std::vector<FramePoint> by_feature(view.frame.features.size());
  for (const Match& match : static_matches) {
    by_feature[match.feature].owner = kSceneOwner;
    by_feature[match.feature].landmark = match.landmark;
  }
  for (int q = 0; q < static_cast<int>(tracks.size()); ++q) {
    for (const Match& match : tracks[q].matches) {
      by_feature[match.feature].owner = ClusterOwner(q);
      by_feature[match.feature].landmark = match.landmark;
    }
  }
  std::vector<FramePoint> points;
  for (int i = 0; i < static_cast<int>(by_feature.size()); ++i) {
    FramePoint point = by_feature[i];
    point.feature = i;
    const StereoFeature& feature = view.frame.features[i];
    const bool is_new = point.owner == kNoOwner;
    const bool is_far = view.camera.Disparity(feature.z_px) < min_disparity_px;
    if (is_new && (is_far || IsLeftOnly(feature))) continue;
    const bool is_wanted = !feature.is_reserve || IsDetected(view.shown.detections, feature) ||
                           IsExpected(tracks, feature);
    if (is_new && !is_wanted) continue;
    points.push_back(point);
  }
  return points;
}

const Landmark* FindLandmark(const FramePoint& point, const Window& window, const ClusterMap& map) {
  if (point.owner == kNoOwner) return nullptr;
  if (point.owner == kSceneOwner) return &window.landmarks[point.landmark];
  return &map.live[point.owner.cluster].landmarks[point.landmark];
}

std::optional<RigidTransform> OwnerPose(PointOwner owner, FrameId frame, const ClusterMap& map) {
  if (owner == kSceneOwner) return RigidTransform();
  const ClusterState* state = FindState(map.live[owner.cluster], frame);
  if (!state) return std::nullopt;
  return state->world_from_object;
}

}  // namespace cvo
