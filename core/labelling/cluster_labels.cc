// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/labelling/cluster_labels.h"

#include <algorithm>
#include <map>
#include <set>

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
std::optional<RigidTransform> PastFromNow(const FrameView& view, PointOwner owner,
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

CrfLabel ClusterLabel(const FrameView& view, const ClusterOptions& options, int q,
                      const ClusterMap& map, const ClusterTrack& track, const WindowFrame* past) {
  const Cluster& cluster = map.live[q];
  const RigidTransform camera_from_object =
      view.world_from_camera.Inverse() * track.world_from_object;
  CrfLabel label;
  label.kind = LabelKind::kCluster;
  if (track.detection >= 0) {
    label.box = view.shown.detections[track.detection].box;
  } else if (track.box.Width() > 0.0) {
    label.predicted_box = track.box;
  }
  label.extent = CrfLabel::Extent{camera_from_object * cluster.center_in_object,
                                  camera_from_object.RotationMatrix(), cluster.half_size_m};
  const auto& box = label.box ? label.box : label.predicted_box;
  if (box) GrowToBox(view.camera, options.box_half_size, *box, *label.extent);
  if (track.is_tracked) {
    label.past_from_now = PastFromNow(view, ClusterOwner(q), track.world_from_object, map, past);
  }
  return label;
}

// Adds a label for each body that occurs in the given labels of features and has no label yet.
void AddGivenBodies(const FrameView& view, LabelScene& scene) {
  const std::span<const BodyId> bodies = view.shown.feature_body;
  for (const BodyId body : std::set<BodyId>(bodies.begin(), bodies.end())) {
    const auto known = std::find(scene.given_body.begin(), scene.given_body.end(), body);
    if (body <= kStaticBody || known != scene.given_body.end()) continue;
    CrfLabel label;
    label.kind = LabelKind::kNewBox;
    scene.crf.labels.push_back(label);
    scene.detection.push_back(-1);
    scene.given_body.push_back(body);
  }
}

// Whether the detection shows a part of a body that is whole in the box of a cluster: detectors
// sometimes report both. `body` is what would be born from it.
bool IsPartOfCluster(const FrameView& view, double part_share, int detection,
                     const CrfLabel::Extent& body, const std::vector<ClusterTrack>& tracks,
                     const LabelScene& scene) {
  constexpr double kDeepestSides = 2.0;  // depth of a body relative to the sides of its box
  const Detection& part = view.shown.detections[detection];
  for (int q = 0; q < scene.clusters; ++q) {
    if (tracks[q].detection < 0) continue;
    const Detection& whole = view.shown.detections[tracks[q].detection];
    if (whole.category != part.category || ShareInside(part.box, whole.box) < part_share) continue;
    const double depth_m = scene.crf.labels[1 + q].extent->center_in_camera.z();
    const double side_m =
        depth_m * std::max(whole.box.Width(), whole.box.Height()) / view.camera.fx;
    if (std::abs(body.center_in_camera.z() - depth_m) < kDeepestSides * side_m) return true;
  }
  return false;
}

// Returns camera_from_object of the body that owns the point's landmark.
RigidTransform OwnerInCamera(const FrameView& view, const FramePoint& point,
                             const std::vector<ClusterTrack>& tracks) {
  const RigidTransform camera_from_world = view.world_from_camera.Inverse();
  if (point.owner.kind != PointOwner::Kind::kCluster) return camera_from_world;
  return camera_from_world * tracks[point.owner.cluster].world_from_object;
}

}  // namespace

LabelScene BuildLabelScene(const FrameView& view, const LabelSceneOptions& options,
                           const Window& window, const ClusterMap& map,
                           const std::vector<ClusterTrack>& tracks,
                           const std::vector<FramePoint>& points, const NewBodyRule& new_body) {
  const WindowFrame* past = FindPastFrame(window, options.unary.past_frames);
  LabelScene scene;
  scene.crf.camera = view.camera;
  for (const FramePoint& point : points) {
    const Landmark* landmark = FindLandmark(point, window, map);
    scene.crf.nodes.push_back(MakeNode(view, options.noise, point, landmark, past));
    if (!landmark) continue;
    scene.crf.nodes.back().estimate =
        CrfNode::Place{OwnerInCamera(view, point, tracks) * landmark->p_in_object};
  }
  CrfLabel still;
  still.kind = LabelKind::kStatic;
  still.past_from_now = PastFromNow(view, kSceneOwner, RigidTransform(), map, past);
  scene.crf.labels.push_back(still);

  std::vector<char> is_claimed(view.shown.detections.size(), 0);
  scene.clusters = static_cast<int>(tracks.size());
  scene.detection.push_back(-1);
  for (int q = 0; q < scene.clusters; ++q) {
    scene.crf.labels.push_back(ClusterLabel(view, options.clusters, q, map, tracks[q], past));
    scene.detection.push_back(tracks[q].detection);
    if (tracks[q].detection >= 0) is_claimed[tracks[q].detection] = 1;
  }
  scene.given_body.push_back(kStaticBody);
  for (const Cluster& cluster : map.live) scene.given_body.push_back(cluster.given_body);
  const std::vector<std::optional<CrfLabel::Extent>> bodies =
      FindNewBodies(view, {new_body, options.extent}, is_claimed, points, scene.crf.nodes);
  for (int m = 0; m < static_cast<int>(bodies.size()); ++m) {
    if (!bodies[m]) continue;
    if (IsPartOfCluster(view, options.extent.part_share, m, *bodies[m], tracks, scene)) continue;
    CrfLabel label;
    label.kind = LabelKind::kNewBox;
    label.box = view.shown.detections[m].box;
    label.extent = bodies[m];
    scene.crf.labels.push_back(label);
    scene.detection.push_back(m);
    const std::span<const BodyId> given = view.shown.detection_body;
    scene.given_body.push_back(given.empty() ? BodyId() : given[m]);
  }
  AddGivenBodies(view, scene);
  CrfLabel outlier;
  outlier.kind = LabelKind::kOutlier;
  scene.crf.labels.push_back(outlier);
  scene.detection.push_back(-1);
  scene.given_body.push_back(BodyId());
  return scene;
}

namespace internal {

std::vector<int> DecideLabels(const FrameView& view, const std::vector<FramePoint>& points,
                              const LabelScene& scene, const CrfResult& crf) {
  std::vector<int> labels = MostLikelyLabels(crf.q);
  const std::span<const BodyId> given = view.shown.feature_body;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (given.empty() || !given[points[i].feature].valid()) continue;
    labels[i] = static_cast<int>(
        std::find(scene.given_body.begin(), scene.given_body.end(), given[points[i].feature]) -
        scene.given_body.begin());
  }
  return labels;
}

DecidedLabels DescribeDecision(const Window& window, const ClusterMap& map,
                               const std::vector<FramePoint>& points, const LabelScene& scene,
                               const std::vector<int>& decided) {
  DecidedLabels result;
  for (std::size_t l = 0; l < scene.crf.labels.size(); ++l) {
    const CrfLabel& label = scene.crf.labels[l];
    LabelIdentity identity{label.kind, l == 0 ? kStaticScene : ClusterId{}};
    if (label.kind == LabelKind::kCluster) identity.cluster = map.live[l - 1].id;
    result.identities.push_back(identity);
  }
  // New points have no previous cluster.
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Landmark* landmark = FindLandmark(points[i], window, map);
    if (!landmark) continue;
    result.previous.push_back(landmark->label.cluster);
    result.label_of_old.push_back(decided[i]);
  }
  return result;
}

void NameLabels(const ClusterMap& map, const LabelScene& scene, std::vector<ClusterId>& cluster_of,
                FrameLabels& labels) {
  ClusterId next = map.next;
  for (int l = 1; l < scene.Outlier(); ++l) {
    const ClusterId own = scene.IsNewBox(l) ? ClusterId{} : map.live[l - 1].id;
    if (!cluster_of[l].valid()) {
      labels.births.push_back({next, scene.detection[l], scene.given_body[l]});
      cluster_of[l] = next;
      ++next.value;
    } else if (cluster_of[l] != own) {
      labels.adoptions.push_back({cluster_of[l], scene.detection[l]});
    }
  }
}

void DropWeakBirths(int min_landmarks, const Window& window, const ClusterMap& map,
                    const std::vector<FramePoint>& points, FrameLabels& labels) {
  std::map<ClusterId, int> members;
  for (const PointLabel& label : labels.points) ++members[label.assigned.cluster];
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
    PointLabel& label = labels.points[i];
    for (ClusterId* id : {&label.inferred, &label.second}) {
      const auto found = renamed.find(*id);
      if (found != renamed.end()) *id = found->second;
    }
    const auto assigned = renamed.find(label.assigned.cluster);
    if (assigned == renamed.end()) continue;
    label.assigned.cluster = assigned->second;
    if (assigned->second.valid()) continue;
    // The birth is dropped: a landmark stays with its previous owner, a new point becomes static.
    const Landmark* landmark = FindLandmark(points[i], window, map);
    label.assigned =
        landmark ? LabelState{landmark->label.cluster, 1} : LabelState{kStaticScene, 1};
  }
}

int SecondLabel(const EnergyMatrix& total, Eigen::Index node, int decided) {
  int second = decided == 0 ? 1 : 0;
  for (int label = 0; label < total.cols(); ++label) {
    if (label != decided && total(node, label) < total(node, second)) second = label;
  }
  return second;
}

FrameLabels AllStatic(const Window& window, const ClusterMap& map,
                      const std::vector<FramePoint>& points) {
  FrameLabels labels;
  for (const FramePoint& point : points) {
    const Landmark* landmark = FindLandmark(point, window, map);
    PointLabel label;
    label.inferred = kStaticScene;
    label.assigned = landmark ? landmark->label : LabelState{kStaticScene, 1};
    labels.points.push_back(label);
  }
  return labels;
}

}  // namespace internal

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

}  // namespace cvo
