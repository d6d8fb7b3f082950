// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/labelling/landmark_update.h"

#include <algorithm>
#include <iterator>
#include <map>

#include "core/clustering/point_extent.h"
#include "core/clusters/trace_back.h"
#include "core/estimation/camera_solver.h"

namespace cvo {

namespace {

// Category of a body that is known from given labels alone, without a detection.
constexpr const char* kUnknownCategory = "object";

Eigen::Matrix3Xd PointsOf(ClusterId id, const FrameView& view,
                          const std::vector<FramePoint>& points, const FrameLabels& labels) {
  std::vector<Eigen::Vector3d> members;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (labels.points[i].cluster != id) continue;
    const auto p_in_camera = view.camera.BackProject(view.frame.features[points[i].feature].z_px);
    if (p_in_camera) members.push_back(view.world_from_camera * *p_in_camera);
  }
  Eigen::Matrix3Xd columns(3, static_cast<Eigen::Index>(members.size()));
  for (std::size_t k = 0; k < members.size(); ++k) {
    columns.col(static_cast<Eigen::Index>(k)) = members[k];
  }
  return columns;
}

Cluster CreateCluster(const FrameView& view, FrameId newest, const FrameLabels::Birth& birth,
                      const Eigen::Matrix3Xd& members) {
  Cluster cluster;
  cluster.id = birth.id;
  cluster.given_body = birth.given_body;
  cluster.category = kUnknownCategory;
  cluster.last_observed = newest;
  if (birth.detection >= 0) {
    const Detection& detection = view.shown.detections[birth.detection];
    cluster.category = detection.category;
    cluster.detections = 1;
    cluster.score = detection.score;
    cluster.last_detected = newest;
  }
  cluster.states.push_back(
      {newest, view.frame.timestamp_ns, PrincipalAxes(members), Eigen::Vector3d::Zero()});
  return cluster;
}

}  // namespace

void CreateClusters(const FrameView& view, FrameId newest, const std::vector<FramePoint>& points,
                    const FrameLabels& labels, ClusterMap& map) {
  for (const FrameLabels::Birth& birth : labels.births) {
    map.live.push_back(
        CreateCluster(view, newest, birth, PointsOf(birth.id, view, points, labels)));
    map.next.value = birth.id.value + 1;
  }
}

namespace {

// The static scene, or a cluster that has a pose in the entering frame and can therefore receive
// landmarks.
struct Target {
  int owner = kSceneOwner;
  RigidTransform world_from_object;
  std::vector<Landmark>* landmarks = nullptr;
  std::vector<Landmark> arriving = {};
  std::vector<char> is_leaving = {};
};

// Adds the feature as the landmark's observation in the frame.
void Observe(const FrameView& view, const WindowFrame& frame, const Target& target,
             const StereoFeature& feature, double depth_m, Landmark& landmark) {
  // The first observation is the reference itself, hence as accurate as those aligned with it.
  const bool is_aligned =
      feature.is_aligned || (view.options.tracking.align_patches && landmark.observations.empty());
  landmark.observations.push_back(
      {frame.id, feature.z_px, feature.octave, is_aligned, feature.disagreement_px});
  landmark.descriptor = feature.descriptor;
  landmark.depth_m = std::max(depth_m, StereoCamera::kMinDepth_m);
  landmark.last_octave = feature.octave;
  landmark.last_seen = frame.id;
  UpdateReference(view.options.orb.scale_factor, feature, landmark);
  if (target.owner == kSceneOwner) return;

  const RigidTransform object_from_camera =
      target.world_from_object.Inverse() * frame.world_from_camera;
  if (IsLeftOnly(feature)) return;
  const Eigen::Matrix3d in_camera = view.camera.PointCovariance(
      feature.z_px, view.options.NoiseOfFeatures().Covariance(feature.octave));
  const double determinant = in_camera.determinant();
  if (determinant >= landmark.covariance.determinant) return;
  const Eigen::Matrix3d R = object_from_camera.RotationMatrix();
  landmark.covariance = {R * in_camera * R.transpose(), determinant};
}

double DepthIn(const WindowFrame& frame, const Target& target, const Landmark& landmark) {
  return (frame.world_from_camera.Inverse() * (target.world_from_object * landmark.p_in_object))
      .z();
}

// Returns those of the landmark's observations that the target's motion explains.
std::vector<Observation> Agreeing(const FrameView& view, const Window& window,
                                  const ClusterMap& map, const Target& target,
                                  const Landmark& landmark,
                                  const std::vector<Observation>& observations) {
  const FeatureNoise noise = view.options.NoiseOfFeatures();
  std::vector<Observation> agreeing;
  for (const Observation& seen : observations) {
    const WindowFrame* frame = window.Find(seen.frame);
    const auto pose = frame ? OwnerPose(target.owner, seen.frame, map) : std::nullopt;
    if (!pose) continue;
    const PointMeasurement m{*pose * landmark.p_in_object, seen.z_px, noise.SqrtInformation(seen)};
    const auto error = WhitenedError(view.camera, m, frame->world_from_camera.Inverse());
    if (error && error->squaredNorm() <= noise.options.gate) agreeing.push_back(seen);
  }
  return agreeing;
}

// Returns the triangulated feature as a landmark of the target, without observations; empty if it
// cannot be triangulated.
std::optional<Landmark> MakeLandmark(const FrameView& view, const WindowFrame& frame,
                                     const Target& target, const StereoFeature& feature) {
  const auto p_in_camera = view.camera.BackProject(feature.z_px);
  if (!p_in_camera) return std::nullopt;
  Landmark landmark;
  landmark.p_in_object =
      target.world_from_object.Inverse() * (frame.world_from_camera * *p_in_camera);
  return landmark;
}

// Enters the frame's points into the landmarks of their bodies, one at a time.
class Updater {
 public:
  Updater(const FrameView& view, const WindowFrame& entering,
          const std::vector<ClusterTrack>& tracks, Window& window, ClusterMap& map)
      : view_(view), entering_(entering), window_(window), map_(map) {
    AddTarget(kStaticScene, {kSceneOwner, RigidTransform(), &window.landmarks});
    for (int q = 0; q < static_cast<int>(map.live.size()); ++q) {
      Cluster& cluster = map.live[q];
      // Clusters born in this frame have no track; their pose is that of their only state.
      const bool is_new = q >= static_cast<int>(tracks.size());
      if (!is_new && !tracks[q].is_tracked) continue;
      const RigidTransform& pose =
          is_new ? cluster.Latest().world_from_object : tracks[q].world_from_object;
      AddTarget(cluster.id, {q, pose, &cluster.landmarks});
    }
  }

  // Creates a landmark for a feature without one. False if the body of its label cannot receive it
  // or the feature cannot be triangulated.
  bool Create(const StereoFeature& feature, const LabelState& label, LandmarkId id) {
    Target* to = Find(label.cluster);
    std::optional<Landmark> landmark;
    if (to) landmark = MakeLandmark(view_, entering_, *to, feature);
    if (!landmark) return false;
    landmark->id = id;
    landmark->label = label;
    Arrive(feature, std::move(*landmark), *to);
    return true;
  }

  void Update(const FramePoint& point, const StereoFeature& feature, const LabelState& label) {
    const ClusterId owner = point.owner < 0 ? kStaticScene : map_.live[point.owner].id;
    Target* from = Find(owner);
    Require(from != nullptr, "UpdateLandmarks: a cluster without a pose has matches");
    Landmark& landmark = (*from->landmarks)[point.landmark];
    if (label.cluster == owner) {
      landmark.label = label;
    } else {
      // The position of a left-only feature on another body is unknown.
      if (IsLeftOnly(feature)) return;
      Target* to = Find(label.cluster);
      // If the new body cannot receive it, the landmark stays; if it belongs to no body, it is
      // removed.
      if (to || !label.cluster.valid()) {
        from->is_leaving[point.landmark] = 1;
        if (to) Move(landmark, feature, label, *to);
        return;
      }
    }
    Observe(view_, entering_, *from, feature, DepthIn(entering_, *from, landmark), landmark);
  }

  void ApplyMoves() {
    for (auto& [id, target] : targets_) {
      std::vector<Landmark>& landmarks = *target.landmarks;
      std::size_t kept = 0;
      for (std::size_t i = 0; i < landmarks.size(); ++i) {
        if (target.is_leaving[i]) continue;
        if (kept != i) landmarks[kept] = std::move(landmarks[i]);
        ++kept;
      }
      landmarks.resize(kept);
      std::ranges::move(target.arriving, std::back_inserter(landmarks));
      std::ranges::sort(landmarks, {}, &Landmark::id);
    }
  }

 private:
  void AddTarget(ClusterId id, Target target) {
    target.is_leaving.resize(target.landmarks->size(), 0);
    targets_[id] = std::move(target);
  }

  Target* Find(ClusterId id) {
    const auto it = targets_.find(id);
    return it == targets_.end() ? nullptr : &it->second;
  }

  void Move(const Landmark& old, const StereoFeature& feature, const LabelState& label,
            Target& to) {
    std::optional<Landmark> moved = MakeLandmark(view_, entering_, to, feature);
    if (!moved) return;
    moved->id = old.id;
    moved->label = label;
    moved->reference = old.reference;
    moved->observations = Agreeing(view_, window_, map_, to, *moved, old.observations);
    Arrive(feature, std::move(*moved), to);
  }

  void Arrive(const StereoFeature& feature, Landmark landmark, Target& to) {
    Observe(view_, entering_, to, feature, DepthIn(entering_, to, landmark), landmark);
    to.arriving.push_back(std::move(landmark));
  }

  const FrameView& view_;
  const WindowFrame& entering_;
  const Window& window_;
  const ClusterMap& map_;
  std::map<ClusterId, Target> targets_;
};

}  // namespace

int UpdateLandmarks(const FrameView& view, const WindowFrame& entering,
                    const std::vector<ClusterTrack>& tracks, const std::vector<FramePoint>& points,
                    FrameLabels& labels, LandmarkId& next_id, Window& window, ClusterMap& map) {
  Updater updater(view, entering, tracks, window, map);
  int added = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const StereoFeature& feature = view.frame.features[points[i].feature];
    LandmarkReport& report = labels.points[i];
    const LabelState assigned{report.cluster, report.confidence};
    if (const Landmark* landmark = FindLandmark(points[i], window, map)) {
      report.id = landmark->id;
      updater.Update(points[i], feature, assigned);
    } else if (updater.Create(feature, assigned, next_id)) {
      report.id = next_id;
      ++next_id.value;
      ++added;
    }
  }
  updater.ApplyMoves();
  return added;
}

void RemoveUnconfirmed(FrameId newest, std::vector<Landmark>& landmarks) {
  constexpr int kLostFrames = 3;
  std::erase_if(landmarks, [&](const Landmark& landmark) {
    return landmark.observations.size() == 1 &&
           landmark.last_seen.value <= newest.value - kLostFrames &&
           landmark.past_information.isZero();
  });
}

}  // namespace cvo
