// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/labelling/cluster_labels.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/base/lists.h"

namespace cvo {

namespace {

// Points of the static scene may be at infinity or, by noise, beyond it. Smaller disparities are
// raised to this value.
constexpr double kLeastDisparity_px = 0.1;

// The frame `frames` before the current one, t'; null if the window does not contain it.
const WindowFrame* FindPastFrame(const Window& window, int frames) {
  if (window.temporal.empty()) return nullptr;
  return window.Find(FrameId{window.temporal.back().id.value + 1 - frames});
}

CrfNode MakeNode(const FrameView& view, const FeatureNoise& noise, const FramePoint& point,
                 const Landmark* landmark, const WindowFrame* past) {
  const StereoFeature& feature = view.frame.features[point.feature];
  CrfNode node;
  node.z_px = feature.z_px;
  node.z_px[2] -= std::max(0.0, kLeastDisparity_px - view.camera.Disparity(feature.z_px));
  if (const auto p = view.camera.BackProject(node.z_px)) node.p_in_camera = *p;
  node.covariance_m2 = view.camera.PointCovariance(node.z_px, noise.Covariance(feature.octave));
  const Observation* seen = landmark && past ? FindObservation(*landmark, past->id) : nullptr;
  if (seen) node.past = CrfNode::Past{seen->z_px, noise.Covariance(seen->octave)};
  return node;
}

// Returns past_camera_from_object(then) * object_from_camera(now).
std::optional<RigidTransform> PastFromNow(const FrameView& view, int owner,
                                          const RigidTransform& world_from_object,
                                          const ClusterMap& map, const WindowFrame* past) {
  const auto then = past ? OwnerPose(owner, past->id, map) : std::nullopt;
  if (!then) return std::nullopt;
  return past->world_from_camera.Inverse() * *then * world_from_object.Inverse() *
         view.world_from_camera;
}

// Raises the half sides to at least `box_half_size` of the mean side of the box: a body fills its
// box even if all its landmarks so far are on one part of it.
void GrowToBox(const StereoCamera& camera, double box_half_size, const ImageBox& box,
               CrfLabel::Extent& extent) {
  const double side_px = 0.5 * (box.Width() + box.Height());
  const double side_m = extent.center_in_camera.z() * side_px / camera.fx;
  extent.half_size_m = extent.half_size_m.cwiseMax(box_half_size * side_m);
}

CrfLabel ClusterLabel(const FrameView& view, int q, const ClusterMap& map,
                      const ClusterTrack& track, const WindowFrame* past) {
  const Cluster& cluster = map.live[q];
  const RigidTransform camera_from_object =
      view.world_from_camera.Inverse() * track.world_from_object;
  CrfLabel label;
  label.kind = LabelKind::kCluster;
  label.cluster = cluster.id;
  label.detection = track.detection;
  label.given_body = cluster.given_body;
  if (track.detection >= 0) {
    label.box = view.shown.detections[track.detection].box;
  } else if (track.box.Width() > 0.0) {
    label.predicted_box = track.box;
  }
  label.extent = CrfLabel::Extent{camera_from_object * cluster.center_in_object,
                                  camera_from_object.RotationMatrix(), cluster.half_size_m};
  const auto& box = label.box ? label.box : label.predicted_box;
  if (box) GrowToBox(view.camera, view.options.clusters.box_half_size, *box, *label.extent);
  if (track.is_tracked) {
    label.past_from_now = PastFromNow(view, q, track.world_from_object, map, past);
  }
  return label;
}

// Adds a label for each body that occurs in the given labels of features and has no label yet.
void AddGivenBodies(const FrameView& view, std::vector<CrfLabel>& labels) {
  const std::span<const BodyId> bodies = view.shown.feature_body;
  for (const BodyId body : std::set<BodyId>(bodies.begin(), bodies.end())) {
    if (body <= kStaticBody || FindBy(labels, &CrfLabel::given_body, body) != nullptr) continue;
    labels.push_back({.kind = LabelKind::kNewBox, .given_body = body});
  }
}

}  // namespace

CrfScene BuildCrfScene(const FrameView& view, NewBodyRule new_body, const Window& window,
                       const ClusterMap& map, const std::vector<ClusterTrack>& tracks,
                       const std::vector<FramePoint>& points) {
  const WindowFrame* past = FindPastFrame(window, view.options.unary.past_frames);
  const RigidTransform camera_from_world = view.world_from_camera.Inverse();
  CrfScene scene;
  scene.camera = view.camera;
  for (const FramePoint& point : points) {
    const Landmark* landmark = FindLandmark(point, window, map);
    scene.nodes.push_back(MakeNode(view, view.options.NoiseOfFeatures(), point, landmark, past));
    if (!landmark) continue;
    const RigidTransform camera_from_object =
        point.owner < 0 ? camera_from_world
                        : camera_from_world * tracks[point.owner].world_from_object;
    scene.nodes.back().estimate = CrfNode::Place{camera_from_object * landmark->p_in_object};
  }
  scene.labels.push_back(
      {.kind = LabelKind::kStatic,
       .cluster = kStaticScene,
       .given_body = kStaticBody,
       .past_from_now = PastFromNow(view, kSceneOwner, RigidTransform(), map, past)});
  std::vector<char> is_claimed(view.shown.detections.size(), 0);
  for (int q = 0; q < static_cast<int>(tracks.size()); ++q) {
    scene.labels.push_back(ClusterLabel(view, q, map, tracks[q], past));
    if (tracks[q].detection >= 0) is_claimed[tracks[q].detection] = 1;
  }
  for (int m = 0; m < static_cast<int>(is_claimed.size()); ++m) {
    if (is_claimed[m]) continue;
    const ImageBox& box = view.shown.detections[m].box;
    const auto extent = FindNewBody(view, new_body, box, points, scene.nodes);
    if (!extent) continue;
    const std::span<const BodyId> given = view.shown.detection_body;
    scene.labels.push_back({.kind = LabelKind::kNewBox,
                            .detection = m,
                            .given_body = given.empty() ? BodyId() : given[m],
                            .box = box,
                            .extent = extent});
  }
  AddGivenBodies(view, scene.labels);
  scene.labels.push_back({.kind = LabelKind::kOutlier});
  return scene;
}

namespace {

// Returns for each node the most probable label, or that of its given body if there is one.
std::vector<int> DecideLabels(const FrameView& view, const std::vector<FramePoint>& points,
                              const CrfScene& scene, const CrfResult& crf) {
  std::vector<int> labels = MostLikelyLabels(crf.q);
  const std::span<const BodyId> given = view.shown.feature_body;
  for (std::size_t i = 0; i < points.size() && !given.empty(); ++i) {
    const BodyId body = given[points[i].feature];
    if (!body.valid()) continue;
    labels[i] =
        static_cast<int>(FindBy(scene.labels, &CrfLabel::given_body, body) - scene.labels.data());
  }
  return labels;
}

// Returns for each label the cluster that it continues.
std::vector<ClusterId> ContinueClusters(const Window& window, const ClusterMap& map,
                                        const std::vector<FramePoint>& points,
                                        const CrfScene& scene, const std::vector<int>& decided) {
  std::vector<int> label_of_old;  // new points have no previous cluster
  std::vector<ClusterId> previous;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Landmark* landmark = FindLandmark(points[i], window, map);
    if (!landmark) continue;
    previous.push_back(landmark->label.cluster);
    label_of_old.push_back(decided[i]);
  }
  return MatchLabels(scene.labels, {label_of_old, previous});
}

// The report on a point, with the label that its landmark has so far or, without one, `inferred`.
LandmarkReport Unlabelled(const FrameView& view, const FramePoint& point, const Landmark* landmark,
                          ClusterId inferred) {
  const LabelState label = landmark ? landmark->label : LabelState{inferred, 1};
  LandmarkReport report;
  report.feature = point.feature;
  report.cluster = label.cluster;
  report.confidence = label.confidence;
  report.inferred = inferred;
  const auto p_in_camera = view.camera.BackProject(view.frame.features[point.feature].z_px);
  if (p_in_camera) report.p_in_world = view.world_from_camera * *p_in_camera;
  return report;
}

}  // namespace

void NameLabels(ClusterId next, const std::vector<CrfLabel>& crf_labels,
                std::vector<ClusterId>& cluster_of, FrameLabels& labels) {
  for (std::size_t l = 0; l < crf_labels.size(); ++l) {
    const CrfLabel& label = crf_labels[l];
    if (label.kind == LabelKind::kStatic || label.kind == LabelKind::kOutlier) continue;
    if (!cluster_of[l].valid()) {
      labels.births.push_back({next, label.detection, label.given_body});
      cluster_of[l] = next;
      ++next.value;
    } else if (cluster_of[l] != label.cluster) {
      labels.adoptions.push_back({cluster_of[l], label.detection});
    }
  }
}

void DropWeakBirths(int min_landmarks, const Window& window, const ClusterMap& map,
                    const std::vector<FramePoint>& points, FrameLabels& labels) {
  std::map<ClusterId, int> members;
  for (const LandmarkReport& label : labels.points) ++members[label.cluster];
  std::map<ClusterId, ClusterId> renamed;  // to consecutive ids, without dropped births
  std::vector<FrameLabels::Birth> kept;
  for (FrameLabels::Birth birth : labels.births) {
    const bool is_weak = members[birth.id] < min_landmarks;
    const ClusterId id{map.next.value + static_cast<std::int64_t>(kept.size())};
    renamed[birth.id] = is_weak ? ClusterId{} : id;
    birth.id = id;
    if (!is_weak) kept.push_back(birth);
  }
  labels.births = kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    LandmarkReport& label = labels.points[i];
    const auto found = renamed.find(label.inferred);
    if (found != renamed.end()) label.inferred = found->second;
    const auto assigned = renamed.find(label.cluster);
    if (assigned == renamed.end()) continue;
    label.cluster = assigned->second;
    if (assigned->second.valid()) continue;
    // The birth is dropped: a landmark stays with its previous owner, a new point becomes static.
    const Landmark* landmark = FindLandmark(points[i], window, map);
    label.cluster = landmark ? landmark->label.cluster : kStaticScene;
    label.confidence = 1;
  }
}

void AdoptDetections(const FrameLabels& labels, const ClusterMap& map,
                     std::vector<ClusterTrack>& tracks) {
  for (const FrameLabels::Adoption& adoption : labels.adoptions) {
    for (std::size_t q = 0; q < tracks.size(); ++q) {
      if (tracks[q].detection == adoption.detection) tracks[q].detection = -1;
      if (map.live[q].id == adoption.id) tracks[q].detection = adoption.detection;
    }
  }
  // A detection whose label became a new cluster no longer belongs to its previous cluster.
  for (const FrameLabels::Birth& birth : labels.births) {
    for (ClusterTrack& track : tracks) {
      if (birth.detection >= 0 && track.detection == birth.detection) track.detection = -1;
    }
  }
}

FrameLabels LabelPoints(const FrameView& view, const LabelSteps& steps, const Window& window,
                        const ClusterMap& map, const std::vector<ClusterTrack>& tracks,
                        const std::vector<FramePoint>& points, CrfMemory& memory) {
  FrameLabels labels;
  const auto landmark_of = [&](std::size_t i) { return FindLandmark(points[i], window, map); };
  if (tracks.empty() && view.shown.detections.empty() && view.shown.feature_body.empty()) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      labels.points.push_back(Unlabelled(view, points[i], landmark_of(i), kStaticScene));
    }
    return labels;
  }
  labels.scene = BuildCrfScene(view, steps.new_body, window, map, tracks, points);
  const CrfScene& scene = labels.scene;
  const EnergyMatrix unary = steps.unaries(scene, view.options.unary);
  const CrfResult crf = steps.infer(unary, MovingPlaces(scene), view.options.pairwise, memory);
  const std::vector<int> decided = DecideLabels(view, points, scene, crf);
  std::vector<ClusterId> cluster_of = ContinueClusters(window, map, points, scene, decided);
  NameLabels(map.next, scene.labels, cluster_of, labels);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Landmark* landmark = landmark_of(i);
    LandmarkReport label = Unlabelled(view, points[i], landmark, cluster_of[decided[i]]);
    if (landmark) {
      LabelState state = landmark->label;
      const bool is_removed = steps.adopt(label.inferred, state) == LabelOutcome::kRemove;
      label.cluster = is_removed ? ClusterId{} : state.cluster;
      label.confidence = state.confidence;
    }
    labels.points.push_back(label);
  }
  DropWeakBirths(view.options.clusters.min_landmarks, window, map, points, labels);
  return labels;
}

}  // namespace cvo
