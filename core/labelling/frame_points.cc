// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/labelling/frame_points.h"

#include <algorithm>
#include <numeric>

namespace cvo {

namespace {

template <typename Boxes, typename BoxOf>
bool AnyContains(const Boxes& boxes, const StereoFeature& feature, BoxOf box_of) {
  return std::any_of(boxes.begin(), boxes.end(), [&](const auto& it) {
    return box_of(it).Contains(feature.z_px[0], feature.z_px[1]);
  });
}

bool IsExpected(const std::vector<ClusterTrack>& tracks, const StereoFeature& feature) {
  return AnyContains(tracks, feature, [](const ClusterTrack& track) { return track.box; });
}

}  // namespace

bool IsDetected(std::span<const Detection> detections, const StereoFeature& feature) {
  return AnyContains(detections, feature, [](const Detection& d) { return d.box; });
}

std::vector<int> SceneFeatures(const std::vector<StereoFeature>& features,
                               std::span<const Detection> detections) {
  std::vector<int> indices;
  for (int i = 0; i < static_cast<int>(features.size()); ++i) {
    if (IsLeftOnly(features[i])) continue;
    if (!features[i].is_reserve || IsDetected(detections, features[i])) indices.push_back(i);
  }
  return indices;
}

std::vector<FramePoint> CollectPoints(const FrameView& view,
                                      const std::vector<Match>& static_matches,
                                      const std::vector<ClusterTrack>& tracks) {
  std::vector<FramePoint> by_feature(view.frame.features.size());
  for (const Match& match : static_matches) {
    by_feature[match.feature].owner = kSceneOwner;
    by_feature[match.feature].landmark = match.landmark;
  }
  for (int q = 0; q < static_cast<int>(tracks.size()); ++q) {
    for (const Match& match : tracks[q].matches) {
      by_feature[match.feature].owner = q;
      by_feature[match.feature].landmark = match.landmark;
    }
  }
  std::vector<FramePoint> points;
  for (int i = 0; i < static_cast<int>(by_feature.size()); ++i) {
    FramePoint point = by_feature[i];
    point.feature = i;
    const StereoFeature& feature = view.frame.features[i];
    const bool is_new = point.owner == kNoOwner;
    const bool is_far =
        view.camera.Disparity(feature.z_px) < view.options.tracking.min_disparity_px;
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
  return &map.live[point.owner].landmarks[point.landmark];
}

std::optional<RigidTransform> OwnerPose(int owner, FrameId frame, const ClusterMap& map) {
  if (owner == kSceneOwner) return RigidTransform();
  const ClusterState* state = FindState(map.live[owner], frame);
  if (!state) return std::nullopt;
  return state->world_from_object;
}

namespace {

// Minimum area that a depth range covers in its box, as a fraction of that of the most widely
// spread range; less is taken for part of something in front (chosen from 0, 0.3 and 0.5 on
// development rooms).
constexpr double kMinSpread = 0.5;

// Area of the rectangle around the points (at least one), px^2.
double Spread(const std::vector<int>& body, const std::vector<const CrfNode*>& inside) {
  const Eigen::Vector3d& first = inside[body.front()]->z_px;
  ImageBox around{first[0], first[1], first[0], first[1]};
  for (const int k : body) Include(inside[k]->z_px[0], inside[k]->z_px[1], around);
  return around.Width() * around.Height();
}

}  // namespace

std::vector<std::vector<int>> BodiesOfAllPoints::Candidates(const std::vector<double>& depths_m,
                                                            double) {
  if (static_cast<int>(depths_m.size()) < kModeMinPoints) return {};
  std::vector<int> all(depths_m.size());
  std::iota(all.begin(), all.end(), 0);
  return {all};
}

std::optional<CrfLabel::Extent> FindNewBody(const FrameView& view, NewBodyRule candidates_of,
                                            const ImageBox& box,
                                            const std::vector<FramePoint>& points,
                                            const std::vector<CrfNode>& nodes) {
  std::vector<const CrfNode*> inside;
  std::vector<double> depths_m;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].owner >= 0 || !box.Contains(nodes[i].z_px[0], nodes[i].z_px[1])) continue;
    inside.push_back(&nodes[i]);
    depths_m.push_back(nodes[i].p_in_camera.z());
  }
  const std::vector<std::vector<int>> candidates =
      candidates_of(depths_m, std::max(box.Width(), box.Height()) / view.camera.fx);
  if (candidates.empty()) return std::nullopt;
  std::vector<double> spreads;
  for (const std::vector<int>& body : candidates) spreads.push_back(Spread(body, inside));
  const double least = kMinSpread * *std::ranges::max_element(spreads);
  const auto chosen =
      std::ranges::find_if(spreads, [least](double spread) { return spread >= least; });
  const std::vector<int>& body = candidates[chosen - spreads.begin()];
  Eigen::Matrix3Xd columns(3, static_cast<Eigen::Index>(body.size()));
  for (std::size_t k = 0; k < body.size(); ++k) {
    columns.col(static_cast<Eigen::Index>(k)) = inside[body[k]]->p_in_camera;
  }
  const PointExtent extent = ExtentAlong(Eigen::Matrix3d::Identity(), columns);
  return CrfLabel::Extent{extent.center, Eigen::Matrix3d::Identity(), extent.half_size_m};
}

}  // namespace cvo
