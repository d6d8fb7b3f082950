// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/labelling/new_bodies.h"

#include <algorithm>
#include <numeric>
#include <utility>

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

// A detection that no cluster claims, and the points chosen as its body so far.
struct OpenBox {
  int detection = 0;
  ImageBox box;
  double angular_size = 0.0;
  std::vector<int> body;  // indices into the points
  double fill = 0.0;      // Fill of these points, in [0, 1]
};

// Minimum image area covered by the foreground of a new box, as a fraction of the area covered by
// the most widely spread depth range; less is taken for part of something in front (chosen
// from 0, 0.3 and 0.5 on development rooms).
constexpr double kMinFill = 0.5;

// How much of the box the points (at least one) are spread over: intersection over union of the
// rectangle around them and the box, in [0, 1].
double Fill(const ImageBox& box, const std::vector<int>& body, const std::vector<CrfNode>& nodes) {
  const Eigen::Vector3d& first = nodes[body.front()].z_px;
  ImageBox spread{first[0], first[1], first[0], first[1]};
  for (const int i : body) Include(nodes[i].z_px[0], nodes[i].z_px[1], spread);
  return IntersectionOverUnion(spread, box);
}

std::vector<OpenBox> OpenBoxes(const FrameView& view, const std::vector<char>& is_claimed) {
  std::vector<OpenBox> open;
  for (int m = 0; m < static_cast<int>(is_claimed.size()); ++m) {
    const ImageBox& box = view.shown.detections[m].box;
    if (is_claimed[m]) continue;
    open.push_back({m, box, std::max(box.Width(), box.Height()) / view.camera.fx, {}});
  }
  return open;
}

void ChooseBody(const NewBodyRule& rule, const std::vector<CrfNode>& nodes,
                const std::vector<char>& is_taken, OpenBox& box) {
  std::vector<int> inside;
  std::vector<double> depths;
  for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
    if (is_taken[i] || !box.box.Contains(nodes[i].z_px[0], nodes[i].z_px[1])) continue;
    inside.push_back(i);
    depths.push_back(nodes[i].p_in_camera.z());
  }
  std::vector<std::vector<int>> candidates = rule.candidates(depths, box.angular_size);
  std::vector<double> fills;
  for (std::vector<int>& body : candidates) {
    for (int& k : body) k = inside[k];
    fills.push_back(Fill(box.box, body, nodes));
  }
  box.body.clear();
  box.fill = 0.0;
  if (candidates.empty()) return;
  const double least = kMinFill * *std::max_element(fills.begin(), fills.end());
  const auto chosen =
      std::find_if(fills.begin(), fills.end(), [least](double fill) { return fill >= least; });
  box.body = std::move(candidates[static_cast<std::size_t>(chosen - fills.begin())]);
  box.fill = *chosen;
}

// Resolves shared points: processes the boxes in the order of how well their points fill them, and
// lets each later box that shares points with an earlier one choose anew without them.
void ShareOut(const NewBodyRule& rule, const std::vector<CrfNode>& nodes,
              std::vector<char> is_taken, std::vector<OpenBox>& open) {
  for (auto next = open.begin(); next != open.end(); ++next) {
    std::iter_swap(next, std::max_element(next, open.end(), [](const OpenBox& a, const OpenBox& b) {
                     return a.fill < b.fill;
                   }));
    for (const int i : next->body) is_taken[i] = 1;
    for (auto other = next + 1; other != open.end(); ++other) {
      const bool loses = std::any_of(other->body.begin(), other->body.end(),
                                     [&](int i) { return is_taken[i] != 0; });
      if (loses) ChooseBody(rule, nodes, is_taken, *other);
    }
  }
}

CrfLabel::Extent ExtentOf(const std::vector<int>& body, const std::vector<CrfNode>& nodes) {
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(body.size()));
  for (std::size_t k = 0; k < body.size(); ++k) {
    points.col(static_cast<Eigen::Index>(k)) = nodes[body[k]].p_in_camera;
  }
  const PointExtent extent = ExtentAlong(Eigen::Matrix3d::Identity(), points);
  return {extent.center, Eigen::Matrix3d::Identity(), extent.half_size_m};
}

}  // namespace

std::vector<std::vector<int>> BodiesOfAllPoints::Candidates(const std::vector<double>& depths_m,
                                                            double) {
  if (static_cast<int>(depths_m.size()) < kModeMinPoints) return {};
  std::vector<int> all(depths_m.size());
  std::iota(all.begin(), all.end(), 0);
  return {all};
}

std::vector<std::optional<CrfLabel::Extent>> FindNewBodies(const FrameView& view,
                                                           const NewBodyRule& rule,
                                                           const std::vector<char>& is_claimed,
                                                           const std::vector<FramePoint>& points,
                                                           const std::vector<CrfNode>& nodes) {
  std::vector<char> is_taken;
  for (const FramePoint& point : points) {
    is_taken.push_back(point.owner >= 0);
  }
  std::vector<OpenBox> open = OpenBoxes(view, is_claimed);
  for (OpenBox& box : open) ChooseBody(rule, nodes, is_taken, box);
  if (!rule.shares_points) ShareOut(rule, nodes, is_taken, open);
  std::vector<std::optional<CrfLabel::Extent>> bodies(is_claimed.size());
  for (const OpenBox& box : open) {
    if (!box.body.empty()) bodies[box.detection] = ExtentOf(box.body, nodes);
  }
  return bodies;
}

}  // namespace cvo
