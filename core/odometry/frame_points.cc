// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/odometry/frame_points.h"

namespace cvo {

std::vector<FramePoint> CollectPoints(const FrameView& view,
                                      const std::vector<Match>& static_matches,
                                      const std::vector<ClusterTrack>& tracks) {
  std::vector<FramePoint> by_feature(view.frame.features.size());
  for (const Match& match : static_matches) {
    by_feature[match.feature].body = FramePoint::kStaticBody;
    by_feature[match.feature].landmark = match.landmark;
  }
  for (int q = 0; q < static_cast<int>(tracks.size()); ++q) {
    for (const Match& match : tracks[q].matches) {
      by_feature[match.feature].body = q + 1;
      by_feature[match.feature].landmark = match.landmark;
    }
  }
  std::vector<FramePoint> points;
  for (int i = 0; i < static_cast<int>(by_feature.size()); ++i) {
    FramePoint point = by_feature[i];
    point.feature = i;
    const Eigen::Vector3d& z = view.frame.features[i].z_px;
    const bool is_new = point.body == FramePoint::kNoBody;
    if (is_new && view.camera.Disparity(z) < view.options.tracking.min_disparity_px) continue;
    points.push_back(point);
  }
  return points;
}

const Landmark* FindLandmark(const FramePoint& point, const Window& window, const ClusterMap& map) {
  if (point.body == FramePoint::kNoBody) return nullptr;
  if (point.body == FramePoint::kStaticBody) return &window.landmarks[point.landmark];
  return &map.live[point.body - 1].landmarks[point.landmark];
}

std::optional<RigidTransform> BodyPose(int body, FrameId frame, const ClusterMap& map) {
  if (body == FramePoint::kStaticBody) return RigidTransform();
  const ClusterState* state = FindState(map.live[body - 1], frame);
  if (!state) return std::nullopt;
  return state->world_from_object;
}

}  // namespace cvo
