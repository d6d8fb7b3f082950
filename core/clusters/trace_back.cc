// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clusters/trace_back.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/lists.h"
#include "core/clusters/cluster_prediction.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

namespace {

// The reference is renewed if the scales differ by more than this factor.
constexpr double kMaxZoom = 1.25;
// Patches whose scales differ by more than this factor are not compared: samples would leave them.
constexpr double kMaxComparedZoom = 1.5;

double LevelScale(double scale_factor, const StereoFeature& feature) {
  return std::pow(scale_factor, feature.octave);
}

bool IsWithin(double zoom, double limit) { return zoom <= limit && zoom * limit >= 1.0; }

}  // namespace

void AlignToLandmarks(double scale_factor, const RigidTransform& camera_from_object,
                      const std::vector<Landmark>& landmarks, const std::vector<Match>& matches,
                      std::span<StereoFeature> features) {
  for (const Match& match : matches) {
    const Landmark& landmark = landmarks[match.landmark];
    StereoFeature& feature = features[match.feature];
    feature.is_aligned = false;  // it may have been aligned with another landmark
    const double depth_m = (camera_from_object * landmark.p_in_object).z();
    const double scale = LevelScale(scale_factor, feature);
    const double zoom =
        landmark.reference.size_m / (std::max(depth_m, StereoCamera::kMinDepth_m) * scale);
    if (!IsWithin(zoom, kMaxComparedZoom)) continue;
    const auto shift = AlignFeaturePatch(landmark.reference.patch, feature.patch, zoom);
    if (!shift) continue;
    feature.patch.corner_u += static_cast<float>(shift->x());
    feature.patch.corner_v += static_cast<float>(shift->y());
    feature.z_px += scale * Eigen::Vector3d(shift->x(), shift->y(), shift->x());
    feature.is_aligned = true;
  }
}

void UpdateReference(double scale_factor, const StereoFeature& feature, Landmark& landmark) {
  const double size_m = landmark.depth_m * LevelScale(scale_factor, feature);
  const bool is_kept = feature.is_aligned && IsWithin(landmark.reference.size_m / size_m, kMaxZoom);
  if (!is_kept) landmark.reference = {feature.patch, size_m};
}

namespace {

bool WasTracked(const ClusterTrajectory& trajectory, FrameId frame) {
  const auto pose = FirstPoseFrom(frame.value, trajectory);
  return pose != trajectory.poses.end() && pose->frame == frame.value &&
         pose->status == ClusterStatus::kTracked;
}

auto FirstStateAfter(FrameId frame, auto& states) {
  return std::find_if(states.begin(), states.end(),
                      [frame](const ClusterState& state) { return frame < state.frame; });
}

// Keeps the observations sorted by frame, oldest first.
void InsertObservation(const Observation& seen, Landmark& landmark) {
  const auto later = std::find_if(landmark.observations.begin(), landmark.observations.end(),
                                  [&](const Observation& o) { return seen.frame < o.frame; });
  landmark.observations.insert(later, seen);
}

// Inserts a copy of the next pose with the values that the kept frame determines.
void InsertPose(const KeptFrame& kept, const ClusterTrack& track, ClusterTrajectory& trajectory) {
  auto at = FirstPoseFrom(kept.id.value, trajectory);
  if (at != trajectory.poses.end() && at->frame == kept.id.value) at = trajectory.poses.erase(at);
  if (at == trajectory.poses.end()) return;
  ClusterPose pose = *at;
  pose.frame = kept.id.value;
  pose.timestamp_ns = kept.frame.timestamp_ns;
  pose.status = ClusterStatus::kTracked;
  pose.world_from_object = track.world_from_object;
  pose.velocity_m_s = track.predicted.velocity_m_s;
  pose.observed_landmarks = static_cast<int>(track.matches.size());
  pose.detection = -1;
  pose.score *= ClusterOptions::kScoreDecay;
  trajectory.poses.insert(at, pose);
}

// Returns the first frame of T_t since which the cluster has been tracked without a gap; invalid if
// it is not tracked in the newest frame.
FrameId FirstTracked(const Window& window, const Cluster& cluster) {
  FrameId first;
  for (auto frame = window.temporal.rbegin(); frame != window.temporal.rend(); ++frame) {
    if (!FindState(cluster, frame->id)) break;
    first = frame->id;
  }
  return first;
}

// Returns the frames of T_t before FirstTracked, latest first, back to the last one in which the
// cluster was tracked, which is excluded. Empty unless the search is due.
std::vector<FrameId> FramesToTrace(const ClusterOptions& options, const Window& window,
                                   const ClusterTrajectory& trajectory, const Cluster& cluster) {
  const FrameId first = FirstTracked(window, cluster);
  if (options.trace_states == 0 || !first.valid() || !IsConfirmed(cluster, options)) return {};
  std::vector<FrameId> frames;
  int states = 0;
  for (auto frame = window.temporal.rbegin(); frame != window.temporal.rend(); ++frame) {
    if (first <= frame->id) {
      ++states;
      continue;
    }
    if (FindState(cluster, frame->id) || WasTracked(trajectory, frame->id)) break;
    frames.push_back(frame->id);
  }
  if (states < options.trace_states || cluster.lost_before == first) frames.clear();
  return frames;
}

// Predicts the cluster in an earlier frame from the next two states after it, which are the last
// two when time is reversed.
PredictedCluster PredictBack(const PredictorAnytime& predict, const Cluster& cluster,
                             const KeptFrame& kept) {
  const auto next = FirstStateAfter(kept.id, cluster.states);
  Cluster reversed;
  reversed.frames = cluster.frames;
  for (auto state = std::min(next + 2, cluster.states.end()); state != next;) {
    ClusterState seen = *--state;
    seen.timestamp_ns = -seen.timestamp_ns;
    seen.velocity_m_s = -seen.velocity_m_s;
    reversed.states.push_back(seen);
  }
  PredictedCluster predicted = predict(reversed, -kept.frame.timestamp_ns);
  predicted.velocity_m_s = -predicted.velocity_m_s;
  return predicted;
}

// Tracks the cluster in an earlier frame. Empty if too few matches agree or if their pose
// contradicts the prediction. Otherwise the inliers' features are placed (PlaceFeatures) and marked
// as taken in `kept`, as in the newest frame.
std::optional<ClusterTrack> TrackInPast(const FrameView& view, LandmarkSearch& find,
                                        const Cluster& cluster, const PredictedCluster& predicted,
                                        Rng& rng, KeptFrame& kept) {
  std::vector<PredictedLandmark> landmarks;
  PredictLandmarksOf(view, cluster, 0, predicted, landmarks);
  std::vector<Match> matches = FindLandmarks(view, find, landmarks, kept.taken);
  std::erase_if(matches, [&](const Match& m) { return !IsAllowed(view, cluster, m.feature); });
  for (Match& match : matches) match.landmark = landmarks[match.landmark].landmark;
  const auto solution = SolvePose(view, cluster, predicted.world_from_object, matches,
                                  view.options.clusters.min_tracked, true, rng);
  if (!solution) return std::nullopt;
  const RigidTransform world_from_object =
      view.world_from_camera * solution->world_from_camera.Inverse();
  if (!AgreesWithPrediction(predicted, world_from_object, view.options.noise.gate)) {
    return std::nullopt;
  }
  ClusterTrack track;
  track.predicted = predicted;
  AcceptPose(view, matches, *solution, kept.taken, track);
  PlaceFeatures(view, cluster, track, kept.frame.features);
  return track;
}

// Adds the state, the observations and the reported pose of an earlier frame.
void AddPast(const KeptFrame& kept, const ClusterTrack& track, Cluster& cluster,
             ClusterTrajectory& trajectory) {
  for (const Match& match : track.matches) {
    const StereoFeature& feature = kept.frame.features[match.feature];
    InsertObservation(
        {kept.id, feature.z_px, feature.octave, feature.is_aligned, feature.disagreement_px},
        cluster.landmarks[match.landmark]);
  }
  cluster.states.insert(
      FirstStateAfter(kept.id, cluster.states),
      {kept.id, kept.frame.timestamp_ns, track.world_from_object, track.predicted.velocity_m_s});
  ++cluster.frames;
  InsertPose(kept, track, trajectory);
}

}  // namespace

void TraceBack(const TraceBackStep& step, std::deque<KeptFrame>& kept_frames, ClusterMap& map,
               Rng& rng) {
  const Window& window = step.window;
  for (Cluster& cluster : map.live) {
    ClusterTrajectory& trajectory = map.trajectories[cluster.id];
    for (const FrameId id : FramesToTrace(step.options.clusters, window, trajectory, cluster)) {
      KeptFrame* kept = FindBy(kept_frames, &KeptFrame::id, id);
      if (kept == nullptr) break;
      const FeatureGrid grid(kept->frame.features, window.camera);
      const FrameView view{kept->frame,
                           step.show(kept->frame),
                           grid,
                           window.camera,
                           window.Find(id)->world_from_camera,
                           step.options};
      const auto track = TrackInPast(view, *step.find, cluster,
                                     PredictBack(step.predict, cluster, *kept), rng, *kept);
      if (!track) {
        cluster.lost_before = FirstTracked(window, cluster);
        break;
      }
      AddPast(*kept, *track, cluster, trajectory);
    }
  }
}

}  // namespace cvo
